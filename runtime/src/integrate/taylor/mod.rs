//! Taylor's method of variable order and step (À. Jorba and M. Zou, *A software package for the numerical integration of
//! ODEs by means of high-order Taylor methods*, Experimental Mathematics 14, 2005).
//!
//! The order follows from the tolerance, the step from the last two coefficients: no step is tried and rejected. The series
//! run in θ = (t − t₀)/u, u the length of the last step, so that coefficients neither overflow nor vanish whatever the unit
//! of time.

#[cfg(feature = "ensemble")]
mod bundle;
mod expansion;
mod phase;
mod reach;
#[cfg(test)]
mod tests;

#[cfg(feature = "ensemble")]
pub use bundle::{Bundle, Ended};
pub use expansion::{Expansion, Guards};
pub use phase::PhaseExpansion;

use super::store::Store;
use super::{Dense, Progress, StepError, Stepper, is_finite};
use crate::scalar::Real;
use crate::series::ORDERS;
use reach::Reach;

/// Steps are shorter than the radius of convergence; its end is nearer than this many of them.
const BEYOND: f64 = 100.0;

/// A step is at most this many times longer than the last.
const LARGEST: f64 = 1e3;

/// An integration by Taylor's method.
pub struct Taylor<E, const N: usize> {
    expansion: E,
    progress: Progress<f64, N>,
    reach: Reach,
    /// y(t₀ + uθ) = Σ cₖ θᵏ.
    series: Store<[[f64; N]; ORDERS]>,
    /// u, and the jump since which it is known.
    unit: Option<(f64, u64)>,
    last: Last<N>,
}

/// The last step: its times, and its length in units of the series.
struct Last<const N: usize> {
    t0: f64,
    t1: f64,
    ratio: f64,
    y1: [f64; N],
    dense: Dense<f64, N>,
    is_dense: bool,
}

impl<E: Expansion<N>, const N: usize> Taylor<E, N> {
    /// Integrates from where `progress` is the equations that `expansion` knows.
    pub fn new(expansion: E, progress: Progress<f64, N>) -> Self {
        let reach = Reach::new(&progress.tolerance, &progress.state);
        let zero = [0.0; N];
        let dense = Dense::with_room(ORDERS);
        let last =
            Last { t0: progress.time, t1: progress.time, ratio: 0.0, y1: zero, dense, is_dense: false };
        Self { expansion, progress, reach, series: Store::new([zero; ORDERS]), unit: None, last }
    }

    /// The order of the series.
    pub fn order(&self) -> usize {
        self.reach.order
    }

    /// Fills the series, and returns the step that they allow; `None` if a coefficient is not finite.
    fn expand(&mut self, unit: f64) -> Option<f64> {
        self.series[0] = self.progress.state;
        self.expansion.expand(unit, self.reach.order, &mut self.series);
        self.progress.counts.evaluations += self.reach.order as u64;
        let [.., before, last] = &self.series[..=self.reach.order] else { return None };
        let finite = is_finite(before) && is_finite(last);
        finite.then(|| self.reach.of(&self.series, &self.progress.tolerance).min(LARGEST))
    }

    /// A length of the first step: the time in which the state changes by its own size.
    fn first_unit(&mut self) -> Result<f64, StepError> {
        self.series[0] = self.progress.state;
        for order in [1, 2] {
            self.expansion.expand(1.0, order, &mut self.series);
            self.progress.counts.evaluations += order as u64;
            self.progress.check(&self.series[1])?;
        }
        let [y, slope, bend] = [self.series[0], self.series[1], self.series[2]];
        let rate = reach::rate(&[y, slope, bend], &self.progress.tolerance);
        Ok(self.progress.begin((rate > 0.0).then(|| 1.0 / rate)))
    }

    /// Whether the derivative is finite at θ on the tangent: a step at its floor ends at a pole, or at the edge of f's domain.
    fn goes_on(&mut self, theta: f64) -> bool {
        let [y, slope, ..] = *self.series;
        let mut beyond = [[0.0; N]; ORDERS];
        beyond[0] = core::array::from_fn(|i| Real::mul_add(theta, slope[i], y[i]));
        self.expansion.expand(1.0, 1, &mut beyond);
        self.progress.counts.evaluations += 1;
        is_finite(&beyond[1])
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
        for pair in self.series[..(self.reach.order + 1).next_multiple_of(2)].rchunks_exact(2) {
            for i in 0..N {
                even[i] = Real::mul_add(square, even[i], pair[0][i]);
                odd[i] = Real::mul_add(square, odd[i], pair[1][i]);
            }
        }
        core::array::from_fn(|i| Real::mul_add(theta, odd[i], even[i]))
    }
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
        let mut theta = self.expand(unit);
        if theta.is_none() {
            self.progress.check(&self.series[1])?;
            // In a unit this small only what is singular here is not finite.
            unit *= f64::EPSILON;
            theta = self.expand(unit);
        }
        let not_finite = StepError::NotFinite { t: self.progress.time };
        let wanted = theta.ok_or(not_finite)? * unit;
        let finite = self.progress.is_above_floor(wanted) || self.goes_on(BEYOND * wanted / unit);
        let (h, t1) = self.progress.fit(wanted.min(longest), finite)?;
        let y1 = self.value(h / unit);
        if !is_finite(&y1) {
            return Err(not_finite);
        }
        (self.last.t0, self.last.t1, self.last.ratio) = (self.progress.time, t1, h / unit);
        (self.last.y1, self.last.is_dense) = (y1, false);
        self.unit = Some((wanted, self.progress.jumps()));
        self.progress.accept(t1, y1, wanted);
        Ok(())
    }

    fn dense(&mut self) -> &Dense<f64, N> {
        let Last { t0, t1, ratio, y1, dense, is_dense } = &mut self.last;
        if !*is_dense {
            let mut power = 1.0;
            let terms = self.series[..=self.reach.order].iter().map(|c| {
                // Zero stays zero where the power overflows.
                let term = c.map(|c| if c == 0.0 { 0.0 } else { c * power });
                power *= *ratio;
                term
            });
            dense.set_powers([*t0, *t1], *y1, terms);
            *is_dense = true;
        }
        dense
    }

    fn guards(&mut self) -> Option<Guards<'_>> {
        self.expansion.guards(self.last.ratio)
    }

    fn amend(&mut self, y1: [f64; N]) -> Result<(), StepError> {
        self.progress.state = y1;
        (self.last.y1, self.last.is_dense) = (y1, false);
        Ok(())
    }
}
