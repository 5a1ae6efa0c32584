//! Taylor's method of variable order and step (À. Jorba and M. Zou, *A software package for the
//! numerical integration of ODEs by means of high-order Taylor methods*, Experimental Mathematics
//! 14, 2005).
//!
//! The order follows from the tolerance, the step from the last coefficients. They may mislead,
//! where few terms of a series are there or where f is not analytic within the step. So a step is
//! accepted only if the series satisfies the equations at its end, |h (y′ − f(y))| within the
//! tolerance, at f's value that the next series begins with; else a shorter part of the same series
//! is taken. The series run in θ = (t − t₀)/u, u the length of the last step, so that coefficients
//! neither overflow nor vanish whatever the unit of time.

mod defect;
mod expansion;
#[cfg(feature = "std")]
mod lane_series;
#[cfg(feature = "std")]
mod lane_stepper;
mod phase;
mod step_size;
#[cfg(test)]
mod tests;

pub use expansion::{Expansion, Guards};
#[cfg(feature = "std")]
pub use lane_stepper::{Ended, LaneStepper};
pub(crate) use phase::ExpansionBy;
pub use phase::PhaseExpansion;

use super::{Dense, StepError, StepState, Stepper, is_finite};
use crate::scalar::Real;
use crate::series::ORDERS;
use step_size::StepSize;

/// Steps are shorter than the radius of convergence; its end is nearer than this many of them.
const BEYOND: f64 = 100.0;

/// A step, and the unit of its series, is at most this many times longer than the last: a state of
/// which an entry all but vanishes begins in a unit as much too short, and its power by the highest
/// order is far from overflow.
const LARGEST: f64 = 1e6;

/// An integration by Taylor's method.
pub struct Taylor<E, const N: usize> {
    expansion: E,
    step_state: StepState<f64, N>,
    step_size: StepSize,
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

/// A step that satisfies the equations at its end.
struct Verified<const N: usize> {
    /// How far the series reaches.
    wanted: f64,
    h: f64,
    t1: f64,
    y1: [f64; N],
}

impl<E: Expansion<N>, const N: usize> Taylor<E, N> {
    /// Integrates from where `step_state` is the equations that `expansion` knows.
    pub fn new(expansion: E, step_state: StepState<f64, N>) -> Self {
        let step_size = StepSize::new(&step_state.tolerance, &step_state.state);
        let zero = [0.0; N];
        let dense = Dense::with_room(ORDERS);
        let last =
            Last { t0: step_state.time, t1: step_state.time, ratio: 0.0, y1: zero, dense, is_dense: false };
        Self { expansion, step_state, step_size, unit: None, last }
    }

    /// The order of the series.
    pub fn order(&self) -> usize {
        self.step_size.order
    }

    /// Fills the series, and returns the step that they allow; `None` if a coefficient is not
    /// finite.
    fn expand(&mut self, unit: f64) -> Option<f64> {
        self.expansion.expand(&self.step_state.state, unit, self.step_size.order);
        self.step_state.counts.evaluations += self.step_size.order as u64;
        let series = self.expansion.series();
        let [.., before, last] = &series[..=self.step_size.order] else { return None };
        let finite = is_finite(before) && is_finite(last);
        finite.then(|| self.step_size.compute_theta(series, &self.step_state.tolerance).min(LARGEST))
    }

    /// A length of the first step: the time in which the state changes by its own size.
    fn first_unit(&mut self) -> Result<f64, StepError> {
        let rates = self.expansion.rates(&self.step_state.state);
        self.step_state.counts.evaluations += 1;
        self.step_state.check(&rates)?;
        self.expansion.expand(&self.step_state.state, 1.0, 2);
        self.step_state.counts.evaluations += 1;
        let [y, slope, bend, ..] = *self.expansion.series();
        let rate = step_size::rate(&[y, slope, bend], &self.step_state.tolerance);
        Ok(self.step_state.begin((rate > 0.0).then(|| 1.0 / rate)))
    }

    /// Whether the derivative is finite at θ on the tangent: a step at its floor ends at a pole, or
    /// at the edge of f's domain.
    fn goes_on(&mut self, theta: f64) -> bool {
        let [y, slope, ..] = *self.expansion.series();
        let beyond = core::array::from_fn(|i| Real::mul_add(theta, slope[i], y[i]));
        self.step_state.counts.evaluations += 1;
        is_finite(&self.expansion.rates(&beyond))
    }

