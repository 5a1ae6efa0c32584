//! Double precision.

use super::{Real, Scalar};

impl Real for f64 {
    #[inline]
    fn ratio(p: i64, q: i64) -> Self {
        p as f64 / q as f64
    }

    #[inline]
    fn from_f64(x: f64) -> Self {
        x
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }

    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        if cfg!(target_feature = "fma") { self.mul_add(a, b) } else { self * a + b }
    }
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;
    const EPSILON: Self = f64::EPSILON;

    #[inline]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.is_finite()
    }
}
