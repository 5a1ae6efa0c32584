//! Models with friction in hinges: what opens, sticks or slides, at acceleration level. The reaction of a hinge is the length of its
//! force, which no linear problem gives; so all modes of all contacts and hinges are tried, the motion of each solved for
//! ([`liftoff_core::hinge`]), and held to the law:
//!
//! ```text
//! hinge, v ≠ 0:            R = −σ μ |F|,      σ = sign v
//! hinge, v = 0, v̇ = 0:    |R| ≤ μ_s |F|
//! hinge, v = 0, v̇ ≠ 0:    R = −σ μ |F|,      σ = sign v̇
//! ```
//!
//! Of several motions that with the fewest closed contacts is taken, of these that with the most that stick. Only order 0 is looked
//! at: contacts whose reactions were located at zero open, hinges located at their limits slide.

mod choices;
mod impact;

pub(crate) use impact::answer;

use smallvec::smallvec;

use super::degenerate::Alternatives;
use super::friction::Reason;
use super::{ContactError, ContactProblem, ContactSolution, refuse_negative_friction, singular};
use crate::integration::phase_point::{Numbers, RunContext, reactions_of};
use crate::model::{ContactSet, Coordinate, Layout, SlipState};
use crate::scales::slips;
use crate::system::Equations;
use choices::{Choice, choices};

/// Forces and accelerations are zero below this part of the natural ones.
const ZERO: f64 = 1e-9;
/// Two accelerations are one up to this part of the larger, or of a natural one.
const SAME: f64 = 1e-8;

/// A motion that satisfies the law.
struct Found {
    set: ContactSet,
    accelerations: Numbers,
    reactions: Numbers,
    unique: bool,
}

/// The state that is asked about.
struct Place<'a> {
    context: &'a RunContext,
    state: &'a [f64],
    equations: Equations<f64>,
    slips: Vec<SlipState<f64>>,
    force: f64,
}

/// Solves for the closed contacts at a state that satisfies the touching ones.
pub(crate) fn decide(
    context: &RunContext,
    state: &[f64],
    question: &ContactProblem,
) -> Result<ContactSolution, ContactError> {
    let place = Place {
        context,
        state,
        equations: context.system().equations(state),
        slips: slips(context.system(), state),
        force: ZERO * context.scales.force(),
    };
    refuse_negative_friction(context.layout(), &place.slips, question.touching)?;
    let options = choices(context.layout(), question);
    let count = options.iter().try_fold(1_usize, |count, (_, of)| count.checked_mul(of.len()));
    if count.is_none_or(|count| count > question.most_trials.unwrap_or(usize::MAX)) {
        return Err(ContactError::Undecided { contacts: labels(context.layout(), question.touching) });
    }
    let mut found: Vec<Found> = Vec::new();
    let mut chosen = vec![0; options.len()];
    loop {
        let choice: Vec<(usize, Choice)> =
            options.iter().zip(&chosen).map(|((contact, of), &k)| (*contact, of[k])).collect();
        found.extend(place.motion(&choice));
        let Some(next) = (0..options.len()).find(|&k| chosen[k] + 1 < options[k].1.len()) else { break };
        chosen[next] += 1;
        chosen[..next].fill(0);
    }
    place.taken(found).ok_or_else(|| place.refusal(question))
}

fn labels(layout: &Layout, set: ContactSet) -> Vec<String> {
    set.iter().map(|i| layout.contacts[i].label.to_owned()).collect()
}

