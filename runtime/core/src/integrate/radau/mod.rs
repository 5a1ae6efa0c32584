//! Radau IIA of order 5 with three stages, for stiff phases, after Hairer's `radau5.f` (Hairer &
//! Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., IV.8). L-stable; the Jacobian and
//! its factors are kept while they serve.
//!
//! What is not in `radau5.f`: dense output of order 4; Newton's own iteration where stiff
//! directions turn; tolerances below the rounding of the stiff forces are widened to it; steps that
//! are short where motion is unstable.

mod coefficients;
mod control;
mod dense;
mod factors;
mod full;
mod lu;
mod newton;
mod system;
#[cfg(test)]
mod tests;

use super::rhs_cache::{RhsCache, planned_step};
use super::tolerance::norm;
use super::{Dense, StepError, StepState, Stepper, Tolerance, is_finite};
use coefficients::{GAMMA, NODES};
use control::Control;
use newton::{NewtonFailure, Stages};
use system::{NewtonSystem, Solved};

/// The error estimate is O(h⁴).
const ORDER: f64 = 4.0;
/// Errors below this are of no account.
const LEAST_ERROR: f64 = 1e-10;

/// An integration by Radau IIA.
pub struct Radau<'a, F, const N: usize> {
    f: F,
    step_state: StepState<f64, N>,
    /// What the error estimate is held to.
    tolerance: Tolerance<N>,
    rhs: RhsCache<f64, N>,
    system: NewtonSystem<'a, N>,
    control: Control,
    last: Last<N>,
}

/// The last step: its times and polynomial, and of which jump it is.
struct Last<const N: usize> {
    times: [f64; 2],
    terms: [[f64; N]; 5],
    dense: Dense<f64, N>,
    jumps: Option<u64>,
}

/// A step not yet accepted.
struct Trial<const N: usize> {
    z: Stages<N>,
    y1: [f64; N],
    /// (γ/h − J)⁻¹ (f(y₀) − p′(0)).
    defect: [f64; N],
    /// In units of the tolerance.
    err: f64,
}

/// Why a trial was no step: the step to try next, and whether all was finite.
struct Refusal {
    wanted: f64,
    finite: bool,
}

impl<'a, F: Fn(&[f64; N]) -> [f64; N], const N: usize> Radau<'a, F, N> {
    /// Integrates y′ = f(y) from where `step_state` is; `jacobian` is ∂f/∂y, row `i` that of fᵢ.
    pub fn new(
        f: F,
        jacobian: impl Fn(&[f64; N]) -> [[f64; N]; N] + 'a,
        step_state: StepState<f64, N>,
    ) -> Self {
        let tolerance = for_estimate(&step_state.tolerance);
        let dense = Dense::with_room(5);
        let last = Last { times: [step_state.time; 2], terms: [[0.0; N]; 5], dense, jumps: None };
        let (rhs, system, control) = (RhsCache::UNKNOWN, NewtonSystem::new(jacobian), Control::NEW);
        Self { f, step_state, tolerance, rhs, system, control, last }
    }

    /// The last step's polynomial, continued.
    fn first_guess(&self, h: f64) -> Stages<N> {
        if self.last.jumps != Some(self.step_state.jumps()) {
            return [[0.0; N]; 3];
        }
        let y = &self.step_state.state;
        NODES.map(|c| {
            let ahead = self.last.dense.interpolate(1.0 + c * h / self.last.dense.h);
            core::array::from_fn(|i| ahead[i] - y[i])
        })
    }

    /// A step with an error that is allowed, and f at its end.
    fn attempt(&mut self, h: f64, slope: &[f64; N]) -> Result<(Trial<N>, [f64; N]), Refusal> {
        let guess = self.first_guess(h);
        let solved = self.system.solve(&self.f, &mut self.step_state, &self.tolerance, (h, guess));
        let solved = solved.map_err(|failure| match failure {
            NewtonFailure::Slow(factor) => Refusal { wanted: h * factor, finite: true },
            NewtonFailure::Diverges => Refusal { wanted: 0.5 * h, finite: true },
            NewtonFailure::NotFinite => Refusal { wanted: 0.5 * h, finite: false },
        })?;
        let trial = self.judge(&solved, h, slope);
        if trial.err >= 1.0 {
            let wanted = self.control.reject(h, trial.err, self.system.iterations());
            return Err(Refusal { wanted, finite: true });
        }
        self.step_state.counts.evaluations += 1;
        let end = (self.f)(&trial.y1);
        let finite = trial.err.is_finite() && is_finite(&trial.y1) && is_finite(&end);
        if finite { Ok((trial, end)) } else { Err(Refusal { wanted: 0.5 * h, finite }) }
    }