    /// The unit of the series, and the longest step that was asked for.
    fn plan(&mut self) -> Result<(f64, f64), StepError> {
        let jump = self.step_state.jumps();
        match (self.unit.filter(|(_, at)| *at == jump), self.step_state.next) {
            (Some((unit, _)), _) => Ok((unit, f64::INFINITY)),
            (None, Some(proposed)) => Ok((proposed, proposed)),
            (None, None) => Ok((self.first_unit()?, f64::INFINITY)),
        }
    }

    /// Σ cₖ θᵏ and its derivative, even and odd terms side by side.
    fn value_and_slope(&self, theta: f64) -> [[f64; N]; 2] {
        let square = theta * theta;
        let [mut even, mut odd, mut even_slope, mut odd_slope] = [[0.0; N]; 4];
        let series = self.expansion.series();
        for pair in series[..(self.step_size.order + 1).next_multiple_of(2)].rchunks_exact(2) {
            for i in 0..N {
                even_slope[i] = Real::mul_add(square, even_slope[i], even[i]);
                odd_slope[i] = Real::mul_add(square, odd_slope[i], odd[i]);
                even[i] = Real::mul_add(square, even[i], pair[0][i]);
                odd[i] = Real::mul_add(square, odd[i], pair[1][i]);
            }
        }
        let slope = |i: usize| {
            let bend = Real::mul_add(theta, odd_slope[i], even_slope[i]);
            Real::mul_add(2.0 * theta, bend, odd[i])
        };
        let value = |i: usize| Real::mul_add(theta, odd[i], even[i]);
        [core::array::from_fn(value), core::array::from_fn(slope)]
    }

    /// The step that the series allows up to `longest` and `wanted`, verified at its end.
    fn verified(&mut self, unit: f64, [longest, wanted]: [f64; 2]) -> Result<Verified<N>, StepError> {
        let mut step = Verified { wanted, h: 0.0, t1: 0.0, y1: [0.0; N] };
        let mut finite = self.step_state.is_above_floor(wanted) || self.goes_on(BEYOND * wanted / unit);
        loop {
            (step.h, step.t1) = self.step_state.fit(step.wanted.min(longest), finite)?;
            let [y1, slope] = self.value_and_slope(step.h / unit);
            let defect = self.defect((unit, step.h), &y1, &slope);
            if defect <= 1.0 {
                return Ok(Verified { y1, ..step });
            }
            finite = defect.is_finite();
            step.wanted = step.h * self.step_size.shorter(defect);
            self.step_state.counts.rejected += 1;
        }
    }
}

impl<E: Expansion<N>, const N: usize> Stepper<f64, N> for Taylor<E, N> {
    fn step_state(&self) -> &StepState<f64, N> {
        &self.step_state
    }

    fn step_state_mut(&mut self) -> &mut StepState<f64, N> {
        &mut self.step_state
    }

    /// As many coefficients of f as the order.
    fn step(&mut self) -> Result<(), StepError> {
        let (mut unit, longest) = self.plan()?;
        let mut theta = self.expand(unit);
        if theta.is_none() {
            self.step_state.check(&self.expansion.series()[1])?;
            // In a unit this small only what is singular here is not finite.
            unit *= f64::EPSILON;
            theta = self.expand(unit);
        }
        let not_finite = StepError::NotFinite { t: self.step_state.time };
        let wanted = theta.ok_or(not_finite)? * unit;
        let Verified { wanted, h, t1, y1 } = self.verified(unit, [longest, wanted])?;
        (self.last.t0, self.last.t1, self.last.ratio) = (self.step_state.time, t1, h / unit);
        (self.last.y1, self.last.is_dense) = (y1, false);
        // Steps may be held short for long, where nothing moves.
        self.unit = Some((wanted.min(LARGEST * h), self.step_state.jumps()));
        self.step_state.accept(t1, y1, wanted);
        Ok(())
    }

    fn dense(&mut self) -> &Dense<f64, N> {
        let Last { t0, t1, ratio, y1, dense, is_dense } = &mut self.last;
        if !*is_dense {
            let mut power = 1.0;
            let series = &self.expansion.series()[..=self.step_size.order];
            // Of a flight under gravity alone few are there.
            let last = series.iter().rposition(|c| c.iter().any(|c| *c != 0.0)).unwrap_or(0).max(1);
            let terms = series[..=last].iter().map(|c| {
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

    fn replace_end(&mut self, y1: [f64; N]) -> Result<(), StepError> {
        self.step_state.state = y1;
        (self.last.y1, self.last.is_dense) = (y1, false);
        Ok(())
    }
}
