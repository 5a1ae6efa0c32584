//! Gauss collocation of order 12, for long smooth runs: symplectic and symmetric, with a constant
//! step, so that energy does not drift (Hairer, Lubich, Wanner, *Geometric Numerical Integration*,
//! 2nd ed., II.1.3, VI.4, VIII.6).
//!
//! The step is as long as the tolerance allows where the motion is fastest: it is found at the
//! start, and a step whose highest mode is larger than any before, or whose modes fall more slowly,
//! is compared with two of half the length, and made shorter, for good, where they differ by more
//! than the tolerance. After a projection the step is symmetric only up to that.

mod dense;
mod legendre;
mod stages;
mod tableau;
#[cfg(test)]
mod tests;

use super::rhs_cache::{RhsCache, planned_step};
use super::tolerance::norm;
use super::{Dense, StepError, StepState, Stepper, is_finite};
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use dense::{Fine, TERMS};
use legendre::STAGES;
use stages::{CollocationEquations, IterationFailure, Sum};
use tableau::Stages;
use tableau::Tableau;

/// The error of a step is O(h¹³).
const ORDER: f64 = 2.0 * STAGES as f64;
const SAFETY: f64 = 0.9;
/// A first step with a smaller error is made longer, so many times at most.
const TIMID: f64 = 0.1;
const PILOTS: u32 = 20;
/// An error that is foretold above this, in units of the tolerance, is always looked at.
const FORETOLD: f64 = 1e-3;
/// The modes before the first step.
const UNSEEN: [f64; 2] = [-1.0; 2];
/// Rounding hides errors below this.
const LEAST: f64 = 1e-13;
/// What the last change of the dense output may be in units of the tolerance; the next would be
/// some hundred times less.
const ENOUGH: f64 = 0.3;
/// Steps that are so many times shorter than those before are followed, as those towards a pole
/// are, which soon end; not for longer than [`PATIENCE`] steps where [`MANY`] are left.
const SHORTER: f64 = 1e3;
const PATIENCE: u32 = 10_000;
const MANY: f64 = 1e6;
/// Rounding of a step and of its comparison, in units of that of the state and of what it moves by.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// An integration by Gauss's method.
pub struct Gauss<F, const N: usize> {
    f: F,
    step_state: StepState<f64, N>,
    tableau: Tableau<STAGES>,
    pairs: usize,
    fine: Fine,
    rhs: RhsCache<f64, N>,
    /// The state, and of which jump it is.
    sum: Option<(Sum<N>, u64)>,
    last: Last<N>,
    /// The largest highest mode of all steps of this length, and the largest error that their modes
    /// have foretold, in units of the tolerance.
    record: [f64; 2],
    /// The largest of each component so far, or what it moved by in a step.
    largest: [f64; N],
    /// The longest step since the start or a jump, and how many steps far shorter than that have
    /// been made.
    longest: (f64, u32),
}

/// The last step, and its polynomial once it is asked for.
struct Last<const N: usize> {
    times: [f64; 2],
    y0: [f64; N],
    l: Stages<N, STAGES>,
    dense: Dense<f64, N>,
    is_dense: bool,
    jumps: Option<u64>,
}

/// Why a step was refused: the one to try next, whether all was finite, and whether the iteration
/// converged.
struct Refusal {
    wanted: f64,
    finite: bool,
    solved: bool,
}

impl<F: Fn(&[f64; N]) -> [f64; N], const N: usize> Gauss<F, N> {
    /// Integrates y′ = f(y) from where `step_state` is.
    pub fn new(f: F, step_state: StepState<f64, N>) -> Self {
        let last = Last {
            times: [step_state.time; 2],
            y0: step_state.state,
            l: [[0.0; N]; STAGES],
            dense: Dense::with_room(TERMS),
            is_dense: false,
            jumps: None,
        };
        let (tableau, fine, largest) = (Tableau::new(), Fine::new(), [0.0; N]);
        Self {
            f,
            step_state,
            tableau,
            pairs: 0,
            fine,
            rhs: RhsCache::UNKNOWN,
            sum: None,
            last,
            record: UNSEEN,
            largest,
            longest: (0.0, 0),
        }
    }

    /// Promises that the rates of the first `n` entries are the `n` entries that follow, as those
    /// of coordinates are: the iteration then takes half as many sweeps.
    #[must_use]
    pub fn with_pairs(mut self, n: usize) -> Self {
        self.pairs = n.min(N / 2);
        self
    }

    fn state(&self) -> Sum<N> {
        match self.sum {
            Some((sum, jumps)) if jumps == self.step_state.jumps() => sum,
            _ => Sum::new(self.step_state.state),
        }
    }

