//! Truncated Taylor series x(t) = Σ cₖ tᵏ, k < K, with the recurrences of
//! Moore, *Methods and Applications of Interval Analysis* (1979), ch. 3:
//! each operation is one convolution per coefficient.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Real, Scalar};

/// Taylor coefficients `c[0..K]`; the k-th derivative is `k! · c[k]`. `K` is at least 1.
///
/// At zeros roots and quotients are one-sided, for t ≥ 0: `√(c t² + …) = √c t √(1 + …)`, `0/0` the
/// quotient of what follows. The orders that this takes from the end of the series are zero.
///
/// Order and equality are those of the leading coefficient, so that control flow takes the branch
/// that the value takes.
#[derive(Clone, Copy, Debug)]
pub struct Jet<S, const K: usize>([S; K]);

impl<S: Real, const K: usize> Jet<S, K> {
    /// The series with these Taylor coefficients.
    pub const fn new(coefficients: [S; K]) -> Self {
        const { assert!(K > 0, "a jet has at least its value") };
        Self(coefficients)
    }

    /// A value that does not vary.
    #[inline]
    pub fn constant(value: S) -> Self {
        let mut series = Self::new([S::ratio(0, 1); K]);
        series.0[0] = value;
        series
    }

    /// `c[k]`; `k < K`.
    #[inline]
    pub fn coefficient(&self, k: usize) -> S {
        self.0[k]
    }

    /// The `k`-th derivative at the point of expansion, `k! · c[k]`; `k < K`.
    #[inline]
    pub fn derivative(&self, k: usize) -> S {
        (2..=k as i64).fold(self.0[k], |c, i| c * S::ratio(i, 1))
    }

    /// q b = a, solved for one coefficient after the other.
    #[inline]
    fn quotient(self, divisor: &Self) -> Self {
        if self.0[0].is_zero() && divisor.0[0].is_zero() && divisor.order() < K {
            return self.over_power(1).quotient(&divisor.over_power(1));
        }
        let (mut q, b) = (self.0, &divisor.0);
        for n in 0..K {
            q[n] = (1..=n).fold(q[n], |sum, k| (-b[k]).mul_add(q[n - k], sum)) / b[0];
        }
        Self(q)
    }

    /// f of this series, by f′ = g x′: `slope` gives coefficient n of g from the first n + 1 of f.
    #[inline]
    fn integral(self, value: S, slope: impl Fn(usize, &[S; K]) -> S) -> Self {
        let zero = S::ratio(0, 1);
        let (mut f, mut g) = ([zero; K], [zero; K]);
        f[0] = value;
        for n in 1..K {
            g[n - 1] = slope(n - 1, &f);
            let sum = (1..=n).fold(zero, |sum, k| (S::ratio(k as i64, 1) * self.0[k]).mul_add(g[n - k], sum));
            f[n] = sum / S::ratio(n as i64, 1);
        }
        Self(f)
    }

    /// The order of the first coefficient that is not zero; K where all are.
    #[inline]
    fn order(&self) -> usize {
        self.0.iter().take_while(|c| c.is_zero()).count()
    }

    /// The series over tᵏ, of which the first k coefficients are zero.
    #[inline]
    fn over_power(&self, k: usize) -> Self {
        Self(core::array::from_fn(|n| self.0.get(n + k).copied().unwrap_or(S::ratio(0, 1))))
    }

    /// The series times tᵏ.
    #[inline]
    fn times_power(&self, k: usize) -> Self {
        Self(core::array::from_fn(|n| n.checked_sub(k).map_or(S::ratio(0, 1), |n| self.0[n])))
    }

    #[inline]
    fn map(self, op: impl Fn(S) -> S) -> Self {
        Self(self.0.map(op))
    }

    #[inline]
    fn zip(self, other: Self, op: impl Fn(S, S) -> S) -> Self {
        Self(core::array::from_fn(|k| op(self.0[k], other.0[k])))
    }
}

impl<S: Real, const K: usize> Add for Jet<S, K> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<S: Real, const K: usize> Sub for Jet<S, K> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<S: Real, const K: usize> Neg for Jet<S, K> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|c| -c)
    }
}

