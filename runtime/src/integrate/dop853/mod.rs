//! Dormand and Prince's explicit Runge–Kutta method of order 8(5,3), after Hairer's `dop853.f`
//! (Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.5, II.10).
//!
//! The coefficients carry the accuracy of `f64`; with a wider scalar the rounding of each step is
//! that of `f64`, h · 1e-16.

mod coefficients;
mod interpolant;
mod stages;
#[cfg(test)]
mod tests;

pub use interpolant::Interpolant;

use super::controller::Controller;
use super::initial_step::initial_step;
use super::{Counts, StepError, Tolerance};
use crate::scalar::Scalar;
use stages::{Slopes, Trial};

/// The error estimate is O(h⁸).
const ORDER: f64 = 8.0;
const BETA: f64 = 0.04;

/// An integration in progress: y′ = f(y), forwards in time. Every call must be given the same f.
#[derive(Clone, Debug)]
pub struct Dop853<S, const N: usize> {
    tolerance: Tolerance<N>,
    controller: Controller,
    time: S,
    state: [S; N],
    slope: Option<[S; N]>,
    step: Option<S>,
    first_step: S,
    end: Option<S>,
    longest: Option<S>,
    counts: Counts,
}

/// An accepted step from (t0, y0) to (t1, y1).
#[derive(Clone, Copy, Debug)]
pub struct Step<S, const N: usize> {
    /// Time at the start.
    pub t0: S,
    /// Time at the end.
    pub t1: S,
    /// Length, t1 − t0.
    pub h: S,
    /// State at the start.
    pub y0: [S; N],
    /// State at the end.
    pub y1: [S; N],
    slopes: Slopes<S, N>,
}

impl<S: Scalar, const N: usize> Dop853<S, N> {
    /// Starts at time `t0` in the state `y0`.
    pub fn new(tolerance: Tolerance<N>, t0: S, y0: [S; N]) -> Self {
        Self {
            tolerance,
            controller: Controller::new(ORDER, BETA),
            time: t0,
            state: y0,
            slope: None,
            step: None,
            first_step: S::ZERO,
            end: None,
            longest: None,
            counts: Counts::default(),
        }
    }

    /// Proposes the first step, which is else chosen from f.
    #[must_use]
    pub fn with_first_step(mut self, h: S) -> Self {
        self.step = Some(h);
        self.first_step = h;
        self
    }

    /// No step is longer than `h` > 0.
    #[must_use]
    pub fn with_longest_step(mut self, h: S) -> Self {
        self.longest = Some(h);
        self
    }

    /// Some step ends exactly at time `t`, and none goes past it.
    #[must_use]
    pub fn with_end(mut self, t: S) -> Self {
        self.end = Some(t);
        self
    }

    /// From now on some step ends exactly at time `t`, and none goes past it.
    pub fn set_end(&mut self, t: S) {
        self.end = Some(t);
    }

    /// Goes on from a later time and state, `h` the first step tried there; work is counted on.
    pub fn jump(&mut self, t: S, state: [S; N], h: S) {
        (self.time, self.state, self.slope) = (t, state, None);
        (self.step, self.first_step) = (Some(h), h);
    }

    /// Time of the last accepted state.
    pub fn time(&self) -> S {
        self.time
    }

    /// The last accepted state.
    pub fn state(&self) -> &[S; N] {
        &self.state
    }

    /// The step that will be tried next, once one has been made or proposed.
    pub fn next_step(&self) -> Option<S> {
        self.step
    }

    /// The work done so far.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// Makes one step: 12 evaluations of f, and 11 for each rejected trial.
    pub fn step(&mut self, f: impl Fn(&[S; N]) -> [S; N]) -> Result<Step<S, N>, StepError> {
        let slope = self.first_slope(&f)?;
        let mut wanted = self.planned_step(&f, &slope);
        let mut finite = true;
        loop {
            let (h, t1) = self.fit(wanted, finite)?;
            let mut trial = Trial::new(&f, &self.state, slope, h);
            self.counts.evaluations += Trial::<S, N>::EVALUATIONS;
            let err = self.judge(&f, &mut trial, h);
            if err <= 1.0 {
                self.step = Some(h * S::from_f64(self.controller.accepted(err)));
                return Ok(self.accept(trial, h, t1));
            }
            finite = err.is_finite();
            wanted = h * S::from_f64(self.controller.rejected(err));
            self.counts.rejected += 1;
        }
    }