    /// Whether the next step is the first since the start or a jump.
    fn starts(&self) -> bool {
        self.last.jumps != Some(self.step_state.jumps())
    }

    /// The constant step; at a start f is looked at for it.
    fn planned_step(&mut self) -> Result<f64, StepError> {
        match self.step_state.next {
            Some(h) if !self.starts() => Ok(h),
            _ => {
                self.record = UNSEEN;
                let slope = self.rhs.get(&self.f, &mut self.step_state)?;
                Ok(planned_step(&self.f, &mut self.step_state, &slope, ORDER))
            }
        }
    }

    fn pilots(&self) -> u32 {
        if self.starts() { PILOTS } else { 0 }
    }

    /// Counts a step that is far shorter than those before, which does not grow again; refuses it
    /// where there have been many and very many would follow.
    fn check_length(&mut self, h: f64) -> Result<(), StepError> {
        if self.starts() {
            self.longest = (0.0, 0);
        }
        let (t, (longest, short)) = (self.step_state.time, &mut self.longest);
        *longest = longest.max(h);
        *short = if h * SHORTER < *longest { *short + 1 } else { 0 };
        let left = self.step_state.end.map_or(0.0, |end| end - t);
        if *short > PATIENCE && left > MANY * h {
            return Err(StepError::Constant { t, h, longest: *longest });
        }
        Ok(())
    }

    /// Whether the step begins where the last one did, which was too long.
    fn goes_back(&self) -> bool {
        self.last.jumps.is_some() && self.last.times[0] == self.step_state.time
    }

    /// The last step's slopes, continued; without a last step, constant ones.
    fn first_guess(&mut self, h: f64) -> Result<Stages<N, STAGES>, StepError> {
        if self.starts() {
            let slope = self.rhs.get(&self.f, &mut self.step_state)?;
            return Ok(self.tableau.constant(h, &slope));
        }
        let [t0, t1] = self.last.times;
        Ok(self.tableau.continuation(&self.last.l, h / (t1 - t0)))
    }

    fn attempt(&mut self, h: f64, pilots: u32) -> Result<(Stages<N, STAGES>, Sum<N>), Refusal> {
        let state = self.state();
        let mut l = self.first_guess(h).map_err(|_| Refusal::after(&IterationFailure::NotFinite, h))?;
        let rounding = *self.step_state.tolerance.absolute();
        let counts = &mut self.step_state.counts.evaluations;
        let equations = CollocationEquations { f: &self.f, tableau: &self.tableau, pairs: self.pairs };
        let solved = equations.solve((&state, h), &mut l, [&[0.0; N], &rounding], counts);
        solved.map_err(|failure| Refusal::after(&failure, h))?;
        let end = state.advance(&l);
        if !is_finite(&end.high) {
            return Err(Refusal::after(&IterationFailure::NotFinite, h));
        }
        let largest = self.largest(&l);
        let tolerance = self.step_state.tolerance.scale(&largest, &largest);
        let scale = core::array::from_fn(|i| tolerance[i] + ROUNDING * largest[i]);
        let modes = self.last_modes(&l, &scale);
        if modes[0] > self.record[0] || modes[1] > self.record[1].min(FORETOLD) {
            let err = self.error((h, &scale), &state, &end)?;
            // A motion that is uniform, in time alone say, leaves a longer step to try too, but not
            // one that has been tried.
            let uniform = || !self.goes_back() && l.iter().flatten().any(|change| *change != 0.0);
            if err > 1.0 || err < TIMID && pilots > 0 && (modes[0] > 0.0 || uniform()) {
                self.record = UNSEEN;
                let factor = SAFETY * err.max(LEAST).powf(-1.0 / (ORDER + 1.0));
                return Err(Refusal { wanted: h * factor.max(0.2), finite: true, solved: true });
            }
            self.record = [0, 1].map(|i| modes[i].max(self.record[i]));
        }
        Ok((l, end))
    }

    /// The highest mode, and the mode of the error if all beyond fall as the last ones of its
    /// parity do, or as the larger of both parities, of which either may be small by chance: slowly
    /// beside a place where the motion is hardly smooth, as where a force with its length in the
    /// equations nearly vanishes.
    fn last_modes(&self, l: &Stages<N, STAGES>, scale: &[f64; N]) -> [f64; 2] {
        let mode = |k: usize| norm(&self.tableau.coefficient(STAGES - k, l), scale);
        let [last, second, third, fourth] = [1, 2, 3, 4].map(mode);
        let beyond = |mode: f64, fall: f64| mode * fall.sqrt().min(1.0).powi(STAGES as i32 + 1);
        let of_both = (last.max(second) / third.max(fourth)).min(1.0);
        [last, beyond(last, last / third).max(beyond(last.max(second * of_both.sqrt()), of_both))]
    }