impl<S: Real, const K: usize> Mul for Jet<S, K> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (&self.0, &other.0);
        Self(core::array::from_fn(|n| (0..n).fold(a[n] * b[0], |sum, k| a[k].mul_add(b[n - k], sum))))
    }
}

impl<S: Real, const K: usize> Div for Jet<S, K> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        self.quotient(&other)
    }
}

impl<S: Real, const K: usize> Real for Jet<S, K> {
    #[inline]
    fn ratio(p: i64, q: i64) -> Self {
        Self::constant(S::ratio(p, q))
    }

    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::constant(S::from_f64(x))
    }

    #[inline]
    fn pi() -> Self {
        Self::constant(S::pi())
    }

    #[inline]
    fn sqrt(self) -> Self {
        if self.0[0].is_zero() {
            let order = self.order();
            if order == K {
                return self;
            } else if order.is_multiple_of(2) {
                let root = self.over_power(order).sqrt().times_power(order / 2);
                return Self(core::array::from_fn(|n| {
                    if n < K - order / 2 { root.0[n] } else { S::ratio(0, 1) }
                }));
            }
        }
        let mut r = self.0;
        r[0] = r[0].sqrt();
        let twice = r[0] + r[0];
        for n in 1..K {
            r[n] = (1..n).fold(r[n], |sum, k| (-r[k]).mul_add(r[n - k], sum)) / twice;
        }
        Self(r)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let zero = S::ratio(0, 1);
        let rate: [S; K] = core::array::from_fn(|k| S::ratio(k as i64, 1) * self.0[k]);
        let (mut s, mut c) = ([zero; K], [zero; K]);
        (s[0], c[0]) = self.0[0].sin_cos();
        for n in 1..K {
            let (mut ds, mut dc) = (zero, zero);
            for k in 1..=n {
                ds = rate[k].mul_add(c[n - k], ds);
                dc = rate[k].mul_add(s[n - k], dc);
            }
            let order = S::ratio(n as i64, 1);
            (s[n], c[n]) = (ds / order, -dc / order);
        }
        (Self(s), Self(c))
    }

    #[inline]
    fn exp(self) -> Self {
        let value = self.0[0].exp();
        self.integral(value, |n, known| known[n])
    }

    #[inline]
    fn ln(self) -> Self {
        let slope = Self::ratio(1, 1) / self;
        self.integral(self.0[0].ln(), |n, _| slope.0[n])
    }

    #[inline]
    fn tanh(self) -> Self {
        self.integral(self.0[0].tanh(), |n, known| {
            let square = (0..=n).fold(S::ratio(0, 1), |sum, k| known[k].mul_add(known[n - k], sum));
            S::ratio(i64::from(n == 0), 1) - square
        })
    }

    #[inline]
    fn atan(self) -> Self {
        let one = Self::ratio(1, 1);
        let slope = one / (one + self * self);
        self.integral(self.0[0].atan(), |n, _| slope.0[n])
    }

    fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5] {
        self.0[0].piece(knots, pieces).map(Self::constant)
    }

    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(core::array::from_fn(|n| (0..=n).fold(b.0[n], |sum, k| self.0[k].mul_add(a.0[n - k], sum))))
    }
}

impl<S: PartialEq, const K: usize> PartialEq for Jet<S, K> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.0[0] == other.0[0]
    }
}

impl<S: PartialOrd, const K: usize> PartialOrd for Jet<S, K> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0[0].partial_cmp(&other.0[0])
    }
}

impl<S: Scalar, const K: usize> Scalar for Jet<S, K> {
    const ZERO: Self = Self::new([S::ZERO; K]);
    const EPSILON: Self = {
        let mut coefficients = [S::ZERO; K];
        coefficients[0] = S::EPSILON;
        Self::new(coefficients)
    };

    #[inline]
    fn abs(self) -> Self {
        if self.0[0] < S::ZERO { -self } else { self }
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.0[0].to_f64()
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.0.into_iter().all(S::is_finite)
    }
}
