//! Stiffness judged on the way: an explicit method whose steps are kept short by damping, or by an
//! oscillation, is replaced by [`Radau`], and comes back once that is gone or Radau's steps are
//! hardly longer.
//!
//! The measures are −tr ∂f/∂y, the sum of the rates at which all motion decays, and √(−½ tr
//! (∂f/∂y)²), that of undamped motion's circular frequencies ω as √Σω², from the phase's exact
//! Jacobian at every [`OFTEN`]th step. Whether an oscillation has an amplitude that a tolerance
//! resolves is not seen in the Jacobian: Radau's steps tell, which are long where it has none. It
//! loses its amplitude by damping alone, so that Radau is not tried again before that had time.

use super::pair::StepperPair;
use super::{Choice, Method, MethodChanges, Problem, Radau, StartedStepper};
use crate::integrate::{Counts, Guards, StepError};
use crate::system::{DenseOutput, Jacobian, PhaseStepper};

/// Damping is stiff where −tr ∂f/∂y exceeds this per natural time: what it damps has decayed long
/// before anything else moves.
pub(super) const STIFF: f64 = 1e3;
/// Steps from one look to the next.
const OFTEN: u32 = 16;
/// Looks in a row that must find it stiff: what decays fast at first has done so by then.
const SURE: u32 = 2;
/// An explicit step is kept short by damping where it is longer than this part of the time of
/// decay, near the edge of the method's stability, and not where it is shorter for accuracy's sake.
const HELD: f64 = 0.5;
/// The implicit method is left where damping is so much less than what it is taken for.
const GONE: f64 = 0.1;
/// A step of Radau takes as long as some ten explicit ones. An oscillation is left to it as long as
/// it is not clearly slower: its steps are at least so much longer.
const LONGER: f64 = 5.0;
/// Radau's first step is so much longer than explicit ones, which excite an oscillation up to the
/// tolerance: it passes over that at once, where short steps would have to follow it.
const LEAP: f64 = 100.0;
/// Looks within which Radau shows whether its steps are longer.
const TRIAL: u32 = 2 * SURE;
/// Explicit steps from when Radau was of use for a while to when it may be so again.
const PAUSE: u32 = 16 * OFTEN;
/// By how much more damping is awaited after each trial that fails: a motion settles on one method.
const RARER: f64 = 16.0;

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
    /// What the implicit method is at work for.
    cause: Cause,
    /// Looks since the method changed.
    looks: u32,
    /// The last look.
    looked: f64,
    pause: Pause,
    switches: MethodChanges,
}

/// What keeps explicit steps short.
#[derive(Clone, Copy)]
enum Cause {
    Damping,
    /// With the explicit step.
    Oscillation(f64),
}

/// What there is to await before an oscillation is left to Radau again.
struct Pause {
    /// Explicit steps.
    steps: u32,
    /// ∫ −tr ∂f/∂y dt.
    decay: f64,
    /// How much more of it the next time.
    rarer: f64,
}

impl Pause {
    fn none() -> Self {
        Self { steps: 0, decay: 0.0, rarer: 1.0 }
    }

    fn is_over(&self) -> bool {
        self.steps == 0 && self.decay <= 0.0
    }

    /// Begins after Radau was left at this look; an oscillation of natural size has a speed of so
    /// many tolerances.
    fn restart(&mut self, looks: u32, speed: f64) {
        if looks > TRIAL {
            self.steps = PAUSE;
        } else {
            // e^(−decay/2) is left of an amplitude.
            self.decay = 2.0 * self.rarer * speed.ln();
            self.rarer *= RARER;
        }
    }
}

/// The rates of a phase's motion, as sums over all its coordinates.
struct Rates {
    damping: f64,
    frequency: f64,
}

/// The same, watched for stiffness where the phase has a Jacobian: without one its equations cannot
/// be stiff. Where they are so at the start, `implicit` begins.
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
        cause: Cause::Damping,
        looks: 0,
        looked: problem.problem.t,
        pause: Pause::none(),
        switches: switches.clone(),
    });
    StartedStepper { choice, stepper, switches }
}

/// −tr ∂f/∂y.
pub(super) fn damping(jacobian: &Jacobian, y: &[f64]) -> f64 {
    compute_rates(jacobian, y).damping
}

/// −tr ∂f/∂y and √(−½ tr (∂f/∂y)²), zero where motion grows and decays faster than it oscillates.
fn compute_rates(jacobian: &Jacobian, y: &[f64]) -> Rates {
    let n = y.len();
    let mut entries = vec![0.0; n * n];
    jacobian(y, &mut entries);
    let square: f64 = (0..n * n).map(|k| entries[k] * entries[k % n * n + k / n]).sum();
    Rates { damping: -entries.iter().step_by(n + 1).sum::<f64>(), frequency: (-0.5 * square).max(0.0).sqrt() }
}

impl<'a> Watched<'a> {
    /// Changes the method where stiffness has come or gone.
    fn look(&mut self) {
        let Rates { damping, frequency } = compute_rates(&self.jacobian, self.steppers.active().state());
        let time = self.problem.time;
        let (t, h) = (self.steppers.active().time(), self.steppers.active().next_step().unwrap_or(0.0));
        self.pause.decay -= (damping * (t - self.looked)).max(0.0);
        (self.looks, self.looked) = (self.looks + 1, t);
        let is_held = |rate: f64| rate * time > STIFF && h * rate > HELD;
        let elsewhere = if self.steppers.is_other {
            match self.cause {
                Cause::Damping => damping * time < GONE * STIFF,
                Cause::Oscillation(explicit) => h < LONGER * explicit || frequency * time < GONE * STIFF,
            }
        } else {
            self.pause.steps = self.pause.steps.saturating_sub(OFTEN);
            is_held(damping) || self.pause.is_over() && is_held(frequency)
        };
        self.sure = if elsewhere { self.sure + 1 } else { 0 };
        if self.sure < SURE || !self.steppers.is_other && !self.has_implicit() {
            return;
        }
        let y = self.steppers.active().state().to_vec();
        self.steppers.is_other = !self.steppers.is_other;
        let mut next = h;
        let why = if self.steppers.is_other {
            self.cause = if is_held(damping) { Cause::Damping } else { Cause::Oscillation(h) };
            match self.cause {
                Cause::Damping => "its damping has become stiff",
                Cause::Oscillation(_) => {
                    next *= LEAP;
                    "a stiff spring keeps explicit steps short"
                }
            }
        } else {
            match self.cause {
                Cause::Damping => "its damping is stiff no longer",
                Cause::Oscillation(_) => {
                    self.pause.restart(self.looks, frequency * time / self.problem.problem.relative);
                    "its stiff spring keeps the steps of radau short, too"
                }
            }
        };
        (self.sure, self.looks) = (0, 0);
        let (end, longest) = (self.end, self.longest);
        self.steppers.active_mut().allow_step(longest);
        self.steppers.active_mut().jump(t, &y, next);
        self.steppers.active_mut().set_end(end);
        let method = if self.steppers.is_other { Radau.name() } else { self.first.method };
        let choice = Choice { method, why };
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
