//! Stiffness judged on the way: an explicit method whose steps damping keeps short is replaced by [`Radau`], and comes back
//! once the damping is gone.
//!
//! The measure is −tr ∂f/∂y, the sum of the rates at which all motion decays, from the phase's exact Jacobian at every
//! [`OFTEN`]th step.

use super::auto::STIFF;
use super::pair::StepperPair;
use super::{Choice, Method, Problem, Radau, StartedStepper, Switches};
use crate::integrate::{Counts, DenseOutput, Guards, PhaseStepper, StepError};
use crate::system::Jacobian;

/// Steps from one look to the next.
const OFTEN: u32 = 16;
/// Looks in a row that must find it stiff: what decays fast at first has done so by then.
const SURE: u32 = 2;
/// An explicit step is kept short by damping where it is longer than this part of the time of decay, near the edge of the
/// method's stability, and not where it is shorter for accuracy's sake.
const HELD: f64 = 0.5;
/// The implicit method is left where damping is so much less than what it is taken for.
const GONE: f64 = 0.1;

/// An integration by an explicit method or by Radau's.
struct Watched<'a> {
    problem: Problem<'a>,
    jacobian: Jacobian<'a>,
    /// What integrates where it is not stiff.
    first: Choice,
    /// The explicit method and the implicit one.
    steppers: StepperPair<'a>,
    end: f64,
    longest: f64,
    steps: u32,
    sure: u32,
    switches: Switches,
}

/// The same, watched for stiffness where the phase has a Jacobian: without one its equations cannot be stiff. Where they are so at
/// the start, `implicit` begins.
pub(super) fn watched<'a>(
    begun: StartedStepper<'a>,
    problem: &Problem<'a>,
    implicit: Option<Box<dyn PhaseStepper + 'a>>,
) -> StartedStepper<'a> {
    let Some(jacobian) = problem.problem.phase.jacobian() else { return begun };
    let StartedStepper { choice: first, stepper: explicit, switches } = begun;
    let is_stiff = implicit.is_some();
    let choice = if is_stiff { Choice { method: Radau.name(), why: "its damping is stiff" } } else { first };
    let stepper = Box::new(Watched {
        problem: *problem,
        jacobian,
        first,
        steppers: StepperPair { is_other: is_stiff, ..StepperPair::new(explicit, implicit) },
        end: problem.problem.end,
        longest: 0.0,
        steps: 0,
        sure: 0,
        switches: switches.clone(),
    });
    StartedStepper { choice, stepper, switches }
}

/// −tr ∂f/∂y.
pub(super) fn damping(jacobian: &Jacobian, y: &[f64]) -> f64 {
    let n = y.len();
    let mut entries = vec![0.0; n * n];
    jacobian(y, &mut entries);
    -entries.iter().step_by(n + 1).sum::<f64>()
}

impl<'a> Watched<'a> {
    /// Changes the method where damping has come or gone.
    fn look(&mut self) {
        let damping = damping(&self.jacobian, self.steppers.active().state());
        let ratio = damping * self.problem.time;
        let h = self.steppers.active().next_step().unwrap_or(0.0);
        let elsewhere =
            if self.steppers.is_other { ratio < GONE * STIFF } else { ratio > STIFF && h * damping > HELD };
        self.sure = if elsewhere { self.sure + 1 } else { 0 };
        if self.sure < SURE || !self.steppers.is_other && !self.has_implicit() {
            return;
        }
        let (t, y) = (self.steppers.active().time(), self.steppers.active().state().to_vec());
        (self.steppers.is_other, self.sure) = (!self.steppers.is_other, 0);
        let (end, longest) = (self.end, self.longest);
        self.steppers.active_mut().allow_step(longest);
        self.steppers.active_mut().jump(t, &y, h);
        self.steppers.active_mut().set_end(end);
        let choice = if self.steppers.is_other {
            Choice { method: Radau.name(), why: "its damping has become stiff" }
        } else {
            Choice { why: "its damping is stiff no longer", ..self.first }
        };
        self.switches.note(t, choice);
    }

    fn has_implicit(&mut self) -> bool {
        if self.steppers.other.is_none() {
            self.steppers.other = self.problem.start_implicit();
        }
        self.steppers.other.is_some()
    }
}

impl PhaseStepper for Watched<'_> {
    fn time(&self) -> f64 {
        self.steppers.active().time()
    }

    fn state(&self) -> &[f64] {
        self.steppers.active().state()
    }

    fn next_step(&self) -> Option<f64> {
        self.steppers.active().next_step()
    }

    fn counts(&self) -> Counts {
        self.steppers.counts()
    }

    fn allow_step(&mut self, h: f64) {
        self.longest = h;
        self.steppers.active_mut().allow_step(h);
    }

    fn set_end(&mut self, t: f64) {
        self.end = t;
        self.steppers.active_mut().set_end(t);
    }

    fn jump(&mut self, t: f64, state: &[f64], h: f64) {
        self.steppers.active_mut().jump(t, state, h);
    }

    fn step(&mut self) -> Result<(), StepError> {
        if self.steps == OFTEN {
            self.look();
            self.steps = 0;
        }
        self.steps += 1;
        self.steppers.active_mut().step()
    }

    fn dense(&mut self, dense: &mut DenseOutput) {
        self.steppers.active_mut().dense(dense);
    }

    fn replace_end(&mut self, y1: &[f64]) -> Result<(), StepError> {
        self.steppers.active_mut().replace_end(y1)
    }

    fn guards(&mut self) -> Option<Guards<'_>> {
        self.steppers.active_mut().guards()
    }
}
