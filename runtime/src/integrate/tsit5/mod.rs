//! Tsitouras's explicit Runge–Kutta pair of order 5(4) with dense output of order 4, for loose tolerances
//! (*Computers & Mathematics with Applications* 62 (2011) 770).

mod coefficients;
mod stages;
#[cfg(test)]
mod tests;

use super::controller::Controller;
use super::dense::hermite;
use super::slope::{Slope, planned_step};
use super::{Dense, Progress, Rates, StepError, Stepper, is_finite};
use crate::scalar::Scalar;
use stages::{LAST, Slopes, Trial};

/// The error estimate is O(h⁵).
const ORDER: f64 = 5.0;
const BETA: f64 = 0.04;

/// An integration by Tsitouras's pair.
pub struct Tsit5<'a, S, const N: usize> {
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

impl<'a, S: Scalar, const N: usize> Tsit5<'a, S, N> {
    /// Integrates y′ = f(y) from where `progress` is.
    pub fn new(f: Rates<'a, S, N>, progress: Progress<S, N>) -> Self {
        let zero = [S::ZERO; N];
        let last = Last {
            times: [progress.time; 2],
            y0: zero,
            y1: zero,
            slopes: [zero; LAST + 1],
            dense: Dense::with_room(5),
            is_dense: false,
        };
        Self { f, progress, controller: Controller::new(ORDER, BETA), slope: Slope::UNKNOWN, last }
    }

    /// The error of a trial in units of the tolerance; NaN if the slope at its end is not finite.
    fn judge(&self, trial: &Trial<S, N>, h: S) -> f64 {
        let err = trial.error(&self.progress.tolerance, &self.progress.state, h);
        if is_finite(&trial.y1) && is_finite(&trial.slopes[LAST]) { err } else { f64::NAN }
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

impl<S: Scalar, const N: usize> Stepper<S, N> for Tsit5<'_, S, N> {
    fn progress(&self) -> &Progress<S, N> {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress<S, N> {
        &mut self.progress
    }

    /// 6 evaluations of f for each trial.
    fn step(&mut self) -> Result<(), StepError> {
        let slope = self.slope.get(self.f, &mut self.progress)?;
        let mut wanted = planned_step(self.f, &mut self.progress, &slope, ORDER);
        let mut finite = true;
        loop {
            let (h, t1) = self.progress.fit(wanted, finite)?;
            let trial = Trial::new(self.f, &self.progress.state, slope, h);
            self.progress.counts.evaluations += Trial::<S, N>::EVALUATIONS;
            let err = self.judge(&trial, h);
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

    /// No evaluation of f: y₀, y₁, f(y₀), f(y₁) and one coefficient more.
    fn dense(&mut self) -> &Dense<S, N> {
        let Last { times, y0, y1, slopes, dense, is_dense } = &mut self.last;
        if !*is_dense {
            let h = times[1] - times[0];
            let cubic = hermite(h, [*y0, *y1], [slopes[0], slopes[LAST]]);
            let quartic = stages::quartic(slopes).map(|x| h * x);
            dense.set_alternating(*times, *y1, cubic.into_iter().chain([quartic]));
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
