//! Taylor's method of variable order and step (À. Jorba and M. Zou, *A software package for the numerical integration of
//! ODEs by means of high-order Taylor methods*, Experimental Mathematics 14, 2005).
//!
//! The order p follows from the tolerance, the step from the last two coefficients: no step is tried and rejected. The series
//! run in θ = (t − t₀)/u, u the length of the last step, so that coefficients neither overflow nor vanish whatever the unit
//! of time.

mod expansion;
mod phase;
mod radius;
#[cfg(test)]
mod tests;

pub use expansion::{Expansion, Guards};
pub use phase::PhaseExpansion;

use super::{Dense, Progress, StepError, Stepper, Tolerance, is_finite};
use crate::series::ORDERS;

/// A step is at most this many times longer than the last.
const LARGEST: f64 = 1e3;

/// An integration by Taylor's method.
pub struct Taylor<E, const N: usize> {
    expansion: E,
    progress: Progress<f64, N>,
    order: usize,
    /// y(t₀ + uθ) = Σ cₖ θᵏ.
    series: Box<[[f64; N]; ORDERS]>,
    /// u, and the jump since which it is known.
    unit: Option<(f64, u64)>,
    last: Last<N>,
}

/// The last step: its start, its length, and that in units of the series.
struct Last<const N: usize> {
    t0: f64,
    h: f64,
    ratio: f64,
    y1: [f64; N],
    dense: Dense<f64, N>,
    is_dense: bool,
}

impl<E: Expansion<N>, const N: usize> Taylor<E, N> {
    /// Integrates from where `progress` is the equations that `expansion` knows.
    pub fn new(expansion: E, progress: Progress<f64, N>) -> Self {
        let order = order(&progress.tolerance, &progress.state);
        let zero = [0.0; N];
        let dense = Dense::with_room(ORDERS);
        let last = Last { t0: progress.time, h: 0.0, ratio: 0.0, y1: zero, dense, is_dense: false };
        Self { expansion, progress, order, series: Box::new([zero; ORDERS]), unit: None, last }
    }

    /// The order of the series.
    pub fn order(&self) -> usize {
        self.order
    }

    /// What tells contacts apart over the last step, if the expansion has it.
    pub fn guards(&mut self) -> Option<Guards<'_>> {
        self.expansion.guards(self.order, self.last.ratio)
    }

    /// Fills the series, and returns the step that they allow; `None` if a coefficient is not finite.
    fn expand(&mut self, unit: f64) -> Option<f64> {
        self.series[0] = self.progress.state;
        self.expansion.expand(unit, self.order, &mut self.series);
        self.progress.counts.evaluations += self.order as u64;
        let [.., before, last] = &self.series[..=self.order] else { return None };
        let finite = is_finite(before) && is_finite(last);
        finite.then(|| radius::radius(&self.series, self.order, &self.progress.tolerance).min(LARGEST))
    }

    /// A length of the first step: the time in which the state changes by its own size.
    fn first_unit(&mut self) -> Result<f64, StepError> {
        self.series[0] = self.progress.state;
        self.expansion.expand(1.0, 2, &mut self.series);
        self.progress.counts.evaluations += 2;
        self.progress.check(&self.series[1])?;
        let [y, slope, bend] = [self.series[0], self.series[1], self.series[2]];
        let rate = radius::rate(&[y, slope, bend], &self.progress.tolerance);
        Ok(self.progress.begin((rate > 0.0).then(|| 1.0 / rate)))
    }

    /// The unit of the series, and the longest step that was asked for.
    fn plan(&mut self) -> Result<(f64, f64), StepError> {
        let jump = self.progress.jumps();
        match (self.unit.filter(|(_, at)| *at == jump), self.progress.next) {
            (Some((unit, _)), _) => Ok((unit, f64::INFINITY)),
            (None, Some(proposed)) => Ok((proposed, proposed)),
            (None, None) => Ok((self.first_unit()?, f64::INFINITY)),
        }
    }

    /// Σ cₖ θᵏ, even and odd terms side by side.
    fn value(&self, theta: f64) -> [f64; N] {
        let square = theta * theta;
        let [mut even, mut odd] = [[0.0; N]; 2];
        for pair in self.series[..self.order + 1 + (self.order + 1) % 2].rchunks_exact(2) {
            for i in 0..N {
                even[i] = crate::scalar::Real::mul_add(square, even[i], pair[0][i]);
                odd[i] = crate::scalar::Real::mul_add(square, odd[i], pair[1][i]);
            }
        }
        core::array::from_fn(|i| crate::scalar::Real::mul_add(theta, odd[i], even[i]))
    }
}

/// p = 1 − ½ ln ε, ε the tolerance relative to the state (Jorba & Zou, (3–7)).
fn order<const N: usize>(tolerance: &Tolerance<N>, state: &[f64; N]) -> usize {
    let scale = tolerance.scale(state, state);
    let relative = |i: usize| scale[i] / state[i].abs();
    let least = (0..N).map(relative).fold(1.0, f64::min).max(tolerance.relative());
    (1.0 - 0.5 * least.max(f64::MIN_POSITIVE).ln()).ceil().clamp(4.0, (ORDERS - 1) as f64) as usize
}

impl<E: Expansion<N>, const N: usize> Stepper<f64, N> for Taylor<E, N> {
    fn progress(&self) -> &Progress<f64, N> {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress<f64, N> {
        &mut self.progress
    }

    /// As many coefficients of f as the order.
    fn step(&mut self) -> Result<(), StepError> {
        let (mut unit, longest) = self.plan()?;
        let mut radius = self.expand(unit);
        if radius.is_none() {
            self.progress.check(&self.series[1])?;
            // In a unit this small only what is singular here is not finite.
            unit *= f64::EPSILON;
            radius = self.expand(unit);
        }
        let not_finite = StepError::NotFinite { t: self.progress.time };
        let wanted = radius.ok_or(not_finite)? * unit;
        let (h, t1) = self.progress.fit(wanted.min(longest), true)?;
        let y1 = self.value(h / unit);
        if !is_finite(&y1) {
            return Err(not_finite);
        }
        (self.last.t0, self.last.h, self.last.ratio) = (self.progress.time, h, h / unit);
        (self.last.y1, self.last.is_dense) = (y1, false);
        self.unit = Some((wanted, self.progress.jumps()));
        self.progress.accept(t1, y1, wanted);
        Ok(())
    }

    fn dense(&mut self) -> &Dense<f64, N> {
        let Last { t0, h, ratio, y1, dense, is_dense } = &mut self.last;
        if !*is_dense {
            let mut power = 1.0;
            let terms = self.series[..=self.order].iter().map(|c| {
                let term = c.map(|c| c * power);
                power *= *ratio;
                term
            });
            dense.set_powers([*t0, *h], *y1, terms);
            *is_dense = true;
        }
        dense
    }

    fn amend(&mut self, y1: [f64; N]) -> Result<(), StepError> {
        self.progress.state = y1;
        (self.last.y1, self.last.is_dense) = (y1, false);
        Ok(())
    }
}
