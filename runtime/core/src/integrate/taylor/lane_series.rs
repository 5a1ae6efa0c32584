//! The Taylor series of [`LANES`] motions side by side, their lengths and their values: what is
//! computed in vectors.
//!
//! All of it is inlined: see [`Inside`](crate::scalar::Inside).

use super::step_size::{LAST, SPARSENESS, SYMMETRY};
use crate::model::{BarSystem, PhaseSeries};
use crate::scalar::{LANES, Lanes, Real, Vector};
use crate::series::{ORDERS, TaylorTape};

/// One number of each motion.
pub(super) type Each<X> = Lanes<1, X>;

/// y(t₀ + uθ) = Σ cₖ θᵏ of each motion, at one relative tolerance.
pub(super) struct LaneSeries<M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize> {
    pub(super) constants: M::Constants<Each<X>>,
    tape: Box<Q::Columns<Each<X>>>,
    coefficients: Box<[[Each<X>; N]; ORDERS]>,
    pub(super) order: usize,
    relative: f64,
    /// log₂ of the relative tolerance, and of the part of it that the last term may have.
    logarithms: [f64; 2],
    pub(super) absolute: [Each<X>; N],
    pub(super) state: [Each<X>; N],
    /// u, the length of the last step.
    pub(super) unit: Each<X>,
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize> LaneSeries<M, Q, X, N> {
    pub(super) fn new(constants: M::Constants<Each<X>>, relative: f64) -> Self {
        let zero = Each::splat(0.0);
        Self {
            constants,
            tape: Box::default(),
            coefficients: Box::new([[zero; N]; ORDERS]),
            order: order(relative),
            relative,
            logarithms: [relative.log2(), relative.log2() + LAST.log2()],
            absolute: [Each::splat(1.0); N],
            state: [zero; N],
            unit: zero,
        }
    }

    #[inline(always)]
    pub(super) fn expand(&mut self) {
        let Self { constants, tape, coefficients, unit, .. } = self;
        coefficients[0] = self.state;
        let mut state = Q::order(constants, &mut tape.values(), &self.state).rates;
        scale(&mut state, *unit);
        coefficients[1] = state;
        for n in 1..self.order {
            let part = *unit * Each::splat(1.0 / (n + 1) as f64);
            state = Q::order(constants, &mut tape.coefficients(n), &state).rates;
            scale(&mut state, part);
            coefficients[n + 1] = state;
        }
    }

    /// θ up to which each series meets the tolerance, as for one motion; of those that go less than
    /// half as far as the last, once more with the state's size there.
    #[inline(always)]
    pub(super) fn step_size(&self) -> [f64; LANES] {
        let mut theta = Each::splat(1.0);
        let mut size = [1.0; LANES];
        // Twice the same code, not two copies of it.
        for again in [false, true] {
            theta = self.step_size_within(theta);
            for (size, theta) in size.iter_mut().zip(theta.to_array()) {
                *size = if again && *size >= 0.5 { *size } else { theta };
            }
            if size.iter().all(|theta| *theta >= 0.5) {
                break;
            }
        }
        size
    }

    #[inline(always)]
    fn step_size_within(&self, theta: Each<X>) -> Each<X> {
        let (p, relative) = (self.order, Each::splat(self.relative));
        let mut inverse = self.absolute;
        for i in 0..N {
            let end = theta.mul_add(self.coefficients[1][i].abs(), self.coefficients[0][i].abs());
            inverse[i] = Each::splat(1.0) / relative.mul_add(end, self.absolute[i]);
        }
        let part = Each::splat(self.logarithms[1] / p as f64);
        let mut reach = Each::splat(f64::INFINITY);
        for (back, slack) in [(0, 0.0), (2, SYMMETRY), (4, SPARSENESS)] {
            if back < 4 || p > 4 {
                let pair = self.radius(p - back, &inverse).min(self.radius(p - back - 1, &inverse));
                reach = reach.min(pair + Each::splat(slack));
            }
        }
        (reach + part).rough_exp2()
    }

    /// log₂ of the radius that the k-th coefficient allows.
    #[inline(always)]
    fn radius(&self, k: usize, inverse: &[Each<X>; N]) -> Each<X> {
        let mut size = Each::splat(f64::MIN_POSITIVE);
        for (c, inverse) in self.coefficients[k].iter().zip(inverse) {
            size = size.max(c.abs() * *inverse);
        }
        (size.rough_log2() + Each::splat(self.logarithms[0])) * Each::splat(-1.0 / k as f64)
    }

    /// Whether the last two coefficients are finite.
    #[inline(always)]
    pub(super) fn are_finite(&self) -> [bool; LANES] {
        let mut sum = Each::splat(0.0);
        for c in self.coefficients[self.order - 1..=self.order].iter().flatten() {
            sum = sum + c.abs();
        }
        sum.to_array().map(f64::is_finite)
    }

    /// Σ cₖ θᵏ, even and odd terms side by side; the order is even.
    #[inline(always)]
    pub(super) fn value(&self, theta: Each<X>) -> [Each<X>; N] {
        let square = theta * theta;
        let (mut even, mut odd) = (self.coefficients[self.order], [Each::splat(0.0); N]);
        for pair in self.coefficients[..self.order].rchunks_exact(2) {
            for i in 0..N {
                odd[i] = odd[i].mul_add(square, pair[1][i]);
                even[i] = even[i].mul_add(square, pair[0][i]);
            }
        }
        for i in 0..N {
            even[i] = odd[i].mul_add(theta, even[i]);
        }
        even
    }
}

#[inline(always)]
fn scale<X: Vector, const N: usize>(values: &mut [Each<X>; N], factor: Each<X>) {
    for value in values {
        *value = factor * *value;
    }
}

/// p = 4 − 0.55 ln ε, even as two orders are summed at once. Of four hundred double pendula at ε =
/// 1e-9, 13.8, 15.9, 16.8 and 16.8 thousand were done in a second at p = 12, 14, 16 and 18.
fn order(relative: f64) -> usize {
    let half = 0.5 * (4.0 - 0.55 * relative.ln());
    (2 * half.round() as usize).clamp(4, ORDERS - 2)
}
