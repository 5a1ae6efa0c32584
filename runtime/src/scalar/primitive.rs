//! Single and double precision.

use super::{Real, Scalar};

macro_rules! primitive {
    ($float:ident) => {
        impl Real for $float {
            /// Through `f64`: a quotient of 24-bit integers is still rounded correctly (53 ≥ 2·24 + 2 bits).
            #[inline]
            fn ratio(p: i64, q: i64) -> Self {
                (p as f64 / q as f64) as $float
            }

            #[inline]
            fn from_f64(x: f64) -> Self {
                x as $float
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

        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const EPSILON: Self = $float::EPSILON;

            #[inline]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
        }
    };
}

primitive!(f32);
primitive!(f64);
