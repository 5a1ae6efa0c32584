//! Exact rationals n/d in lowest terms, |n|, d < 2¹²⁷.
//!
//! A result that does not fit, or a division by zero, has the value *overflow*. Like NaN it
//! propagates through every operation, so that one test at the end of a derivation suffices.

mod arithmetic;

use std::cmp::Ordering;
use std::fmt;

/// A reduced fraction of two 128-bit integers, or *overflow*.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: i128,
    /// Positive; 0 marks overflow.
    denominator: i128,
}

impl Rational {
    /// 0.
    pub const ZERO: Self = Self::integer(0);
    /// 1.
    pub const ONE: Self = Self::integer(1);
    /// 1/2.
    pub const HALF: Self = Self { numerator: 1, denominator: 2 };
    /// The value *overflow*.
    pub const OVERFLOW: Self = Self { numerator: 0, denominator: 0 };

    /// n/d in lowest terms; overflow for d = 0.
    pub fn new(n: i128, d: i128) -> Self {
        if d == 0 || n == i128::MIN || d == i128::MIN {
            return Self::OVERFLOW;
        }
        let g = if d.is_negative() { -gcd(n, d) } else { gcd(n, d) };
        Self { numerator: n / g, denominator: d / g }
    }

    /// The integer n.
    pub const fn integer(n: i128) -> Self {
        if n == i128::MIN {
            return Self::OVERFLOW;
        }
        Self { numerator: n, denominator: 1 }
    }

    /// Numerator of the reduced fraction, with its sign; 0 for overflow.
    pub const fn numerator(self) -> i128 {
        self.numerator
    }

    /// Denominator of the reduced fraction, positive; 0 for overflow.
    pub const fn denominator(self) -> i128 {
        self.denominator
    }

    /// Whether it is exactly 0 (overflow is not).
    pub const fn is_zero(self) -> bool {
        self.numerator == 0 && self.denominator == 1
    }

    /// Whether it is the value *overflow*.
    pub const fn is_overflow(self) -> bool {
        self.denominator == 0
    }

    /// |self|.
    pub const fn abs(self) -> Self {
        Self { numerator: self.numerator.abs(), denominator: self.denominator }
    }

    /// −1, 0 or 1; 0 for overflow.
    pub const fn signum(self) -> i32 {
        self.numerator.signum() as i32
    }

    /// Whether it is less than 0; false for overflow.
    pub const fn is_negative(self) -> bool {
        self.numerator.is_negative()
    }

    /// 1/self; overflow for 0.
    pub fn recip(self) -> Self {
        Self::new(self.denominator, self.numerator)
    }

    /// The nearest double up to a few units in the last place; NaN for overflow.
    pub fn to_f64(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }

    /// selfᵏ; 0 to a negative power is overflow.
    pub fn pow(self, k: i32) -> Self {
        let base = if k.is_negative() { self.recip() } else { self };
        let magnitude = k.unsigned_abs();
        let (Some(n), Some(d)) =
            (base.numerator.checked_pow(magnitude), base.denominator.checked_pow(magnitude))
        else {
            return Self::OVERFLOW;
        };
        if base.is_overflow() {
            return Self::OVERFLOW;
        }
        Self::new(n, d)
    }

    /// The rational r ≥ 0 with r² = self, if there is one.
    pub fn sqrt_exact(self) -> Option<Self> {
        if self.is_overflow() || self.is_negative() {
            return None;
        }
        let (n, d) = (self.numerator.isqrt(), self.denominator.isqrt());
        (n * n == self.numerator && d * d == self.denominator).then(|| Self::new(n, d))
    }

    /// The greatest positive rational that divides both an integer number of times; |other| for 0.
    pub(super) fn gcd(self, other: Self) -> Self {
        let common = common_denominator(self, other);
        match (self.denominator / common).checked_mul(other.denominator) {
            Some(d) => Self::new(gcd(self.numerator, other.numerator), d),
            None => Self::OVERFLOW,
        }
    }

    const fn from_checked(n: Option<i128>, d: Option<i128>) -> (i128, i128) {
        match (n, d) {
            (Some(n), Some(d)) => (n, d),
            _ => (0, 0),
        }
    }
}

/// The greatest common divisor of both denominators; 1 for two overflows, so that one may divide by
/// it and a denominator 0 stays 0.
fn common_denominator(a: Rational, b: Rational) -> i128 {
    gcd(a.denominator, b.denominator).max(1)
}

/// Euclid on magnitudes, in machine words where they suffice; gcd(0, b) = |b|.
fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
    while u64::try_from(b).is_err() {
        (a, b) = (b, a % b);
    }
    if b == 0 {
        return a as i128;
    }
    let (mut a, mut b) = (b as u64, (a % b) as u64);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    i128::from(a)
}

impl From<i64> for Rational {
    fn from(n: i64) -> Self {
        Self::integer(i128::from(n))
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// By value; overflow comes last.
impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self.is_overflow(), other.is_overflow()) {
            (false, false) => {
                compare((self.numerator, self.denominator), (other.numerator, other.denominator))
            }
            (left, right) => left.cmp(&right),
        }
    }
}

/// a/b against c/d, b, d > 0, by continued fractions: no product that could overflow.
fn compare((a, b): (i128, i128), (c, d): (i128, i128)) -> Ordering {
    let whole = a.div_euclid(b).cmp(&c.div_euclid(d));
    let (r, s) = (a.rem_euclid(b), c.rem_euclid(d));
    match (whole, r, s) {
        (Ordering::Equal, 0, _) | (Ordering::Equal, _, 0) => r.cmp(&s),
        (Ordering::Equal, _, _) => compare((d, s), (b, r)),
        _ => whole,
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            0 => f.write_str("overflow"),
            1 => write!(f, "{}", self.numerator),
            d => write!(f, "{}/{d}", self.numerator),
        }
    }
}
