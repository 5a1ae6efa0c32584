//! Stiffness judged on the way: an explicit method whose steps damping keeps short is replaced by [`Radau`], and comes back
//! once the damping is gone.
//!
//! The measure is −tr ∂f/∂y, the sum of the rates at which all motion decays, from the phase's exact Jacobian at every
//! [`OFTEN`]th step.

use super::auto::STIFF;
use super::{Choice, Method, Problem, Radau, StartedStepper, Switches};
use crate::integrate::{Counts, DenseOutput, Guards, PhaseStepper, StepError, erased};
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
    explicit: Box<dyn PhaseStepper + 'a>,
    implicit: Option<Box<dyn PhaseStepper + 'a>>,
    is_stiff: bool,
    end: f64,
    longest: f64,
    steps: u32,
    sure: u32,
    switches: Switches,
}

/// The same, watched for stiffness where the phase has a Jacobian: without one its equations cannot be stiff.
pub(super) fn watched<'a>(begun: StartedStepper<'a>, problem: &Problem<'a>) -> StartedStepper<'a> {
    let Some(jacobian) = problem.problem.phase.jacobian() else { return begun };
    let StartedStepper { choice, stepper: explicit, switches } = begun;
    let stepper = Box::new(Watched {
        problem: *problem,
        jacobian,
        first: choice,
        explicit,
        implicit: None,
        is_stiff: false,
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
    fn active(&mut self) -> &mut (dyn PhaseStepper + 'a) {
        match &mut self.implicit {
            Some(implicit) if self.is_stiff => &mut **implicit,
            _ => &mut *self.explicit,
        }
    }

    fn last(&self) -> &(dyn PhaseStepper + 'a) {
        match &self.implicit {
            Some(implicit) if self.is_stiff => &**implicit,
            _ => &*self.explicit,
        }
    }

    /// Changes the method where damping has come or gone.
    fn look(&mut self) {
        let damping = damping(&self.jacobian, self.last().state());
        let ratio = damping * self.problem.time;
        let h = self.last().next_step().unwrap_or(0.0);
        let elsewhere =
            if self.is_stiff { ratio < GONE * STIFF } else { ratio > STIFF && h * damping > HELD };
        self.sure = if elsewhere { self.sure + 1 } else { 0 };
        if self.sure < SURE || !self.is_stiff && !self.has_implicit() {
            return;
        }
        let (t, y) = (self.last().time(), self.last().state().to_vec());
        (self.is_stiff, self.sure) = (!self.is_stiff, 0);
        let (end, longest) = (self.end, self.longest);
        self.active().allow_step(longest);
        self.active().jump(t, &y, h);
        self.active().set_end(end);
        let choice = if self.is_stiff {
            Choice { method: Radau.name(), why: "its damping has become stiff" }
        } else {
            Choice { why: "its damping is stiff no longer", ..self.first }
        };
        self.switches.note(t, choice);
    }

    fn has_implicit(&mut self) -> bool {
        if self.implicit.is_none() {
            self.implicit = erased::radau(&self.problem.problem);
        }
        self.implicit.is_some()
    }
}

impl PhaseStepper for Watched<'_> {
    fn time(&self) -> f64 {
        self.last().time()
    }

    fn state(&self) -> &[f64] {
        self.last().state()
    }

    fn next_step(&self) -> Option<f64> {
        self.last().next_step()
    }

    fn counts(&self) -> Counts {
        self.implicit.iter().fold(self.explicit.counts(), |sum, other| sum + other.counts())
    }

    fn allow_step(&mut self, h: f64) {
        self.longest = h;
        self.active().allow_step(h);
    }

    fn set_end(&mut self, t: f64) {
        self.end = t;
        self.active().set_end(t);
    }

    fn jump(&mut self, t: f64, state: &[f64], h: f64) {
        self.active().jump(t, state, h);
    }

    fn step(&mut self) -> Result<(), StepError> {
        if self.steps == OFTEN {
            self.look();
            self.steps = 0;
        }
        self.steps += 1;
        self.active().step()
    }

    fn dense(&mut self, dense: &mut DenseOutput) {
        self.active().dense(dense);
    }

    fn replace_end(&mut self, y1: &[f64]) -> Result<(), StepError> {
        self.active().replace_end(y1)
    }

    fn guards(&mut self) -> Option<Guards<'_>> {
        self.active().guards()
    }
}
