//! Dormand and Prince's explicit Runge–Kutta method of order 8(5,3), after Hairer's `dop853.f`
//! (Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.5, II.10).
//!
//! The coefficients carry the accuracy of `f64`; with a wider scalar the rounding of each step is
//! that of `f64`, h · 1e-16.

mod coefficients;
mod dense;
mod stages;
#[cfg(test)]
mod tests;

use super::controller::Controller;
use super::slope::{Slope, planned_step};
use super::{Dense, Progress, Rates, StepError, Stepper, is_finite};
use crate::scalar::Scalar;
use stages::{LAST, Slopes, Trial};

/// The error estimate is O(h⁸).
const ORDER: f64 = 8.0;
const BETA: f64 = 0.04;

/// An integration by DOP853.
pub struct Dop853<'a, S, const N: usize> {
    f: Rates<'a, S, N>,
    progress: Progress<S, N>,
    controller: Controller,
    slope: Slope<S, N>,
    last: Last<S, N>,
}

/// The last step: its times, states and slopes, and the dense output once it is computed.
struct Last<S, const N: usize> {
    times: [S; 2],
    y0: [S; N],
    y1: [S; N],
    slopes: Slopes<S, N>,
    dense: Dense<S, N>,
    is_dense: bool,
}

impl<'a, S: Scalar, const N: usize> Dop853<'a, S, N> {
    /// Integrates y′ = f(y) from where `progress` is.
    pub fn new(f: Rates<'a, S, N>, progress: Progress<S, N>) -> Self {
        let zero = [S::ZERO; N];
        let last = Last {
            times: [progress.time; 2],
            y0: zero,
            y1: zero,
            slopes: [zero; LAST + 1],
            dense: Dense::with_room(8),
            is_dense: false,
        };
        Self { f, progress, controller: Controller::new(ORDER, BETA), slope: Slope::UNKNOWN, last }
    }

    /// The error of a trial in units of the tolerance, with the slope at its end where it is
    /// acceptable; NaN if state or slope is not finite there.
    fn judge(&mut self, trial: &mut Trial<S, N>, h: S) -> f64 {
        let err = trial.error(&self.progress.tolerance, &self.progress.state, h);
        if err <= 1.0 {
            self.progress.counts.evaluations += 1;
            trial.slopes[LAST] = (self.f)(&trial.y1);
            if !(is_finite(&trial.y1) && is_finite(&trial.slopes[LAST])) {
                return f64::NAN;
            }
        }
        err
    }

    fn accept(&mut self, trial: Trial<S, N>, t1: S, next: S) {
        let Trial { y1, slopes } = trial;
        let Progress { time, state, .. } = self.progress;
        (self.last.times, self.last.y0, self.last.y1) = ([time, t1], state, y1);
        (self.last.slopes, self.last.is_dense) = (slopes, false);
        self.slope.set(slopes[LAST], &self.progress);
        self.progress.accept(t1, y1, next);
    }
}

impl<S: Scalar, const N: usize> Stepper<S, N> for Dop853<'_, S, N> {
    fn progress(&self) -> &Progress<S, N> {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress<S, N> {
        &mut self.progress
    }

    /// 12 evaluations of f, and 11 for each rejected trial.
    fn step(&mut self) -> Result<(), StepError> {
        let slope = self.slope.get(self.f, &mut self.progress)?;
        let mut wanted = planned_step(self.f, &mut self.progress, &slope, ORDER);
        let mut finite = true;
        loop {
            let (h, t1) = self.progress.fit(wanted, finite)?;
            let mut trial = Trial::new(self.f, &self.progress.state, slope, h);
            self.progress.counts.evaluations += Trial::<S, N>::EVALUATIONS;
            let err = self.judge(&mut trial, h);
            if err <= 1.0 {
                let next = h * S::from_f64(self.controller.accepted(err));
                self.accept(trial, t1, next);
                return Ok(());
            }
            finite = err.is_finite();
            wanted = h * S::from_f64(self.controller.rejected(err));
            self.progress.counts.rejected += 1;
        }
    }

    /// 3 evaluations of f.
    fn dense(&mut self) -> &Dense<S, N> {
        let Last { times, y0, y1, slopes, dense, is_dense } = &mut self.last;
        if !*is_dense {
            self.progress.counts.evaluations += dense::EVALUATIONS;
            let coefficients = dense::coefficients(self.f, times[1] - times[0], [y0, y1], slopes);
            dense.set_alternating(*times, *y1, coefficients);
            *is_dense = true;
        }
        dense
    }

    /// f is evaluated at `y1`, for the next step and so that the dense output stays once differentiable.
    fn amend(&mut self, y1: [S; N]) -> Result<(), StepError> {
        (self.progress.state, self.slope) = (y1, Slope::UNKNOWN);
        let slope = self.slope.get(self.f, &mut self.progress)?;
        (self.last.y1, self.last.slopes[LAST], self.last.is_dense) = (y1, slope, false);
        Ok(())
    }
}
