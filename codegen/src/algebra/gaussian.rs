//! Gaussian rationals a + b i, the coefficients of series in z = e^{i angle}.

use super::Rational;
use std::ops::{Mul, Sub};

/// a + b i; overflow if either part is.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) struct Gaussian {
    pub(super) re: Rational,
    pub(super) im: Rational,
}

impl Gaussian {
    pub(super) const ZERO: Self = Self::new(Rational::ZERO, Rational::ZERO);

    pub(super) const fn new(re: Rational, im: Rational) -> Self {
        Self { re, im }
    }

    pub(super) fn is_zero(self) -> bool {
        self.re.is_zero() && self.im.is_zero()
    }

    pub(super) fn is_overflow(self) -> bool {
        [self.re, self.im].iter().any(|part| part.is_overflow())
    }

    /// 1/(a + b i) = (a − b i)/(a² + b²).
    pub(super) fn recip(self) -> Self {
        let square = (self.re * self.re + self.im * self.im).recip();
        Self::new(self.re * square, -self.im * square)
    }
}

impl Mul for Gaussian {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

impl Sub for Gaussian {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}
