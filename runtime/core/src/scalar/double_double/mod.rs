//! Unevaluated sums of two doubles, about 31 digits.
//!
//! Dekker, *Numer. Math.* 18 (1971) 224; algorithms and error bounds from Joldes, Muller, Popescu,
//! *ACM TOMS* 44 (2017) 15 and Lefèvre et al., *ACM TOMS* 49 (2023) 4: relative error at most 3u²
//! of a sum, 4u² of a product, 10u² of a quotient, 25/8 u² of a root, u = 2⁻⁵³. All but the
//! smallest operations are calls: emitted code for this scalar would else take as long to compile
//! as it takes digits.

mod exponential;
mod sin_cos;

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::library::Library;
use super::{Real, Scalar};

/// `hi + lo` with `hi` the double nearest to the sum. Overflow gives NaN.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

impl DoubleDouble {
    /// The sum `hi + lo`, exactly unless both are large and far apart.
    #[inline]
    pub fn new(hi: f64, lo: f64) -> Self {
        two_sum(hi, lo)
    }

    /// The nearest double.
    #[inline]
    pub const fn hi(self) -> f64 {
        self.hi
    }

    /// What [`hi`](Self::hi) leaves.
    #[inline]
    pub const fn lo(self) -> f64 {
        self.lo
    }

    fn from_i64(n: i64) -> Self {
        let hi = n as f64;
        let lo = (i128::from(n) - hi as i128) as f64;
        Self { hi, lo }
    }

    #[inline]
    fn scale(self, x: f64) -> Self {
        let product = two_product(self.hi, x);
        fast_two_sum(product.hi, Library::mul_add(self.lo, x, product.lo))
    }

    #[inline]
    fn divide_by(self, x: f64) -> Self {
        let quotient = self.hi / x;
        let product = two_product(quotient, x);
        let rest = (self.hi - product.hi) - product.lo + self.lo;
        fast_two_sum(quotient, rest / x)
    }
}

/// `a + b` exactly.
#[inline]
fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let part = hi - a;
    let lo = (a - (hi - part)) + (b - part);
    DoubleDouble { hi, lo }
}

/// `a + b` exactly, for |a| ≥ |b|.
#[inline]
fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// `a · b` exactly; the library rounds once on every target.
#[inline]
fn two_product(a: f64, b: f64) -> DoubleDouble {
    let hi = a * b;
    DoubleDouble { hi, lo: Library::mul_add(a, b, -hi) }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let sum = fast_two_sum(high.hi, high.lo + low.hi);
        fast_two_sum(sum.hi, low.lo + sum.lo)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.hi, other.hi);
        let cross =
            Library::mul_add(self.hi, other.lo, Library::mul_add(self.lo, other.hi, self.lo * other.lo));
        fast_two_sum(product.hi, product.lo + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other.scale(first);
        let second = rest.hi / other.hi;
        let third = (rest - other.scale(second)).hi / other.hi;
        let head = fast_two_sum(first, second);
        fast_two_sum(head.hi, head.lo + third)
    }
}

impl Real for DoubleDouble {
    #[inline(never)]
    fn ratio(p: i64, q: i64) -> Self {
        Self::from_i64(p) / Self::from_i64(q)
    }

    #[inline]
    fn from_f64(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }

    fn pi() -> Self {
        Self { hi: core::f64::consts::PI, lo: 2.0 * sin_cos::HALF_PI[1] }
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        let root = Real::sqrt(self.hi);
        if root == 0.0 {
            return self;
        }
        let rest = Library::mul_add(-root, root, self.hi) + self.lo;
        fast_two_sum(root, rest / (2.0 * root))
    }

    #[inline(never)]
    fn sin_cos(self) -> (Self, Self) {
        sin_cos::sin_cos(self)
    }

    #[inline(never)]
    fn exp(self) -> Self {
        exponential::exp(self)
    }

    #[inline(never)]
    fn ln(self) -> Self {
        exponential::ln(self)
    }

    #[inline(never)]
    fn tanh(self) -> Self {
        exponential::tanh(self)
    }

    fn atan(self) -> Self {
        exponential::atan(self)
    }

    fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5] {
        let piece = knots.partition_point(|knot| Self::from_f64(*knot) <= self);
        let [a, b, c, d] = pieces[piece];
        [knots[piece.saturating_sub(1)], a, b, c, d].map(Self::from_f64)
    }

    #[inline(never)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
}

impl Scalar for DoubleDouble {
    const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    /// 4u² = 2⁻¹⁰⁴, the bound of a product's error.
    const EPSILON: Self = Self { hi: f64::EPSILON * f64::EPSILON, lo: 0.0 };

    #[inline]
    fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.hi
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.hi.is_finite() && self.lo.is_finite()
    }
}
