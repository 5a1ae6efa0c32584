//! Contacts with friction on their way up the orders: what each order leaves them, and the motions that order 0 allows.

use super::{ContactProblem, Ladder};
use crate::contact::friction::{FrictionSolution, Frictional, Mode, Reason, Sense};
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
pub(super) struct Rubbing {
    pub(super) contact: usize,
    pub(super) frictional: Frictional,
    /// What it may do from the next order on, where its reaction is known to vanish at order 0.
    pub(super) later: Option<Frictional>,
    pub(super) mode: Mode,
}

impl Rubbing {
    /// The set with the slip of this contact, if it is closed in it.
    pub(super) fn slip(&self, set: ContactSet) -> ContactSet {
        let slip = match self.mode {
            Mode::Stick => Slip::Stick,
            Mode::Slide(Sense::Forward) => Slip::Forward,
            Mode::Slide(Sense::Backward) => Slip::Backward,
            Mode::Guide { side, sense } => {
                return set
                    .with(self.contact)
                    .slipping(self.contact, slip_of(sense))
                    .pressing(self.contact, side);
            }
            Mode::Open | Mode::Part(_) => return set,
        };
        if set.contains(self.contact) { set.slipping(self.contact, slip) } else { set }
    }
}

fn slip_of(sense: Option<Sense>) -> Slip {
    match sense {
        None => Slip::Stick,
        Some(Sense::Forward) => Slip::Forward,
        Some(Sense::Backward) => Slip::Backward,
    }
}

/// What a guide did in the phase before.
fn as_before(set: &ContactSet, contact: usize) -> Mode {
    let sense = match set.slip(contact) {
        Slip::Stick => None,
        Slip::Forward => Some(Sense::Forward),
        Slip::Backward => Some(Sense::Backward),
    };
    Mode::Guide { side: set.side(contact), sense }
}

impl Ladder {
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
                (true, false) => Frictional::decided(rows, coefficients, Mode::Open),
                // With N = 0 both sides have the same motion.
                (true, true) => {
                    Frictional::decided(rows, coefficients, as_before(&question.touching, contact))
                }
                (false, _) => touching.clone(),
            };
            let later = unloaded.then_some(touching);
            Some(Rubbing { contact, frictional, later, mode: Mode::Open })
        });
        self.rubbing = known.collect();
        Ok(())
    }

    /// The motions found at order 0, with what every contact does in them.
    pub(super) fn alternatives_of(&self, found: &FrictionSolution, candidates: &[usize]) -> Alternatives {
        let contacts = self.rubbing.iter().map(|rubbing| rubbing.contact).chain(candidates.iter().copied());
        let labels: Vec<&str> = contacts.map(|contact| self.layout.contacts[contact].label).collect();
        let rubbing = self.rubbing.len();
        let told = |modes: &Vec<Mode>| {
            let each = labels.iter().zip(modes).enumerate();
            let each: Vec<String> = each
                .map(|(k, (label, mode))| {
                    format!("{label} {}", if k < rubbing { mode.describe() } else { mode.told_smooth() })
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