    /// The step and its error (Hairer & Wanner II, eqs. 8.19, 8.20).
    fn judge(&mut self, Solved { z, scale }: &Solved<N>, h: f64, slope: &[f64; N]) -> Trial<N> {
        let y = &self.step_state.state;
        let defect = self.system.defect(h, slope, z);
        let mut err = norm(&defect, scale);
        if err >= 1.0 && self.control.is_wary() {
            self.step_state.counts.evaluations += 1;
            let moved = (self.f)(&core::array::from_fn(|i| y[i] + defect[i]));
            err = norm(&self.system.defect(h, &moved, z), scale);
        }
        Trial { z: *z, y1: core::array::from_fn(|i| y[i] + z[2][i]), defect, err }
    }

    fn accept(&mut self, trial: &Trial<N>, [h, t1]: [f64; 2]) {
        let defect = trial.defect.map(|x| GAMMA * x);
        self.last.times = [self.step_state.time, t1];
        self.last.terms = dense::coefficients(&self.step_state.state, &trial.z, &defect);
        self.last.jumps = Some(self.step_state.jumps());
        self.last.set_end(trial.y1);
        let next = self.control.accept(h, trial.err.max(LEAST_ERROR), self.system.iterations());
        self.system.move_on();
        self.step_state.accept(t1, trial.y1, next);
    }
}

impl<const N: usize> Last<N> {
    fn set_end(&mut self, y1: [f64; N]) {
        self.terms[1] = core::array::from_fn(|i| y1[i] - self.terms[0][i]);
        self.dense.set_alternating(self.times, y1, self.terms);
    }
}

/// The estimate is O(h⁴), the dense output errs by O(h⁵); 0.1 as in `radau5.f`.
fn for_estimate<const N: usize>(tolerance: &Tolerance<N>) -> Tolerance<N> {
    let relative = tolerance.relative();
    if relative > 0.0 { tolerance.times(0.1 * relative.powf(-0.2)) } else { *tolerance }
}

impl<F: Fn(&[f64; N]) -> [f64; N], const N: usize> Stepper<f64, N> for Radau<'_, F, N> {
    fn step_state(&self) -> &StepState<f64, N> {
        &self.step_state
    }

    fn step_state_mut(&mut self) -> &mut StepState<f64, N> {
        &mut self.step_state
    }

    /// 3 evaluations of f for each iteration, one at the end, and a Jacobian where the last one no
    /// longer serves.
    fn step(&mut self) -> Result<(), StepError> {
        let slope = self.rhs.get(&self.f, &mut self.step_state)?;
        let mut wanted = planned_step(&self.f, &mut self.step_state, &slope, ORDER);
        let mut finite = true;
        loop {
            let followed = self.system.update_jacobian(&mut self.step_state, wanted);
            let (h, t1) = self.step_state.fit(followed, finite)?;
            match self.attempt(h, &slope) {
                Ok((trial, end)) => {
                    self.accept(&trial, [h, t1]);
                    self.rhs.set(end, &self.step_state);
                    return Ok(());
                }
                Err(refusal) => (wanted, finite) = (refusal.wanted, refusal.finite),
            }
            self.control.rejected = true;
            self.step_state.counts.rejected += 1;
        }
    }

    /// No evaluation of f.
    fn dense(&mut self) -> &Dense<f64, N> {
        &self.last.dense
    }

    /// f is evaluated at `y1`.
    fn replace_end(&mut self, y1: [f64; N]) -> Result<(), StepError> {
        (self.step_state.state, self.rhs) = (y1, RhsCache::UNKNOWN);
        self.rhs.get(&self.f, &mut self.step_state)?;
        self.last.set_end(y1);
        Ok(())
    }
}