    /// What errors are relative to: one step serves the whole run, also where a component passes
    /// through zero.
    fn largest(&self, l: &Stages<N, STAGES>) -> [f64; N] {
        let y = &self.step_state.state;
        core::array::from_fn(|i| {
            let moved: f64 = l.iter().map(|l| l[i].abs()).sum();
            self.largest[i].max(y[i].abs()).max(moved)
        })
    }

    /// The difference from two steps of half the length.
    fn error(&mut self, (h, scale): (f64, &[f64; N]), start: &Sum<N>, end: &Sum<N>) -> Result<f64, Refusal> {
        let (mut state, half) = (*start, 0.5 * h);
        let rounding = *self.step_state.tolerance.absolute();
        for _ in 0..2 {
            let counts = &mut self.step_state.counts.evaluations;
            *counts += 1;
            let slope = (self.f)(&state.high);
            let mut l = self.tableau.constant(half, &slope);
            let equations = CollocationEquations { f: &self.f, tableau: &self.tableau, pairs: self.pairs };
            let solved = equations.solve((&state, half), &mut l, [&[0.0; N], &rounding], counts);
            solved.map_err(|failure| Refusal::after(&failure, h))?;
            state = state.advance(&l);
        }
        let difference = |i: usize| (end.high[i] - state.high[i]) + (end.low[i] - state.low[i]);
        Ok(norm(&core::array::from_fn(difference), scale))
    }
}

impl Refusal {
    fn after(failure: &IterationFailure, h: f64) -> Self {
        Self { wanted: 0.5 * h, finite: !matches!(failure, IterationFailure::NotFinite), solved: false }
    }
}

impl<F: Fn(&[f64; N]) -> [f64; N], const N: usize> Stepper<f64, N> for Gauss<F, N> {
    fn step_state(&self) -> &StepState<f64, N> {
        &self.step_state
    }

    fn step_state_mut(&mut self) -> &mut StepState<f64, N> {
        &mut self.step_state
    }

    /// Some ten sweeps of 6 evaluations of f.
    fn step(&mut self) -> Result<(), StepError> {
        let mut wanted = self.planned_step()?;
        let (mut finite, mut solved, mut pilots) = (true, true, self.pilots());
        loop {
            let (h, t1) = self.step_state.fit(wanted, finite).map_err(|error| match error {
                StepError::Floor { t, h } if !solved => StepError::Iteration { t, h },
                error => error,
            })?;
            match self.attempt(h, pilots) {
                Ok((l, end)) => {
                    self.check_length(h)?;
                    let jumps = self.step_state.jumps();
                    self.largest = self.largest(&l);
                    (self.last.times, self.last.y0) = ([self.step_state.time, t1], self.step_state.state);
                    (self.last.l, self.last.is_dense, self.last.jumps) = (l, false, Some(jumps));
                    self.sum = Some((end, jumps));
                    self.step_state.accept(t1, end.high, wanted);
                    return Ok(());
                }
                Err(refusal) => (wanted, finite, solved) = (refusal.wanted, refusal.finite, refusal.solved),
            }
            pilots = pilots.saturating_sub(1);
            self.step_state.counts.rejected += 1;
        }
    }

    /// Some three sweeps of 12 evaluations of f.
    fn dense(&mut self) -> &Dense<f64, N> {
        let Last { times, y0, l, dense, is_dense, .. } = &mut self.last;
        if !*is_dense {
            let y1 = self.step_state.state;
            let enough = self.step_state.tolerance.scale(&self.largest, &self.largest).map(|s| ENOUGH * s);
            let modes = self.tableau.modes(l);
            let mut terms = self.fine.coefficients(
                (&self.f, self.pairs),
                (y0, times[1] - times[0]),
                (&modes, &enough),
                &mut self.step_state.counts.evaluations,
            );
            terms[1] = core::array::from_fn(|i| y1[i] - y0[i]);
            dense.set_alternating(*times, y1, terms);
            *is_dense = true;
        }
        dense
    }

    /// Projected, the step is still symmetric only up to the projection.
    fn replace_end(&mut self, y1: [f64; N]) -> Result<(), StepError> {
        self.step_state.state = y1;
        self.sum = Some((Sum::new(y1), self.step_state.jumps()));
        self.last.is_dense = false;
        self.step_state.check(&y1)
    }
}
