//! Steps that end where the equations are not analytic.
//!
//! Every method takes the right-hand side for smooth within a step. A step in which a
//! [`Kink`](crate::model::Kink) of the model vanishes is made again, up to there; the next begins
//! behind it. Where a step ends before a kink that is near, the next is planned to end at it, so
//! that few are made again.
//!
//! A Taylor series at the zero of a radicand cannot be had order by order: √(ẋ² + ẏ²) of a point at
//! rest has at order n the coefficient n + 1 of ẋ and ẏ. On one side of its zero the root is
//! smooth, however, and so the first step from there, and from where an integration begins, is one
//! of DOP853.

mod locate;
mod near;

use std::cell::RefCell;

use super::pair::StepperPair;
use super::{InitialValueProblem, Problem, StartedStepper};
use crate::context::Numbers;
use crate::integrate::{Counts, Guards, StepError};
use crate::model::Kink;
use crate::system::{DenseOutput, PhaseStepper};
use locate::KinkSamples;
use near::Near;

/// A step is made again so many times at most.
const MOST_CUTS: usize = 8;
/// After so many steps in a row that were planned to end at a kink it is taken for reached.
const MOST_PLANNED: u32 = 12;
/// What varied by a quarter over a step does not vanish within so many more, as it goes on.
const FAR: f64 = 2.0;
/// The part of the natural time that serves as the length of a step until one has been made.
const FIRST: f64 = 1e-2;

/// An integration that is cut at the kinks of its phase.
struct CutAtKinks<'a> {
    problem: InitialValueProblem<'a>,
    kinks: &'static [Kink],
    /// The method, and what makes the steps from kinks, where the method cannot.
    steppers: StepperPair<'a>,
    /// Whether no step has been made since the start or a jump.
    starts: bool,
    /// Whether the last step was made again, shorter.
    shortened: bool,
    /// Steps in a row planned to end at a kink.
    planned: u32,
    /// The length of the last step that no kink has cut.
    usual: f64,
    end: f64,
    /// The last step.
    dense: DenseOutput,
    samples: KinkSamples,
    /// Whether no kink came near zero over the last step.
    alike: bool,
    /// A full state and a reduced one.
    scratch: RefCell<[Numbers; 2]>,
    /// Steps that were made again.
    again: u64,
}

/// The same, cut at the kinks of the phase, if it has any.
pub(crate) fn cut<'a>(begun: StartedStepper<'a>, problem: &Problem<'a>) -> StartedStepper<'a> {
    let kinks = problem.problem.phase.system().layout().kinks;
    if kinks.is_empty() {
        return begun;
    }
    let StartedStepper { choice, stepper: main, switches } = begun;
    let bridge = if choice.method == "taylor" { problem.start_dop853() } else { None };
    let Problem { problem, time, .. } = *problem;
    let stepper = Box::new(CutAtKinks {
        problem,
        kinks,
        steppers: StepperPair::new(main, bridge),
        starts: true,
        shortened: false,
        planned: 0,
        usual: FIRST * time,
        end: problem.end,
        dense: DenseOutput::default(),
        samples: KinkSamples::default(),
        alike: false,
        scratch: RefCell::default(),
        again: 0,
    });
    StartedStepper { choice, stepper, switches }
}

impl<'a> CutAtKinks<'a> {
    /// One step up to a time at most; by the bridge where Taylor's method fails.
    fn advance(&mut self, end: f64) -> Result<(), StepError> {
        self.steppers.active_mut().set_end(end);
        let made = self.steppers.active_mut().step();
        if made.is_ok() || self.steppers.is_other || self.steppers.other.is_none() {
            return made;
        }
        let (t, y, h) = (self.steppers.usual.time(), self.steppers.usual.state().to_vec(), self.usual);
        self.steppers.is_other = true;
        self.steppers.active_mut().jump(t, &y, h);
        self.steppers.active_mut().set_end(end);
        self.steppers.active_mut().step().or(made)
    }

    /// Chooses what makes the next step, from beyond the kink that the last has ended at, and where
    /// it ends at most.
    fn prepare(&mut self) -> f64 {
        let (t, mut y) = (self.steppers.active().time(), Numbers::from_slice(self.steppers.active().state()));
        let near = if self.is_far() { Near::default() } else { self.near(t, &y) };
        let at_kink = near.at.is_some() || self.planned >= MOST_PLANNED;
        let bridges = self.steppers.other.is_some() && (self.starts || at_kink || near.close);
        let changes = bridges != self.steppers.is_other;
        self.steppers.is_other = bridges;
        if !self.starts && (at_kink || changes || self.shortened) {
            near.at.into_iter().for_each(|j| self.pass(j, &mut y));
            let h = self.usual;
            self.steppers.active_mut().jump(t, &y, h);
        }
        match near.ahead {
            Some(ahead) if !at_kink && ahead <= 1.25 * self.reach() => {
                self.planned += 1;
                (t + ahead).min(self.end)
            }
            _ => {
                self.planned = 0;
                self.end
            }
        }
    }

    /// Whether no kink can be expected within the next step, as little as they varied over the
    /// last.
    fn is_far(&self) -> bool {
        !self.starts && self.alike && self.reach() <= FAR * self.dense.h
    }

    /// How long the next step may be.
    fn reach(&self) -> f64 {
        self.steppers.active().next_step().unwrap_or(self.usual).max(self.usual)
    }
}

impl PhaseStepper for CutAtKinks<'_> {
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
        let all = self.steppers.counts();
        Counts { accepted: all.accepted - self.again, rejected: all.rejected + self.again, ..all }
    }

    fn allow_step(&mut self, h: f64) {
        self.steppers.usual.allow_step(h);
        if let Some(bridge) = &mut self.steppers.other {
            bridge.allow_step(h);
        }
    }

    fn set_end(&mut self, t: f64) {
        self.end = t;
    }

    fn jump(&mut self, t: f64, state: &[f64], h: f64) {
        self.steppers.usual.jump(t, state, h);
        if let Some(bridge) = &mut self.steppers.other {
            bridge.jump(t, state, h);
        }
        (self.starts, self.steppers.is_other, self.planned, self.usual) = (true, false, 0, h);
    }

    fn step(&mut self) -> Result<(), StepError> {
        let mut end = self.prepare();
        let (t0, y0) = (self.steppers.active().time(), self.steppers.active_mut().state().to_vec());
        self.shortened = false;
        for cuts in 0.. {
            self.advance(end)?;
            let mut dense = core::mem::take(&mut self.dense);
            self.steppers.active_mut().dense(&mut dense);
            self.dense = dense;
            let h = self.dense.h;
            let least = self.resolution(t0) / h;
            let Some(theta) = self.first_kink(least).filter(|_| cuts < MOST_CUTS) else {
                if end >= self.end && cuts == 0 {
                    self.usual = h;
                }
                break;
            };
            end = t0 + theta * h;
            (self.again, self.shortened) = (self.again + 1, true);
            self.steppers.active_mut().jump(t0, &y0, theta * h);
        }
        self.starts = false;
        Ok(())
    }

    fn dense(&mut self, dense: &mut DenseOutput) {
        self.steppers.active_mut().dense(dense);
    }

    fn replace_end(&mut self, y1: &[f64]) -> Result<(), StepError> {
        self.steppers.active_mut().replace_end(y1)
    }

    fn guards(&mut self) -> Option<Guards<'_>> {
        if self.steppers.is_other { None } else { self.steppers.usual.guards() }
    }
}
