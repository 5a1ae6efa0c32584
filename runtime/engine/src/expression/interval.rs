//! Interval arithmetic: bounds of a function over all arguments in an interval (Moore, Kearfott and
//! Cloud, *Introduction to Interval Analysis*, 2009). Bounds are rounded outwards.

use crate::numerics::zero::roundoff;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Roundings that one operation may have made, relative.
const ROUNDING: f64 = roundoff(4.0);

/// All numbers from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Interval {
    /// All numbers.
    pub(crate) const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
    pub(crate) const ZERO: Self = Self::exactly(0.0);

    pub(crate) const fn exactly(x: f64) -> Self {
        Self { low: x, high: x }
    }

    /// From one bound to the other, rounded outwards; all numbers where a bound is none.
    pub(crate) fn new(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::WHOLE;
        }
        let widened = |x: f64, sign: f64| if x.is_finite() { x + sign * (ROUNDING * x.abs()) } else { x };
        Self { low: widened(low, -1.0), high: widened(high, 1.0) }
    }

    /// All numbers within a distance of one.
    pub(crate) fn around(middle: f64, reach: f64) -> Self {
        Self::new(middle - reach, middle + reach)
    }

    /// The bounds of some values.
    fn hull(values: impl IntoIterator<Item = f64>) -> Self {
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY];
        for x in values {
            if x.is_nan() {
                return Self::WHOLE;
            }
            bounds = [bounds[0].min(x), bounds[1].max(x)];
        }
        Self::new(bounds[0], bounds[1])
    }

    pub(crate) fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    pub(crate) fn middle(self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// The largest distance from zero.
    pub(crate) fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// The bounds of both.
    pub(crate) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub(crate) fn negated(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        Self::new(self.low + other.low, self.high + other.high)
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    pub(crate) fn times(self, other: Self) -> Self {
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let [a, b, c, d] = [self.low, self.high, other.low, other.high];
        Self::hull([product(a, c), product(a, d), product(b, c), product(b, d)])
    }

    /// 1/x; all numbers where x may be zero.
    pub(crate) fn reciprocal(self) -> Self {
        if self.contains(0.0) { Self::WHOLE } else { Self::new(1.0 / self.high, 1.0 / self.low) }
    }

    pub(crate) fn abs(self) -> Self {
        if self.contains(0.0) {
            return Self { low: 0.0, high: self.size() };
        }
        if self.low > 0.0 { self } else { self.negated() }
    }

    /// √x; all numbers where x may have none.
    pub(crate) fn sqrt(self) -> Self {
        if self.low < 0.0 { Self::WHOLE } else { Self::new(self.low.sqrt(), self.high.sqrt()) }
    }

    pub(crate) fn cos(self) -> Self {
        let is_short = self.high - self.low < TAU && self.size() <= 1.0 / ROUNDING;
        if !is_short {
            return Self { low: -1.0, high: 1.0 };
        }
        // What rounding of the argument may change.
        let slack = ROUNDING * (1.0 + self.size());
        let ends = Self::hull([self.low.cos(), self.high.cos()]);
        let within =
            |at: f64| ((self.high + slack - at) / TAU).floor() >= ((self.low - slack - at) / TAU).ceil();
        Self {
            low: if within(PI) { -1.0 } else { (ends.low - slack).max(-1.0) },
            high: if within(0.0) { 1.0 } else { (ends.high + slack).min(1.0) },
        }
    }

    pub(crate) fn sin(self) -> Self {
        self.minus(Self::exactly(FRAC_PI_2)).cos()
    }

    /// xⁿ for a whole exponent.
    pub(crate) fn powi(self, n: i32) -> Self {
        if n < 0 {
            return self.powi(-n).reciprocal();
        }
        let base = if n % 2 == 0 { self.abs() } else { self };
        Self::hull([base.low.powi(n), base.high.powi(n)])
    }

    /// xⁿ for any exponent, of numbers that are not negative.
    pub(crate) fn powf(self, n: f64) -> Self {
        if self.low < 0.0 || self.low == 0.0 && n < 0.0 {
            return Self::WHOLE;
        }
        Self::hull([self.low.powf(n), self.high.powf(n)]).widened()
    }

    pub(crate) fn exp(self) -> Self {
        Self::hull([self.low.exp(), self.high.exp()]).widened()
    }

    /// log x; all numbers where x may have none.
    pub(crate) fn ln(self) -> Self {
        if self.low <= 0.0 { Self::WHOLE } else { Self::hull([self.low.ln(), self.high.ln()]).widened() }
    }

    pub(crate) fn tanh(self) -> Self {
        Self::hull([self.low.tanh(), self.high.tanh()]).widened()
    }

    pub(crate) fn atan(self) -> Self {
        Self::hull([self.low.atan(), self.high.atan()]).widened()
    }

    /// The directions of (x, y), y being this.
    pub(crate) fn atan2(self, x: Self) -> Self {
        if x.low <= 0.0 && self.contains(0.0) {
            return Self::around(0.0, PI);
        }
        let corner = |y: f64| [y.atan2(x.low), y.atan2(x.high)];
        Self::hull([corner(self.low), corner(self.high)].concat()).widened()
    }

    /// Bounds of what the library rounds less well than the basic operations.
    fn widened(self) -> Self {
        let Self { low, high } = self;
        Self { low: low - 4.0 * ROUNDING * low.abs(), high: high + 4.0 * ROUNDING * high.abs() }
    }
}

#[cfg(test)]
mod tests {
    use super::Interval;
    use proptest::prelude::*;

    fn interval() -> impl Strategy<Value = (Interval, f64)> {
        let bound = prop_oneof![-10.0..10.0f64, -1e-3..1e-3f64, -1e6..1e6f64, Just(0.0)];
        (bound.clone(), bound, 0.0..=1.0f64).prop_map(|(a, b, part)| {
            let [low, high] = [a.min(b), a.max(b)];
            (Interval { low, high }, (low + part * (high - low)).clamp(low, high))
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// What holds of numbers holds of their bounds.
        #[test]
        fn bounds_contain_all_values((a, x) in interval(), (b, y) in interval(), n in -4..5i32, p in -2.0..3.0f64) {
            let holds = [
                (a.plus(b), x + y),
                (a.minus(b), x - y),
                (a.times(b), x * y),
                (a.reciprocal(), 1.0 / x),
                (a.abs(), x.abs()),
                (a.sqrt(), x.sqrt()),
                (a.sin(), x.sin()),
                (a.cos(), x.cos()),
                (a.powi(n), x.powi(n)),
                (a.powf(p), x.powf(p)),
                (a.exp(), x.exp()),
                (a.ln(), x.ln()),
                (a.tanh(), x.tanh()),
                (a.atan(), x.atan()),
                (a.atan2(b), x.atan2(y)),
            ];
            for (k, (bounds, value)) in holds.into_iter().enumerate() {
                prop_assert!(!value.is_finite() || bounds.contains(value), "{k}: {a:?} {b:?} {bounds:?} {value:e}");
            }
        }
    }
}
