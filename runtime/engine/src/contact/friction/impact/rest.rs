//! The end of a sequence of impacts: contacts keep closed by impulses of either sign, and those
//! with friction slip as they are said to.
//!
//! ```text
//! ġ⁺ = 0,    P_t = −σ μ P  sliding,    v⁺ = 0  sticking
//! ```
//!
//! Those that are present besides answer to it without restitution.

use super::super::super::impact::Stages;
use super::super::super::impulse::{Collision, CollisionError, Outcome};
use super::super::super::trials::Trials;
use super::super::modes::{ContactMode, Frictional, SlipDirection};
use super::ImpactFriction;
use super::at_once::SolutionFilter;
use crate::model::{self, ContactSet, Law};

impl Collision {
    /// The outcome with the contacts of a set closed.
    pub(crate) fn come_to_rest(
        &self,
        set: &ContactSet,
        most_trials: usize,
    ) -> Result<Outcome, CollisionError> {
        let rubbing: ContactSet = self.rubbing().iter().map(|it| it.normal).collect();
        let plastic = self.plastic(&set.difference(rubbing));
        let contacts: Vec<Frictional> = plastic.rubbing().iter().map(|it| resting(it, set)).collect();
        if contacts.is_empty() {
            return plastic.solve_within(most_trials);
        }
        plastic.check()?;
        let stages = Stages::new(&plastic, Trials::up_to(most_trials));
        let stage = stages.stage(&stages.approach, &contacts, SolutionFilter::Any)?;
        Ok(stages.outcome_of(stage, Law::Newton, None))
    }
}

fn resting(contact: &ImpactFriction, set: &ContactSet) -> Frictional {
    let (rows, mu) = ((contact.normal, contact.tangent), (contact.mu, contact.mu));
    if contact.is_guide || !set.contains(contact.normal) {
        return contact.at_rest();
    }
    let mode = match set.slip(contact.normal) {
        model::Slip::Stick => ContactMode::Stick,
        model::Slip::Forward => ContactMode::Slide(SlipDirection::Forward),
        model::Slip::Backward => ContactMode::Slide(SlipDirection::Backward),
    };
    Frictional::decided(rows, mu, mode)
}
