//! Impacts of models with friction in hinges. The impulse Q of a journal's friction is limited by
//! that of the hinge, `|Q| ≤ μ |P|`, and against the slip after the impact where there is one, as
//! Newton's law has it of contacts; P follows from the change of the rates and the other impulses
//! as F does from accelerations and reactions. Hinges that do not obey are let slide or stuck until
//! all do; where that fails all modes are tried. |P| of those that slide is found by repetition,
//! which contracts as that of the motion does.

use core::cell::Cell;

use super::policy;
use crate::contact::compute_joint_impulse;
use crate::contact::impulse::{Collision, CollisionError, Outcome, Row};
use crate::model::Friction;
use crate::numerics::zero::{SOLVED, roundoff};
use crate::system::System;

/// Repetitions at most.
const STEPS: usize = 200;
/// Impulses are one up to this part of the largest, or up to so much if repetition does not bring
/// them closer.
const SAME: f64 = roundoff(4.0);
/// The residual of an outcome that obeys the laws of the other rows.
const RESIDUAL: f64 = 1e-9;
/// What is zero relative to the largest rate or impulse.
const ZERO: f64 = 1e-11;

/// A hinge: the entries of its force, its rows, μ.
struct Hinge {
    friction: Friction,
    force: [usize; 2],
    mu: f64,
}

/// A collision at a state.
struct HingeCollision<'a> {
    system: &'a dyn System,
    state: &'a [f64],
    collision: &'a Collision,
    hinges: Vec<Hinge>,
    /// Collisions that may still be solved.
    left: Cell<usize>,
}

/// The outcome of a collision at a state, of a model whose hinges have friction.
pub(crate) fn answer(
    system: &dyn System,
    state: &[f64],
    collision: &Collision,
    most_trials: usize,
) -> Result<Outcome, CollisionError> {
    let hinges = system.layout().hinges().map(|(_, friction, force)| {
        let mu = if let Row::Friction { mu, .. } = collision.rows[friction.row] { mu } else { 0.0 };
        Hinge { friction, force, mu }
    });
    let hinges: Vec<Hinge> = hinges.collect();
    let struck = HingeCollision { system, state, collision, hinges, left: Cell::new(most_trials) };
    struck.improved().map_or_else(|| struck.searched(), Ok)
}

impl HingeCollision<'_> {
    /// From hinges that all stick to those that have to slide, and back, until all obey; none where
    /// that goes in a circle or at the expense of restitution.
    fn improved(&self) -> Option<Outcome> {
        let found = policy::improve(self.hinges.len(), |senses| {
            let outcome = self.with(senses).ok()??;
            let next = self.obeyed(&outcome, senses);
            Some((outcome, next))
        });
        found.filter(|outcome| outcome.factor == 1.0)
    }

    /// The best of all modes: one that keeps restitutions whole comes before one whose hinges stick
    /// against them.
    fn searched(&self) -> Result<Outcome, CollisionError> {
        let mut failure = CollisionError::Jammed;
        let mut best: Option<(usize, Outcome)> = None;
        for senses in policy::all(self.hinges.len()) {
            let sticking = senses.iter().filter(|sense| **sense == 0.0).count();
            let is_better = |outcome: &Outcome| {
                best.as_ref().is_none_or(|(most, best)| (outcome.factor, sticking) > (best.factor, *most))
            };
            match self.with(&senses) {
                Ok(Some(outcome)) if self.obeyed(&outcome, &senses) == senses && is_better(&outcome) => {
                    best = Some((sticking, outcome));
                }
                Ok(_) | Err(CollisionError::Jammed) => {}
                Err(error) => failure = error,
            }
        }
        best.map(|(_, outcome)| outcome).ok_or(failure)
    }

    /// The outcome with these senses of the hinges, if |P| is found and the other rows obey their
    /// laws.
    fn with(&self, senses: &[f64]) -> Result<Option<Outcome>, CollisionError> {
        let Self { collision, hinges, .. } = self;
        let mut acting = (*collision).clone();
        for (hinge, &sense) in hinges.iter().zip(senses) {
            acting.rows[hinge.friction.row] = if sense == 0.0 { Row::TwoSided } else { Row::Open };
        }
        let slides = senses.iter().any(|sense| *sense != 0.0);
        let mut normals = vec![0.0; hinges.len()];
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            self.left.set(self.left.get().checked_sub(1).ok_or(CollisionError::Exhausted)?);
            acting.applied.clone_from(&collision.applied);
            for ((hinge, &sense), normal) in hinges.iter().zip(senses).zip(&normals) {
                let force = -sense * hinge.mu * normal;
                acting.applied += collision.jacobian.row(hinge.friction.row).transpose() * force;
            }
            let outcome = acting.solve_within(self.left.get())?;
            let found = joint_impulses(self.system, self.state, collision, &outcome, hinges);
            let largest = found.iter().copied().fold(0.0, f64::max);
            let apart =
                found.iter().zip(&normals).map(|(a, b): (&f64, &f64)| (a - b).abs()).fold(0.0, f64::max);
            let stalls = apart >= 0.5 * last && apart <= SOLVED * largest.max(outcome.impulses.amax());
            (normals, last) = (found, apart);
            if apart <= SAME * largest || stalls || !slides {
                let obeys = acting.residual(&outcome) <= RESIDUAL;
                return Ok(obeys.then(|| self.complete(outcome, senses, &normals)));
            }
        }
        Ok(None)
    }

    /// The same with the impulses of the hinges.
    fn complete(&self, mut outcome: Outcome, senses: &[f64], normals: &[f64]) -> Outcome {
        for ((hinge, &sense), &normal) in self.hinges.iter().zip(senses).zip(normals) {
            let Friction { contact, row, .. } = hinge.friction;
            outcome.impulses[contact] = normal;
            if sense != 0.0 {
                outcome.impulses[row] = -sense * hinge.mu * normal;
            }
        }
        outcome
    }

    /// The senses of the hinges that obey their law, and of the others what they have to do
    /// instead.
    fn obeyed(&self, outcome: &Outcome, senses: &[f64]) -> Vec<f64> {
        let collision = self.collision;
        let speed = collision.speed(&outcome.rates);
        let hinges = self.hinges.iter().zip(senses);
        let obeyed = hinges.map(|(hinge, &sense)| {
            let Friction { contact, row, .. } = hinge.friction;
            let rates = outcome.rates.abs() + collision.rates.abs();
            let size = collision.jacobian.row(row).abs().transpose().dot(&rates);
            let most = hinge.mu * outcome.impulses[contact];
            match sense {
                0.0 if outcome.impulses[row].abs() <= most * (1.0 + ZERO) + f64::MIN_POSITIVE => 0.0,
                0.0 => -outcome.impulses[row].signum(),
                _ if sense * speed[row] >= -ZERO * size => sense,
                _ => 0.0,
            }
        });
        obeyed.collect()
    }
}

/// |P| of each hinge.
fn joint_impulses(
    system: &dyn System,
    state: &[f64],
    collision: &Collision,
    outcome: &Outcome,
    hinges: &[Hinge],
) -> Vec<f64> {
    let change = &outcome.rates - &collision.rates;
    let part = |entry: usize| {
        compute_joint_impulse(system, entry, state, change.as_slice(), outcome.impulses.as_slice())
    };
    hinges.iter().map(|hinge| part(hinge.force[0]).hypot(part(hinge.force[1]))).collect()
}

#[cfg(test)]
mod tests;
