//! Functions of the standard library, or of the crate `libm` where there is none.

/// What a floating-point number has of its library.
pub(super) trait Library: Sized {
    /// `√self`.
    fn sqrt(self) -> Self;
    /// `self · a + b`, rounded once on every target.
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// `(sin self, cos self)`.
    fn sin_cos(self) -> (Self, Self);
    /// `e^self`.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// `tanh self`.
    fn tanh(self) -> Self;
    /// `atan self`.
    fn atan(self) -> Self;
}

macro_rules! library {
    ($float:ident: $sqrt:path, $mul_add:path, $sin_cos:path, $exp:path, $ln:path, $tanh:path, $atan:path) => {
        impl Library for $float {
            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline(always)]
            fn mul_add(self, a: Self, b: Self) -> Self {
                $mul_add(self, a, b)
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }

            #[inline(always)]
            fn exp(self) -> Self {
                $exp(self)
            }

            #[inline(always)]
            fn ln(self) -> Self {
                $ln(self)
            }

            #[inline(always)]
            fn tanh(self) -> Self {
                $tanh(self)
            }

            #[inline(always)]
            fn atan(self) -> Self {
                $atan(self)
            }
        }
    };
}

#[cfg(feature = "std")]
library!(f32: f32::sqrt, f32::mul_add, f32::sin_cos, f32::exp, f32::ln, f32::tanh, f32::atan);
#[cfg(feature = "std")]
library!(f64: f64::sqrt, f64::mul_add, f64::sin_cos, f64::exp, f64::ln, f64::tanh, f64::atan);
#[cfg(not(feature = "std"))]
library!(f32: libm::sqrtf, libm::fmaf, libm::sincosf, libm::expf, libm::logf, libm::tanhf, libm::atanf);
#[cfg(not(feature = "std"))]
library!(f64: libm::sqrt, libm::fma, libm::sincos, libm::exp, libm::log, libm::tanh, libm::atan);
