//! Models with friction in hinges: what opens, sticks or slides, at acceleration level. The
//! reaction of a hinge is the length of its force, which no linear problem gives; so all modes of
//! all contacts and hinges are tried, the motion of each solved for ([`liftoff_core::hinge`]), and
//! held to the law, or those of many hinges [improved](policy) until all obey it:
//!
//! ```text
//! hinge, v ≠ 0:            R = −σ μ |F|,      σ = sign v
//! hinge, v = 0, v̇ = 0:    |R| ≤ μ_s |F|
//! hinge, v = 0, v̇ ≠ 0:    R = −σ μ |F|,      σ = sign v̇
//! ```
//!
//! Contacts whose reactions were located at zero open, hinges located at their limits slide. What a
//! law leaves open at order 0 is decided by [what follows](ahead). Of several motions that with the
//! fewest closed contacts is taken, of these that with the most that stick.

mod ahead;
mod choices;
mod impact;
mod place;
mod policy;
mod search;
#[cfg(test)]
mod tests;

pub(crate) use impact::answer;

use super::degenerate::Alternatives;
use super::friction::Reason;
use super::{ContactError, ContactProblem, ContactSolution, labels, refuse_negative_friction, singular};
use crate::context::{Numbers, RunContext};
use crate::model::{ContactSet, Coordinate};
use choices::{Options, choices};
use place::{HingeCandidate, HingeProblem, SAME};

/// Up to so many combinations all are tried.
const FEW: usize = 100;

/// Solves for the closed contacts at a state that satisfies the touching ones.
pub(crate) fn decide(
    context: &RunContext,
    state: &[f64],
    question: &ContactProblem,
) -> Result<ContactSolution, ContactError> {
    let place = HingeProblem::new(context, Numbers::from_slice(state));
    refuse_negative_friction(context.layout(), &place.slips, question.touching)?;
    let options = choices(context.layout(), question);
    let most = question.most_trials.unwrap_or(usize::MAX);
    let improved = match trials(&options) {
        Some(count) if count <= FEW => None,
        _ => search::improved(&place, &options, most),
    };
    let complete = improved.is_none();
    if complete && trials(&options).is_none_or(|count| count > most) {
        return Err(ContactError::Undecided { contacts: labels(context.layout(), question.touching) });
    }
    let found = improved.unwrap_or_else(|| place.lasting(search::all(&place, &options)));
    place.taken(found, complete).ok_or_else(|| place.refusal(question))
}

/// How many combinations there are, if that is a number.
fn trials(options: &[Options]) -> Option<usize> {
    options.iter().try_fold(1_usize, |count, (_, of)| count.checked_mul(of.len()))
}

impl HingeProblem<'_> {
    fn taken(&self, mut found: Vec<HingeCandidate>, complete: bool) -> Option<ContactSolution> {
        let sticks = |it: &HingeCandidate| it.set.iter().filter(|&i| it.set.slip(i).sign() == 0).count();
        found.sort_by_key(|it| (it.set.len(), core::cmp::Reverse(sticks(it)), !it.unique));
        let mut distinct: Vec<&HingeCandidate> = Vec::new();
        for it in &found {
            if !distinct.iter().any(|other| self.are_one(other, it)) {
                distinct.push(it);
            }
        }
        let taken = *distinct.first()?;
        let alternatives = (distinct.len() > 1 || !complete).then(|| Alternatives {
            motions: distinct.iter().map(|it| self.describe(it.set)).collect(),
            taken: 0,
            reason: match distinct.get(1) {
                None => Reason::Only,
                Some(next) if next.set.len() > taken.set.len() => Reason::LiftOff,
                Some(_) => Reason::Sticks,
            },
            complete,
            determined: true,
        });
        Some(ContactSolution {
            closed: taken.set,
            active_basis: taken.set,
            reactions: taken.reactions.to_vec(),
            unique: taken.unique,
            alternatives,
        })
    }

    fn are_one(&self, one: &HingeCandidate, other: &HingeCandidate) -> bool {
        let scales = &self.context.scales;
        let least = |c: &Coordinate| scales.coordinate(c) / (scales.time * scales.time);
        let coordinates = self.context.layout().coordinates;
        let mut pairs = one.accelerations.iter().zip(&other.accelerations).zip(coordinates);
        pairs.all(|((x, y), c)| (x - y).abs() <= SAME * x.abs().max(y.abs()).max(least(c)))
    }

    fn describe(&self, set: ContactSet) -> String {
        let layout = self.context.layout();
        let closed = set.iter().map(|i| {
            let slips = match (layout.contacts[i].friction, set.slip(i).sign()) {
                (None, _) => "closed",
                (_, 0) => "sticking",
                (_, 1) => "sliding forward",
                _ => "sliding backward",
            };
            format!("{} {slips}", layout.contacts[i].label)
        });
        closed.collect::<Vec<_>>().join(", ")
    }

    /// Why there is no motion: that of the hinges, if there would be one without their friction.
    fn refusal(&self, question: &ContactProblem) -> ContactError {
        let layout = self.context.layout();
        let hinges: ContactSet = layout.hinges().map(|(_, friction, _)| friction.contact).collect();
        let others = question.touching.difference(hinges);
        match self.solve(others) {
            None => singular(&self.context.model, &self.state, others),
            Some(_) if others.is_empty() => {
                ContactError::Hinges { hinges: labels(layout, question.touching.intersection(hinges)) }
            }
            Some(_) => ContactError::Jammed { contacts: labels(layout, question.touching) },
        }
    }
}
