//! Single and double precision.

use super::dispatch::FUSED;
use super::library::Library;
use super::sin_cos::{sin_cos, sin_cos_each};
use super::{Real, Scalar};

macro_rules! primitive {
    ($float:ident, $($sines:tt)*) => {
        impl Real for $float {
            /// Through `f64`: a quotient of 24-bit integers is still rounded correctly (53 ≥ 2·24 +
            /// 2 bits).
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
                Library::sqrt(self)
            }

            #[inline]
            fn exp(self) -> Self {
                Library::exp(self)
            }

            #[inline]
            fn ln(self) -> Self {
                Library::ln(self)
            }

            #[inline]
            fn tanh(self) -> Self {
                Library::tanh(self)
            }

            #[inline]
            fn atan(self) -> Self {
                Library::atan(self)
            }

            fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5] {
                let piece = knots.partition_point(|knot| *knot as Self <= self);
                let [a, b, c, d] = pieces[piece];
                [knots[piece.saturating_sub(1)], a, b, c, d].map(|x| x as Self)
            }

            #[inline]
            fn is_zero(self) -> bool {
                self == 0.0
            }

            #[inline]
            fn sign(self) -> Self {
                if self == 0.0 || self.is_nan() { self } else { (1.0 as $float).copysign(self) }
            }

            $($sines)*

            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                if FUSED { Library::mul_add(self, a, b) } else { self * a + b }
            }

            #[inline(always)]
            fn fused_mul_add(self, a: Self, b: Self) -> Self {
                Library::mul_add(self, a, b)
            }
        }

        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const EPSILON: Self = $float::EPSILON;
            const PLAIN: bool = true;

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

primitive! {
    f32,
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        Library::sin_cos(self)
    }
}

primitive! {
    f64,
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        sin_cos::<FUSED, f64>(self)
    }

    #[inline]
    fn sin_cos_each<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        sin_cos_each::<FUSED, K>(angles)
    }
}
