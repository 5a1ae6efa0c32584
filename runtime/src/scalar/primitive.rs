//! Single and double precision.

use super::{Real, Scalar};

macro_rules! primitive {
    ($float:ident: $sqrt:path, $sin_cos:path, $mul_add:path) => {
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
                $sqrt(self)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }

            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                if cfg!(all(target_feature = "fma", feature = "std")) {
                    $mul_add(self, a, b)
                } else {
                    self * a + b
                }
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

#[cfg(feature = "std")]
primitive!(f32: f32::sqrt, f32::sin_cos, f32::mul_add);
#[cfg(feature = "std")]
primitive!(f64: f64::sqrt, f64::sin_cos, f64::mul_add);
// The functions of `libm` are no instructions: its `fma` is a long one.
#[cfg(not(feature = "std"))]
primitive!(f32: libm::sqrtf, libm::sincosf, libm::fmaf);
#[cfg(not(feature = "std"))]
primitive!(f64: libm::sqrt, libm::sincos, libm::fma);
