//! One touching contact with friction, where its motion is clearly decided. With W the Delassus
//! matrix of its normal and its tangent, w± = W_NN ± μ W_Nt, and g̈° without the contact,
//!
//! ```text
//! sliding in the sense σ:    w N = −g̈°,    w = W_NN − σ μ W_Nt
//! ```
//!
//! With w > 0 the sense that it slides in leaves one motion: closed where g̈° < 0, open where g̈° > 0.
//! At rest it has four modes: open, stick, and a slide in either sense. Where the conditions of one
//! are met and those of the others are not, that one follows, as it always does where w₊, w₋ > 0
//! and μ_s = μ: the complementarity problem is one of a P-matrix (Pfeiffer and Glocker, *Multibody
//! Dynamics with Unilateral Contacts*, 1996). Where several modes can follow, as between the cones
//! of μ and μ_s or in Painlevé's paradox, [`enumeration`](crate::contact::friction) finds and tells
//! them.

use super::solve;
use crate::contact::friction::{SlipDirection, SlipVelocity as KnownSlip};
use crate::contact::{ContactProblem, ContactSolution};
use crate::context::{Numbers, RunContext, slips};
use crate::model::{ContactKind, ContactSet, Slip, SlipState};
use crate::numerics::zero::MARGIN;
use crate::system::Equations;

/// The contact, and what is clearly not zero.
struct Contact<'a> {
    context: &'a RunContext,
    state: &'a [f64],
    /// Those at the state.
    equations: Equations<f64>,
    slip: SlipState<f64>,
    contact: usize,
    entry: usize,
    force: f64,
    acceleration: f64,
}

/// What follows if it slides or sticks.
struct ClosedSlider {
    set: ContactSet,
    reactions: Numbers,
    normal: f64,
    force: f64,
    /// v̇
    start: f64,
}

/// The decision, if this is such a case.
pub(crate) fn decide(
    context: &RunContext,
    state: &[f64],
    question: &ContactProblem,
) -> Option<ContactSolution> {
    let &[(contact, known)] = question.slips else { return None };
    let alone = question.touching.len() == 1 && question.touching.contains(contact);
    if !alone || !question.held.is_empty() || !question.unloaded.is_empty() {
        return None;
    }
    let layout = context.layout();
    let entry =
        layout.contacts[contact].friction.filter(|_| layout.contacts[contact].kind != ContactKind::Guide)?;
    // A coefficient below zero is refused elsewhere.
    let slip = slips(context.system(), state).get(entry).copied().filter(|slip| slip.kinetic >= 0.0)?;
    let equations = context.system().equations(state);
    let (force, acceleration) = (MARGIN * context.scales.force(), MARGIN * context.scales.acceleration());
    let contact = Contact { context, state, equations, slip, contact, entry, force, acceleration };
    let (falls, open) = contact.without()?;
    let found = match known {
        KnownSlip::Forward => contact.moving(Slip::Forward, falls)?,
        KnownSlip::Backward => contact.moving(Slip::Backward, falls)?,
        KnownSlip::Leaves(SlipDirection::Forward) => contact.leaving(Slip::Forward, falls)?,
        KnownSlip::Leaves(SlipDirection::Backward) => contact.leaving(Slip::Backward, falls)?,
        KnownSlip::Rest => contact.resting(falls)?,
    };
    let (closed, reactions) = found.map_or((ContactSet::EMPTY, open), |it| (it.set, it.reactions));
    let (bearing, reactions) = (closed, reactions.to_vec());
    Some(ContactSolution { closed, active_basis: bearing, reactions, unique: true, alternatives: None })
}

impl Contact<'_> {
    /// Whether the contact falls onto its support without a reaction, if that is clear.
    fn without(&self) -> Option<(bool, Numbers)> {
        let (accelerations, reactions) = solve(self.context, self.state, ContactSet::EMPTY)?;
        let opening = self.equations.gap_acceleration(self.contact, &accelerations);
        (opening.abs() > self.acceleration).then_some((opening < 0.0, reactions))
    }

    fn closed(&self, slip: Slip) -> Option<ClosedSlider> {
        let set = ContactSet::EMPTY.slipping(self.contact, slip);
        let (accelerations, reactions) = solve(self.context, self.state, set)?;
        let layout = self.context.layout();
        let row = layout.frictions[self.entry].row;
        let (normal, force) = (reactions[self.contact], reactions[layout.contacts.len() + self.entry]);
        let start = self.equations.gap_acceleration(row, &accelerations);
        Some(ClosedSlider { set, reactions, normal, force, start })
    }

    /// w > 0: what falls is pressed on while it slides so, what rises would be pulled at.
    fn is_held(&self, sliding: &ClosedSlider, falls: bool) -> bool {
        sliding.normal.abs() > self.force && (sliding.normal > 0.0) == falls
    }

    fn moving(&self, slip: Slip, falls: bool) -> Option<Option<ClosedSlider>> {
        let sliding = self.closed(slip)?;
        self.is_held(&sliding, falls).then_some(falls.then_some(sliding))
    }

    /// The same of one that its force of sticking lets go, which must begin to slide so.
    fn leaving(&self, slip: Slip, falls: bool) -> Option<Option<ClosedSlider>> {
        let starts = |it: &ClosedSlider| f64::from(slip.sign()) * it.start > self.acceleration;
        self.moving(slip, falls).filter(|closed| closed.as_ref().is_none_or(starts))
    }

    /// The only one of its modes whose conditions are met, if those of the others clearly are not.
    fn resting(&self, falls: bool) -> Option<Option<ClosedSlider>> {
        let mut found = (!falls).then_some(None);
        for slip in [Slip::Stick, Slip::Forward, Slip::Backward] {
            let closed = self.closed(slip)?;
            if self.is_met(slip, &closed)? && found.replace(Some(closed)).is_some() {
                return None;
            }
        }
        found
    }

    /// Whether the conditions of a mode from rest are met, if that is clear.
    fn is_met(&self, slip: Slip, closed: &ClosedSlider) -> Option<bool> {
        let second = match slip {
            Slip::Stick => (self.slip.limit * closed.normal - closed.force.abs()) / self.force,
            Slip::Forward | Slip::Backward => f64::from(slip.sign()) * closed.start / self.acceleration,
        };
        let least = second.min(closed.normal / self.force);
        (least.abs() > 1.0).then_some(least > 0.0)
    }
}

#[cfg(test)]
mod tests;
