//! Contacts with friction on their way up the orders: what each order leaves them, and the motions
//! that order 0 allows.

use super::{ContactProblem, OrderLadder};
use crate::contact::friction::{ContactMode, FrictionSolution, Frictional, Reason, SlipDirection};
use crate::contact::{ContactError, refuse_negative_friction};
use crate::context::slips;
use crate::model::{ContactKind, ContactSet, Slip};
use crate::system::Model;

/// Motions that satisfy the law of friction at one state.
#[derive(Debug, Clone)]
pub(crate) struct Alternatives {
    /// What the contacts do in each.
    pub(crate) motions: Vec<String>,
    /// The one that is taken, and why.
    pub(crate) taken: usize,
    pub(crate) reason: Reason,
    /// Whether there are no others.
    pub(crate) complete: bool,
    /// Whether it does not depend on how redundant contacts share their load.
    pub(crate) determined: bool,
}

/// A contact with friction on its way up the orders.
pub(super) struct FrictionAtOrder {
    pub(super) contact: usize,
    pub(super) frictional: Frictional,
    /// What it may do from the next order on, where its reaction is known to vanish at order 0.
    pub(super) later: Option<Frictional>,
    pub(super) mode: ContactMode,
}

impl FrictionAtOrder {
    /// The set with the slip of this contact, if it is closed in it.
    pub(super) fn slip(&self, set: ContactSet) -> ContactSet {
        let slip = match self.mode {
            ContactMode::Stick => Slip::Stick,
            ContactMode::Slide(SlipDirection::Forward) => Slip::Forward,
            ContactMode::Slide(SlipDirection::Backward) => Slip::Backward,
            ContactMode::Guide { side, sense } => {
                return set
                    .with(self.contact)
                    .slipping(self.contact, slip_of(sense))
                    .pressing(self.contact, side);
            }
            ContactMode::Open | ContactMode::Part(_) => return set,
        };
        if set.contains(self.contact) { set.slipping(self.contact, slip) } else { set }
    }
}

fn slip_of(sense: Option<SlipDirection>) -> Slip {
    match sense {
        None => Slip::Stick,
        Some(SlipDirection::Forward) => Slip::Forward,
        Some(SlipDirection::Backward) => Slip::Backward,
    }
}

/// What a guide did in the phase before.
fn as_before(set: &ContactSet, contact: usize) -> ContactMode {
    let sense = match set.slip(contact) {
        Slip::Stick => None,
        Slip::Forward => Some(SlipDirection::Forward),
        Slip::Backward => Some(SlipDirection::Backward),
    };
    ContactMode::Guide { side: set.side(contact), sense }
}

impl OrderLadder {
    /// Takes in the contacts with friction, with their coefficients at a state.
    pub(super) fn rub(
        &mut self,
        model: &Model,
        state: &[f64],
        question: &ContactProblem,
    ) -> Result<(), ContactError> {
        if question.slips.is_empty() {
            return Ok(());
        }
        let (layout, slips) = (model.layout(), slips(&*model.system, state));
        refuse_negative_friction(layout, &slips, question.touching)?;
        let touching = question.slips.iter().filter(|(contact, _)| question.touching.contains(*contact));
        let known = touching.filter_map(|&(contact, slip)| {
            let entry = layout.contacts[contact].friction?;
            let rows = (contact, layout.frictions[entry].row);
            let coefficients = (slips[entry].kinetic, slips[entry].limit);
            let is_guide = layout.contacts[contact].kind == ContactKind::Guide;
            let touching = match is_guide {
                true => Frictional::guide(rows, coefficients, slip),
                false => Frictional::touching(rows, coefficients, slip),
            };
            let is_held = question.held.contains(contact) && !is_guide;
            let unloaded = question.unloaded.contains(contact) && !is_held;
            let frictional = match (unloaded, is_guide) {
                (true, false) => Frictional::decided(rows, coefficients, ContactMode::Open),
                // With N = 0 both sides have the same motion.
                (true, true) => {
                    Frictional::decided(rows, coefficients, as_before(&question.touching, contact))
                }
                (false, _) => touching.clone(),
            };
            let later = unloaded.then_some(touching);
            Some(FrictionAtOrder { contact, frictional, later, mode: ContactMode::Open })
        });
        self.rubbing = known.collect();
        Ok(())
    }

    /// The motions found at order 0, with what every contact does in them.
    pub(super) fn alternatives_of(&self, found: &FrictionSolution, candidates: &[usize]) -> Alternatives {
        let contacts = self.rubbing.iter().map(|rubbing| rubbing.contact).chain(candidates.iter().copied());
        let labels: Vec<&str> = contacts.map(|contact| self.layout.contacts[contact].label).collect();
        let rubbing = self.rubbing.len();
        let told = |modes: &Vec<ContactMode>| {
            let each = labels.iter().zip(modes).enumerate();
            let each: Vec<String> = each
                .map(|(k, (label, mode))| {
                    format!("{label} {}", if k < rubbing { mode.describe() } else { mode.describe_smooth() })
                })
                .collect();
            each.join(", ")
        };
        Alternatives {
            motions: found.solutions.iter().map(told).collect(),
            taken: found.taken,
            reason: found.reason,
            complete: found.complete,
            determined: found.determined,
        }
    }
}
