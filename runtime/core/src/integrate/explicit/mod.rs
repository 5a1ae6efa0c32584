//! Explicit Runge–Kutta pairs whose dense output takes f at both ends of a step (Hairer, Nørsett,
//! Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.4 and II.6): one stepper for
//! all tableaux.

mod pair;

pub use pair::{Pair, Trial};

use super::controller::Controller;
use super::growth::{compute_reach, estimate_growth};
use super::rhs_cache::{RhsCache, planned_step};
use super::tolerance::norm;
use super::{Dense, StepError, StepState, Stepper, is_finite};
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// β of the PI term, that of DOPRI5 by Hairer, Nørsett, Wanner.
const BETA: f64 = 0.04;

/// An error below this part of the tolerance does not tell how fast grows what it is of.
const UNSEEN: f64 = 1e-2;
/// After so many steps with such errors growth is looked for, after one where a step moves the
/// state by less than a part of its size.
const MANY: u32 = 3;
const SLOW: f64 = 1e-2;

/// An integration by the pair `P` with `L` slopes, that at the end of the step among them.
pub struct Explicit<F, P, S, const N: usize, const L: usize> {
    f: F,
    step_state: StepState<S, N>,
    controller: Controller,
    rhs: RhsCache<S, N>,
    /// How many steps in a row had an error of which growth is not seen; the one that begins is
    /// one.
    unseen: u32,
    last: Last<S, N, L>,
    pair: PhantomData<P>,
}

/// The last step: its times, its start, its end with the slopes, and the dense output once it is
/// computed.
struct Last<S, const N: usize, const L: usize> {
    times: [S; 2],
    y0: [S; N],
    made: Trial<S, N, L>,
    dense: Dense<S, N>,
    is_dense: bool,
}

impl<F, P, S, const N: usize, const L: usize> Explicit<F, P, S, N, L>
where
    F: Fn(&[S; N]) -> [S; N],
    P: Pair<L>,
    S: Scalar,
{
    /// Integrates y′ = f(y) from where `step_state` is.
    pub fn new(f: F, step_state: StepState<S, N>) -> Self {
        let zero = [S::ZERO; N];
        let last = Last {
            times: [step_state.time; 2],
            y0: zero,
            made: Trial { y1: zero, slopes: [zero; L] },
            dense: Dense::with_room(P::TERMS),
            is_dense: false,
        };
        let controller = Controller::new(P::ORDER, BETA);
        Self { f, step_state, controller, rhs: RhsCache::UNKNOWN, unseen: 1, last, pair: PhantomData }
    }

    /// The error of a trial in units of the tolerance, with the slope at its end where it is
    /// acceptable; NaN if state or slope is not finite there.
    #[inline]
    fn judge(&mut self, trial: &mut Trial<S, N, L>, h: S) -> f64 {
        if P::ERROR_HAS_END {
            self.close(trial);
        }
        let err = P::error(trial, &self.step_state.tolerance, &self.step_state.state, h);
        if err <= 1.0 {
            if !P::ERROR_HAS_END {
                self.close(trial);
            }
            if !(is_finite(&trial.y1) && is_finite(&trial.slopes[L - 1])) {
                return f64::NAN;
            }
        }
        err
    }

    #[inline]
    fn close(&mut self, trial: &mut Trial<S, N, L>) {
        self.step_state.counts.evaluations += 1;
        trial.slopes[L - 1] = (self.f)(&trial.y1);
    }

    /// The step that is `wanted`, or the longest over which what grows from below the tolerance is
    /// followed.
    fn follow_growth(&mut self, wanted: S, slope: &[S; N]) -> S {
        let StepState { tolerance, state, .. } = &self.step_state;
        let moves = || wanted.to_f64() * norm(slope, &tolerance.scale(state, state));
        let is_slow = || moves() < SLOW * tolerance.measure(state);
        if self.unseen == 0 || self.unseen < MANY && !is_slow() {
            return wanted;
        }
        let reach = compute_reach(tolerance.relative(), P::ORDER, P::ERROR_CONSTANT);
        let growth = estimate_growth(&self.f, &mut self.step_state, slope);
        if wanted.to_f64() * growth > reach { S::from_f64(reach / growth) } else { wanted }
    }

    fn accept(&mut self, trial: Trial<S, N, L>, t1: S, next: S) {
        let StepState { time, state, .. } = self.step_state;
        (self.last.times, self.last.y0, self.last.is_dense) = ([time, t1], state, false);
        self.rhs.set(trial.slopes[L - 1], &self.step_state);
        self.step_state.accept(t1, trial.y1, next);
        self.last.made = trial;
    }
}

impl<F, P, S, const N: usize, const L: usize> Stepper<S, N> for Explicit<F, P, S, N, L>
where
    F: Fn(&[S; N]) -> [S; N],
    P: Pair<L>,
    S: Scalar,
{
    fn step_state(&self) -> &StepState<S, N> {
        &self.step_state
    }

    fn step_state_mut(&mut self) -> &mut StepState<S, N> {
        &mut self.step_state
    }

    /// As many evaluations of f as the pair has stages, that at the start left out and that at the
    /// end with them; of a rejected trial the one at the end only if its error needs it; one for
    /// each entry where growth is looked for.
    fn step(&mut self) -> Result<(), StepError> {
        let slope = self.rhs.get(&self.f, &mut self.step_state)?;
        let planned = planned_step(&self.f, &mut self.step_state, &slope, P::ORDER);
        let mut wanted = self.follow_growth(planned, &slope);
        let mut finite = true;
        loop {
            let (h, t1) = self.step_state.fit(wanted, finite)?;
            let mut trial = P::trial(&self.f, &self.step_state.state, slope, h);
            self.step_state.counts.evaluations += L as u64 - 2;
            let err = self.judge(&mut trial, h);
            if err <= 1.0 {
                let next = h * S::from_f64(self.controller.accepted(err));
                self.unseen = if err < UNSEEN { self.unseen.saturating_add(1) } else { 0 };
                self.accept(trial, t1, next);
                return Ok(());
            }
            finite = err.is_finite();
            wanted = h * S::from_f64(self.controller.rejected(err));
            self.step_state.counts.rejected += 1;
        }
    }

    fn dense(&mut self) -> &Dense<S, N> {
        let Last { times, y0, made, dense, is_dense } = &mut self.last;
        if !*is_dense {
            self.step_state.counts.evaluations += P::DENSE_EVALUATIONS;
            let terms = P::dense(&self.f, times[1] - times[0], y0, made);
            dense.set_alternating(*times, made.y1, terms);
            *is_dense = true;
        }
        dense
    }

    /// f is evaluated at `y1`, for the next step and so that the dense output stays once
    /// differentiable.
    fn replace_end(&mut self, y1: [S; N]) -> Result<(), StepError> {
        (self.step_state.state, self.rhs) = (y1, RhsCache::UNKNOWN);
        let slope = self.rhs.get(&self.f, &mut self.step_state)?;
        (self.last.made.y1, self.last.made.slopes[L - 1], self.last.is_dense) = (y1, slope, false);
        Ok(())
    }
}