    /// Replaces the end of the step just made, by a projection say. The step size is kept; f is
    /// evaluated at `y1`, for the next step and so that the dense output stays once differentiable.
    pub fn restart_from(
        &mut self,
        step: &mut Step<S, N>,
        y1: [S; N],
        f: impl Fn(&[S; N]) -> [S; N],
    ) -> Result<(), StepError> {
        self.state = y1;
        self.slope = None;
        let slope = self.first_slope(f)?;
        step.y1 = y1;
        step.slopes[stages::LAST] = slope;
        Ok(())
    }

    /// Dense output of a step: 3 evaluations of f.
    pub fn interpolant(&mut self, step: &Step<S, N>, f: impl Fn(&[S; N]) -> [S; N]) -> Interpolant<S, N> {
        self.counts.evaluations += Interpolant::<S, N>::EVALUATIONS;
        Interpolant::new(step, f)
    }

    fn first_slope(&mut self, f: impl Fn(&[S; N]) -> [S; N]) -> Result<[S; N], StepError> {
        let slope = self.slope.unwrap_or_else(|| {
            self.counts.evaluations += 1;
            f(&self.state)
        });
        if !(is_finite(&self.state) && is_finite(&slope)) {
            return Err(StepError::NotFinite { t: self.time.to_f64() });
        }
        self.slope = Some(slope);
        Ok(slope)
    }

    fn planned_step(&mut self, f: impl Fn(&[S; N]) -> [S; N], slope: &[S; N]) -> S {
        if let Some(h) = self.step {
            return h;
        }
        self.counts.evaluations += 1;
        let h = initial_step(f, &self.state, slope, &self.tolerance, ORDER);
        let at_rest = self.longest.or(self.end.map(|end| end - self.time));
        self.first_step = h.map_or(at_rest.unwrap_or(S::ratio(1, 1)), S::from_f64);
        self.first_step
    }

    /// The step to try and the time it leads to. Its length is the difference of two representable
    /// times, so that time does not drift against the state.
    fn fit(&self, wanted: S, finite: bool) -> Result<(S, S), StepError> {
        let t = self.time.to_f64();
        let h = match self.longest {
            Some(longest) if wanted > longest => longest,
            _ => wanted,
        };
        if let Some(end) = self.end {
            let left = end - self.time;
            if left <= S::ZERO {
                return Err(StepError::AtEnd { t });
            }
            // A step that nearly reaches the end is stretched to it (Hairer's 1.01).
            if S::from_f64(1.01) * h >= left {
                return Ok((left, end));
            }
        }
        if h > self.floor() {
            let t1 = self.time + h;
            return Ok((t1 - self.time, t1));
        }
        let h = h.to_f64();
        Err(if finite { StepError::Floor { t, h } } else { StepError::NotFinite { t } })
    }

    fn floor(&self) -> S {
        let (t, first) = (self.time.abs(), self.first_step);
        S::from_f64(10.0) * S::EPSILON * if t > first { t } else { first }
    }

    /// The error of a trial in units of the tolerance, with the slope at its end where it is
    /// acceptable; NaN if state or slope is not finite there.
    fn judge(&mut self, f: impl Fn(&[S; N]) -> [S; N], trial: &mut Trial<S, N>, h: S) -> f64 {
        let err = trial.error(&self.tolerance, &self.state, h);
        if err <= 1.0 {
            self.counts.evaluations += 1;
            trial.slopes[stages::LAST] = f(&trial.y1);
            if !(is_finite(&trial.y1) && is_finite(&trial.slopes[stages::LAST])) {
                return f64::NAN;
            }
        }
        err
    }

    fn accept(&mut self, trial: Trial<S, N>, h: S, t1: S) -> Step<S, N> {
        let Trial { y1, slopes } = trial;
        let (t0, y0) = (self.time, self.state);
        self.counts.accepted += 1;
        (self.time, self.state, self.slope) = (t1, y1, Some(slopes[stages::LAST]));
        Step { t0, t1, h, y0, y1, slopes }
    }
}

fn is_finite<S: Scalar, const N: usize>(x: &[S; N]) -> bool {
    x.iter().all(|x| x.is_finite())
}
