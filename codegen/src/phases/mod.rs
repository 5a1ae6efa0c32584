//! The equations of each contact set that has a closed form.
//!
//! The closed rows are solved for some coordinates, `q_e = q_e(q_k)`. With `u = G u_k` and
//! `a = G a_k + β`, the motion is `M̂ a_k + ĥ = Q̂`, `M̂ = Gᵀ M G`, `ĥ = Gᵀ (h + M β)`,
//! `Q̂ = Gᵀ Q`, and the reactions follow from the eliminated rows of the full equations,
//! `J_eᵀ λ = (M a + h − Q)_e`. The friction forces R of sliding contacts are loads in both: Q
//! contains `J_tᵀ R`, and `R = −σ μ N` closes the equations.

mod eliminate;
mod elimination;
mod reduction;
mod rules;
#[cfg(test)]
mod tests;

use crate::algebra::{Quotient, Series, work};
use crate::kinematics::{Kinematics, nominal_values};
use crate::motion::{ClosedSet, Dense, Motion, OpaqueTerm, SEARCHED};
use crate::system::System;

pub use elimination::{AngleBranch, CoordinateValue, Elimination};

/// Term operations for all closed forms; those that would need more are left to the projected form.
const WORK: u64 = 5_000_000;
/// In a closed form so many contacts slide at most: their reactions follow by Cramer's rule.
const SLIDING: usize = 2;

/// A contact set whose constraints are solved in closed form.
#[derive(Clone, Debug)]
pub struct Phase {
    /// The closed contacts.
    pub set: ClosedSet,
    /// The coordinates that stay.
    pub kept: Vec<usize>,
    /// Those of them whose rates stay.
    pub moving: Vec<usize>,
    /// The coordinates that follow, in order of elimination.
    pub eliminated: Vec<Elimination>,
    /// What the elimination divides by, where it is not constant.
    pub pivots: Vec<Series>,
    /// Every coordinate in terms of those kept; an eliminated angle is given by
    /// [`CoordinateValue::Angle`] only.
    pub coordinates: Vec<CoordinateValue>,
    /// Every rate.
    pub rates: Vec<Quotient>,
    /// Every acceleration, in terms of the kept ones.
    pub accelerations: Vec<Quotient>,
    /// M̂.
    pub mass: Vec<Vec<Quotient>>,
    /// ĥ, the velocity terms.
    pub velocity_terms: Vec<Quotient>,
    /// Q̂, the generalised forces.
    pub forces: Vec<Quotient>,
    /// T.
    pub kinetic: Quotient,
    /// V.
    pub potential: Quotient,
    /// What series contain that is no series itself, in terms of what stays.
    pub opaque_terms: Vec<OpaqueTerm>,
    /// Reaction of each closed row (index of the row, λ), in terms of kept accelerations and the
    /// friction forces.
    pub reactions: Vec<(usize, Quotient)>,
    /// The same in an order in which one may contain those before it, as numbers are best computed.
    pub reaction_steps: Vec<(usize, Quotient)>,
    /// The contacts that slide.
    pub sliding: Vec<Sliding>,
}

/// A contact that slides.
#[derive(Clone, Debug)]
pub struct Sliding {
    /// The contact.
    pub contact: usize,
    /// The row of its slip, whose multiplier is the friction force R.
    pub row: usize,
    /// μ.
    pub kinetic: Quotient,
}

impl Phase {
    /// λ of a closed row.
    ///
    /// # Panics
    /// The row is not closed.
    pub fn reaction(&self, row: usize) -> &Quotient {
        let found = self.reactions.iter().find(|(closed, _)| *closed == row);
        found.map(|(_, reaction)| reaction).expect("a closed row")
    }
}

/// The closed forms of `motion`, smallest sets first; none where the friction of hinges follows the
/// length of a force.
pub fn closed_forms(system: &System, kinematics: &Kinematics, motion: &Motion, dense: &Dense) -> Vec<Phase> {
    if motion.has_hinges() {
        return Vec::new();
    }
    let contacts = motion.contacts.len().min(SEARCHED);
    let mut sets = motion.sets(contacts);
    sets.retain(|set| motion.sliding(*set).count() <= SLIDING);
    let samples = system.samples.iter();
    let samples: Vec<_> = samples
        .map(|numbers| nominal_values(system, numbers, &kinematics.nominal(system, numbers)))
        .collect();
    let mut phases = Vec::new();
    work::limited(WORK, || {
        for set in sets {
            let rows = rows(motion, set);
            let eliminated = eliminate::eliminate(kinematics, motion, &rows, &samples);
            let phase = eliminated.and_then(|e| reduction::reduce(motion, dense, set, e));
            if phases.len() >= system.sets || work::is_spent() {
                break;
            }
            phases.extend(phase);
        }
    });
    phases
}

/// The closed rows of a set: its contacts, all joints, the slips of those that are rough or stick.
fn rows(motion: &Motion, set: ClosedSet) -> Vec<usize> {
    (0..motion.rows.len()).filter(|&row| motion.is_closed(row, set)).collect()
}
