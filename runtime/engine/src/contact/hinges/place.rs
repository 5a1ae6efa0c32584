//! The state that is asked about, its motion with some contacts closed, and the laws that it has to
//! satisfy.

use smallvec::smallvec;

use super::choices::HingeChoice;
use crate::Scales;
use crate::context::{Numbers, RunContext, Slips, reactions_of, slips};
use crate::model::ContactSet;
use crate::system::Equations;

/// Forces and accelerations are zero below this part of the natural ones.
pub(super) const ZERO: f64 = 1e-9;
/// Two accelerations are one up to this part of the larger, or of a natural one.
pub(super) const SAME: f64 = 1e-8;

/// The state that is asked about.
pub(super) struct HingeProblem<'a> {
    pub(super) context: &'a RunContext,
    pub(super) state: Numbers,
    /// Those of the motion as fast as it is here.
    pub(super) scales: Scales,
    equations: Equations<f64>,
    pub(super) slips: Slips,
}

/// A motion with a choice of each contact.
pub(super) struct HingeCandidate {
    pub(super) choice: Vec<(usize, HingeChoice)>,
    pub(super) set: ContactSet,
    pub(super) accelerations: Numbers,
    pub(super) reactions: Numbers,
    pub(super) unique: bool,
}

/// A force or acceleration that must not be negative.
pub(super) struct SignCondition {
    pub(super) margin: f64,
    /// What counts as zero.
    pub(super) zero: f64,
    /// Whether an event says that it is zero.
    is_located: bool,
}

impl SignCondition {
    fn holds(&self) -> bool {
        self.is_located || self.margin >= -self.zero
    }

    /// Whether what follows decides if it holds.
    pub(super) fn is_open(&self) -> bool {
        self.is_located || self.margin.abs() <= self.zero
    }
}

impl<'a> HingeProblem<'a> {
    pub(super) fn new(context: &'a RunContext, state: Numbers) -> Self {
        let equations = context.system().equations(&state);
        let slips = slips(context.system(), &state);
        let scales = context.scales.moving_at(context.layout(), &state[context.rates()]);
        Self { context, state, scales, equations, slips }
    }

    /// The least force that is not zero.
    fn force(&self) -> f64 {
        ZERO * self.scales.force()
    }

    /// The least acceleration of a row that is not zero.
    fn acceleration(&self, row: usize) -> f64 {
        let scales = &self.scales;
        ZERO * self.context.layout().unit(row, scales.length) / (scales.time * scales.time)
    }

    /// Accelerations and reactions with the contacts of a set closed, if they are determined.
    pub(super) fn solve(&self, set: ContactSet) -> Option<(Numbers, Numbers, bool)> {
        let layout = self.context.layout();
        let mut accelerations: Numbers = smallvec![0.0; layout.coordinates.len()];
        let mut multipliers: Numbers = smallvec![0.0; layout.rows()];
        let unique = self.context.system().solve(&self.state, set, &mut accelerations, &mut multipliers);
        let finite = accelerations.iter().chain(&multipliers).all(|x| x.is_finite());
        finite.then(|| (accelerations, reactions_of(layout, &multipliers), unique))
    }

    /// The motion of one choice, if it is determined.
    pub(super) fn answer(&self, choice: Vec<(usize, HingeChoice)>) -> Option<HingeCandidate> {
        let set = choice.iter().fold(ContactSet::EMPTY, |set, (contact, choice)| choice.close(set, *contact));
        let (accelerations, reactions, unique) = self.solve(set)?;
        Some(HingeCandidate { choice, set, accelerations, reactions, unique })
    }

    /// Whether a motion satisfies the laws.
    pub(super) fn is_lawful(&self, found: &HingeCandidate) -> bool {
        self.laws(found).iter().all(SignCondition::holds) && self.holds(found.set, &found.accelerations)
    }

    /// The sense that a hinge has to have instead of the one of its choice; the same if it obeys
    /// its law.
    pub(super) fn obeyed(&self, found: &HingeCandidate, hinge: usize, sense: f64) -> f64 {
        let layout = self.context.layout();
        let choice = HingeChoice::of_hinge(sense);
        match layout.contacts[hinge].friction {
            Some(entry) if !self.laws_of(hinge, &choice, found).all(|law| law.holds()) => match sense {
                0.0 => -found.reactions[layout.contacts.len() + entry].signum(),
                _ => 0.0,
            },
            _ => sense,
        }
    }

    /// What a motion of a choice has to satisfy, in the order of its contacts.
    pub(super) fn laws(&self, found: &HingeCandidate) -> Vec<SignCondition> {
        found.choice.iter().flat_map(|(contact, choice)| self.laws_of(*contact, choice, found)).collect()
    }

    fn laws_of(
        &self,
        contact: usize,
        choice: &HingeChoice,
        found: &HingeCandidate,
    ) -> impl Iterator<Item = SignCondition> {
        let opening = |row: usize| {
            let margin = self.equations.gap_acceleration(row, &found.accelerations);
            SignCondition { margin, zero: self.acceleration(row), is_located: false }
        };
        let (opens, asked) = (choice.is_open, !choice.is_known);
        let opened = (opens && asked).then(|| opening(contact));
        let margin = f64::from(choice.side.sign()) * found.reactions[contact];
        let presses = SignCondition { margin, zero: self.force(), is_located: choice.is_unloaded };
        let presses = (!opens && !choice.is_held).then_some(presses);
        let rubs = choice.slip.zip(self.context.layout().contacts[contact].friction);
        let rubs = rubs.and_then(|(slip, entry)| {
            let friction = self.context.layout().frictions[entry];
            let force = found.reactions[self.context.layout().contacts.len() + entry];
            let most = self.slips[entry].limit * found.reactions[contact].abs();
            match f64::from(slip.sign()) {
                0.0 => {
                    Some(SignCondition { margin: most - force.abs(), zero: self.force(), is_located: false })
                }
                sense => asked
                    .then(|| opening(friction.row))
                    .map(|it| SignCondition { margin: sense * it.margin, ..it }),
            }
        });
        opened.into_iter().chain(presses).chain(rubs)
    }

    /// Whether the closed rows hold: those that depend on each other need not, as of a rocker that
    /// is to stick at its dead centre.
    fn holds(&self, set: ContactSet, accelerations: &[f64]) -> bool {
        let layout = self.context.layout();
        let mut closed = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set));
        closed.all(|row| {
            let terms = self.equations.jacobian(row).iter().zip(accelerations);
            let size =
                terms.map(|(entry, a)| (entry * a).abs()).sum::<f64>() + self.equations.bias()[row].abs();
            self.equations.gap_acceleration(row, accelerations).abs() <= SAME * size + self.acceleration(row)
        })
    }
}

#[cfg(test)]
mod tests;
