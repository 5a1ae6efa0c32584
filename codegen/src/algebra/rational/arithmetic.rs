//! + − · ÷ on rationals, common divisors taken out before multiplying so that little overflows.

use super::{Rational, common_denominator, gcd};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

impl Add for Rational {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.denominator == 1 && other.denominator == 1 {
            return match self.numerator.checked_add(other.numerator) {
                Some(n) => Self::integer(n),
                None => Self::OVERFLOW,
            };
        }
        let common = common_denominator(self, other);
        let (left, right) = (other.denominator / common, self.denominator / common);
        let sum = match (self.numerator.checked_mul(left), other.numerator.checked_mul(right)) {
            (Some(a), Some(b)) => a.checked_add(b),
            _ => None,
        };
        let (n, d) = Self::from_checked(sum, self.denominator.checked_mul(left));
        Self::new(n, d)
    }
}

impl Mul for Rational {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_overflow() || other.is_overflow() {
            return Self::OVERFLOW;
        }
        let (g, h) = (gcd(self.numerator, other.denominator), gcd(other.numerator, self.denominator));
        let n = (self.numerator / g).checked_mul(other.numerator / h);
        let d = (self.denominator / h).checked_mul(other.denominator / g);
        let (numerator, denominator) = Self::from_checked(n, d);
        if numerator == i128::MIN {
            return Self::OVERFLOW;
        }
        Self { numerator, denominator }
    }
}

impl Neg for Rational {
    type Output = Self;
    fn neg(self) -> Self {
        Self { numerator: -self.numerator, denominator: self.denominator }
    }
}

impl Sub for Rational {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Div for Rational {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.mul(other.recip())
    }
}

impl AddAssign for Rational {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
