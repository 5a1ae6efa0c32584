//! The laws of contact of a model. A run reaches what decides and strikes contacts through them
//! only, so that a program has the code of those laws alone that its models name.

use super::degenerate::{decide, decide_smooth};
use super::friction::{SharedFriction, SharedFrictionMargin, holds, least_hold, margin};
use super::hinges::{self, answer};
use super::impulse::{Collision, CollisionError, Outcome};
use super::nondegenerate::{self, slider};
use super::{ContactError, ContactProblem, ContactSolution};
use crate::context::RunContext;
use crate::model::{ContactSet, Layout};
use crate::system::{PhaseEquations, System};

/// What decides and strikes contacts.
pub(crate) struct Laws {
    /// The closed contacts at a state; with the closed form of all touching ones, where it holds.
    pub(crate) decide: Decide,
    /// The outcome of a collision at a state, within so many trials.
    pub(crate) strike: Strike,
    /// The outcome with the contacts of a set closed, within so many trials.
    pub(crate) come_to_rest: fn(&Collision, &ContactSet, usize) -> Result<Outcome, CollisionError>,
    /// What contacts with friction need besides.
    pub(crate) rough: Option<&'static FrictionLaws>,
}

type Decide = fn(
    &RunContext,
    &[f64],
    &ContactProblem,
    Option<&dyn PhaseEquations>,
) -> Result<ContactSolution, ContactError>;

type Strike = fn(&dyn System, &[f64], &Collision, usize) -> Result<Outcome, CollisionError>;
type Holds = fn(&dyn System, &[f64], &ContactSet) -> Vec<(usize, f64)>;

/// What only contacts with friction need.
pub(crate) struct FrictionLaws {
    /// The impulse that ends a slip which no reaction holds, within so many trials.
    pub(crate) end_slip: fn(&Collision, usize) -> Result<Outcome, CollisionError>,
    /// What holds each contact that slides.
    pub(crate) holds: Holds,
    /// The least of them.
    pub(crate) least_hold: fn(&dyn System, &[f64], &ContactSet) -> Option<f64>,
    /// The closed contacts that share their load.
    pub(crate) grip: fn(&dyn System, &[f64], &ContactSet) -> SharedFriction,
    /// How far these are from slipping together.
    pub(crate) margin: fn(&dyn System, &[f64], &ContactSet, &[f64]) -> SharedFrictionMargin,
}

const FRICTION: FrictionLaws = FrictionLaws {
    end_slip: Collision::tangential_impact,
    holds,
    least_hold,
    grip: SharedFriction::compute,
    margin,
};

/// Contacts without friction.
static SMOOTH: Laws = Laws {
    decide: |context, state, problem, reduced| {
        nondegenerate::decide(context, state, problem, reduced)
            .map_or_else(|| decide_smooth(&context.model, state, problem), Ok)
    },
    strike: |_, _, collision, most_trials| collision.solve_smooth(most_trials),
    come_to_rest: Collision::come_to_rest_smoothly,
    rough: None,
};

/// Some contacts with friction.
static ROUGH: Laws = Laws {
    decide: |context, state, problem, reduced| {
        let clear = match problem.slips.is_empty() {
            true => nondegenerate::decide(context, state, problem, reduced),
            false => slider::decide(context, state, problem),
        };
        clear.map_or_else(|| decide(&context.model, state, problem), Ok)
    },
    strike: |_, _, collision, most_trials| collision.solve_within(most_trials),
    come_to_rest: Collision::come_to_rest,
    rough: Some(&FRICTION),
};

/// Hinges with friction, whatever contacts there are.
static HINGES: Laws = Laws {
    decide: |context, state, problem, _| hinges::decide(context, state, problem),
    strike: answer,
    come_to_rest: Collision::come_to_rest,
    rough: Some(&FRICTION),
};

impl Laws {
    /// Those of a model.
    pub(crate) const fn from_layout(layout: &Layout) -> &'static Self {
        if layout.frictions.is_empty() {
            &SMOOTH
        } else if layout.has_hinges() {
            &HINGES
        } else {
            &ROUGH
        }
    }
}
