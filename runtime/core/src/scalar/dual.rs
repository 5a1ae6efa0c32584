//! Values with their gradient: x + ẋ·ε with ε² = 0, the forward mode of Griewank and Walther,
//! *Evaluating Derivatives*, 2nd ed. (2008), table 3.3.
//!
//! Quotients and functions stay out of line: emitted code is long, and is compiled once more for
//! these numbers.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Real, Scalar};

/// A value and its derivatives with respect to `N` variables.
///
/// Order and equality are those of the value, so that control flow takes the branch that the value
/// takes.
#[derive(Clone, Copy, Debug)]
pub struct Dual<S, const N: usize> {
    value: S,
    gradient: [S; N],
}

/// One width for all that is differentiated: emitted code is compiled for it once.
pub type Dual4 = Dual<f64, 4>;

impl<S: Real, const N: usize> Dual<S, N> {
    /// A value with these derivatives.
    pub const fn new(value: S, gradient: [S; N]) -> Self {
        Self { value, gradient }
    }

    /// A value that does not vary.
    pub fn constant(value: S) -> Self {
        Self::new(value, [S::ratio(0, 1); N])
    }

    /// Variable `i`, or a constant if there is none.
    pub fn variable(value: S, i: usize) -> Self {
        Self::new(value, core::array::from_fn(|j| S::ratio(i64::from(i == j), 1)))
    }

    /// The value.
    pub fn value(&self) -> S {
        self.value
    }

    /// Its derivatives.
    pub fn gradient(&self) -> &[S; N] {
        &self.gradient
    }

    /// A function with this value and derivative.
    fn chain(&self, value: S, slope: S) -> Self {
        Self::new(value, self.gradient.map(|dx| slope * dx))
    }
}

impl<S: Real, const N: usize> Add for Dual<S, N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = |i: usize| self.gradient[i] + other.gradient[i];
        Self::new(self.value + other.value, core::array::from_fn(sum))
    }
}

impl<S: Real, const N: usize> Sub for Dual<S, N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let difference = |i: usize| self.gradient[i] - other.gradient[i];
        Self::new(self.value - other.value, core::array::from_fn(difference))
    }
}

impl<S: Real, const N: usize> Neg for Dual<S, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, self.gradient.map(|dx| -dx))
    }
}

impl<S: Real, const N: usize> Mul for Dual<S, N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = |i: usize| self.value.mul_add(other.gradient[i], self.gradient[i] * other.value);
        Self::new(self.value * other.value, core::array::from_fn(product))
    }
}

impl<S: Real, const N: usize> Div for Dual<S, N> {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let rate = |i: usize| (-quotient).mul_add(other.gradient[i], self.gradient[i]) / other.value;
        Self::new(quotient, core::array::from_fn(rate))
    }
}

impl<S: Real, const N: usize> Real for Dual<S, N> {
    fn ratio(p: i64, q: i64) -> Self {
        Self::constant(S::ratio(p, q))
    }

    fn from_f64(x: f64) -> Self {
        Self::constant(S::from_f64(x))
    }

    fn pi() -> Self {
        Self::constant(S::pi())
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let slope = S::ratio(1, 2) / root;
        // √(x x) at x = 0: what does not change the radicand at zero does not change the root.
        Self::new(root, self.gradient.map(|dx| if dx.is_zero() { dx } else { dx * slope }))
    }

    #[inline(never)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    #[inline(never)]
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }

    #[inline(never)]
    fn ln(self) -> Self {
        self.chain(self.value.ln(), S::ratio(1, 1) / self.value)
    }

    #[inline(never)]
    fn tanh(self) -> Self {
        let value = self.value.tanh();
        self.chain(value, S::ratio(1, 1) - value * value)
    }

    #[inline(never)]
    fn atan(self) -> Self {
        let below = S::ratio(1, 1) + self.value * self.value;
        self.chain(self.value.atan(), S::ratio(1, 1) / below)
    }

    fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5] {
        self.value.piece(knots, pieces).map(Self::constant)
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        let rate = |i: usize| {
            let scaled = self.gradient[i].mul_add(a.value, b.gradient[i]);
            self.value.mul_add(a.gradient[i], scaled)
        };
        Self::new(self.value.mul_add(a.value, b.value), core::array::from_fn(rate))
    }
}

impl<S: PartialEq, const N: usize> PartialEq for Dual<S, N> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<S: PartialOrd, const N: usize> PartialOrd for Dual<S, N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<S: Scalar, const N: usize> Scalar for Dual<S, N> {
    const ZERO: Self = Self::new(S::ZERO, [S::ZERO; N]);
    const EPSILON: Self = Self::new(S::EPSILON, [S::ZERO; N]);
    const DIFFERENTIATED: bool = S::PLAIN;

    fn abs(self) -> Self {
        if self.value < S::ZERO { -self } else { self }
    }

    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    fn scaled(self, x: f64) -> Self {
        Self::new(self.value.scaled(x), self.gradient.map(|dx| dx.scaled(x)))
    }

    fn is_finite(self) -> bool {
        self.value.is_finite() && self.gradient.into_iter().all(S::is_finite)
    }
}