impl Place<'_> {
    /// The least acceleration of a row that is not zero.
    fn acceleration(&self, row: usize) -> f64 {
        let scales = &self.context.scales;
        ZERO * self.context.layout().unit(row, scales.length) / (scales.time * scales.time)
    }

    /// Accelerations and reactions with the contacts of a set closed, if they are determined.
    fn solve(&self, set: ContactSet) -> Option<(Numbers, Numbers, bool)> {
        let layout = self.context.layout();
        let mut accelerations: Numbers = smallvec![0.0; layout.coordinates.len()];
        let mut multipliers: Numbers = smallvec![0.0; layout.rows()];
        let unique = self.context.system().solve(self.state, set, &mut accelerations, &mut multipliers);
        let finite = accelerations.iter().chain(&multipliers).all(|x| x.is_finite());
        finite.then(|| (accelerations, reactions_of(layout, &multipliers), unique))
    }

    /// The motion of one choice, if it satisfies the law.
    fn motion(&self, choice: &[(usize, Choice)]) -> Option<Found> {
        let set = choice.iter().fold(ContactSet::EMPTY, |set, (contact, choice)| choice.close(set, *contact));
        let (accelerations, reactions, unique) = self.solve(set)?;
        let obeys = |(contact, choice): &(usize, Choice)| {
            let opening = |row: usize| self.equations.gap_acceleration(row, &accelerations);
            let Some(slip) = choice.slip else {
                return !choice.is_open
                    || choice.is_known
                    || opening(*contact) >= -self.acceleration(*contact);
            };
            self.obeys(*contact, choice, (slip, &reactions), &opening)
        };
        let presses = |(contact, choice): &(usize, Choice)| {
            let side = f64::from(choice.side.sign());
            choice.is_open || choice.is_held || side * reactions[*contact] >= -self.force
        };
        let is_one = choice.iter().all(|it| presses(it) && obeys(it)) && self.holds(set, &accelerations);
        is_one.then_some(Found { set, accelerations, reactions, unique })
    }

    /// Whether the closed rows hold: those that depend on each other need not, as of a rocker that is to stick at its dead centre.
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

    /// Whether a closed contact with friction obeys Coulomb's law.
    fn obeys(
        &self,
        contact: usize,
        choice: &Choice,
        (slip, reactions): (crate::model::Slip, &Numbers),
        opening: &dyn Fn(usize) -> f64,
    ) -> bool {
        let layout = self.context.layout();
        let Some(entry) = layout.contacts[contact].friction else { return true };
        let force = reactions[layout.contacts.len() + entry];
        match f64::from(slip.sign()) {
            0.0 => force.abs() <= self.slips[entry].limit * reactions[contact].abs() + self.force,
            _ if choice.is_known => true,
            sense => {
                let row = layout.frictions[entry].row;
                sense * opening(row) >= -self.acceleration(row)
            }
        }
    }

    fn taken(&self, mut found: Vec<Found>) -> Option<ContactSolution> {
        let sticks = |it: &Found| it.set.iter().filter(|&i| it.set.slip(i).sign() == 0).count();
        found.sort_by_key(|it| (it.set.len(), core::cmp::Reverse(sticks(it)), !it.unique));
        let mut distinct: Vec<&Found> = Vec::new();
        for it in &found {
            if !distinct.iter().any(|other| self.are_one(other, it)) {
                distinct.push(it);
            }
        }
        let taken = *distinct.first()?;
        let alternatives = (distinct.len() > 1).then(|| Alternatives {
            motions: distinct.iter().map(|it| self.told(it.set)).collect(),
            taken: 0,
            reason: if distinct[1].set.len() > taken.set.len() { Reason::LiftOff } else { Reason::Sticks },
            complete: true,
            determined: true,
        });
        Some(ContactSolution {
            closed: taken.set,
            bearing: taken.set,
            reactions: taken.reactions.to_vec(),
            unique: taken.unique,
            alternatives,
        })
    }

    fn are_one(&self, one: &Found, other: &Found) -> bool {
        let scales = &self.context.scales;
        let least = |c: &Coordinate| scales.coordinate(c) / (scales.time * scales.time);
        let coordinates = self.context.layout().coordinates;
        let mut pairs = one.accelerations.iter().zip(&other.accelerations).zip(coordinates);
        pairs.all(|((x, y), c)| (x - y).abs() <= SAME * x.abs().max(y.abs()).max(least(c)))
    }

    fn told(&self, set: ContactSet) -> String {
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
            None => singular(&self.context.model, self.state, others),
            Some(_) if others.is_empty() => {
                ContactError::Hinges { hinges: labels(layout, question.touching.intersection(hinges)) }
            }
            Some(_) => ContactError::Jammed { contacts: labels(layout, question.touching) },
        }
    }
}
