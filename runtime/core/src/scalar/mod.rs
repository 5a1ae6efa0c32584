//! What emitted code and control flow ask of a number.

pub(crate) mod dispatch;
mod double_double;
mod dual;
#[cfg(not(feature = "std"))]
mod elementary;
mod jet;
#[cfg(feature = "std")]
mod lanes;
mod library;
mod primitive;
mod sin_cos;
#[cfg(test)]
mod tests;

#[cfg(feature = "std")]
pub(crate) use dispatch::Vector;
pub(crate) use dispatch::{Double, Inside};
#[cfg(feature = "std")]
pub use dispatch::{LANES, Lanes};
pub use double_double::DoubleDouble;
pub use dual::{Dual, Dual4};
#[cfg(not(feature = "std"))]
pub(crate) use elementary::Elementary;
pub use jet::Jet;

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Arithmetic that emitted code is generic over; branch-free.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// Whether it is many numbers side by side, which wait for no dependent operation as long as
    /// there are others.
    const MANY: bool = false;
    /// The rational `p / q`, rounded once where `p` and `q` are exact in `Self`.
    fn ratio(p: i64, q: i64) -> Self;
    /// The nearest value to `x`.
    fn from_f64(x: f64) -> Self;
    /// π, rounded to `Self`.
    fn pi() -> Self {
        Self::from_f64(core::f64::consts::PI)
    }
    /// `√self`.
    fn sqrt(self) -> Self;
    /// `self / |self|`; 0 at 0 where the number is one of the processor's, or several of them, and
    /// else not a number.
    #[inline(always)]
    fn sign(self) -> Self {
        self / (self * self).sqrt()
    }
    /// Whether it is known to be zero; only numbers of the processor tell.
    #[inline(always)]
    fn is_zero(self) -> bool {
        false
    }
    /// `(sin self, cos self)`.
    fn sin_cos(self) -> (Self, Self);
    /// e^self.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// `tanh self`.
    fn tanh(self) -> Self;
    /// The angle between −π/2 and π/2 with this tangent.
    fn atan(self) -> Self;
    /// The piece of a spline that its value lies in: where that begins, and its coefficients.
    fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5];
    /// The value of a spline: Σ cₖ (x − a)ᵏ with a the knot before x, or the first; there is one
    /// piece more than there are knots.
    #[inline]
    fn spline(self, knots: &[f64], pieces: &[[f64; 4]]) -> Self {
        let [from, a, b, c, d] = self.piece(knots, pieces);
        let u = self - from;
        d.mul_add(u, c).mul_add(u, b).mul_add(u, a)
    }
    /// The sines and the cosines of several angles, with the bits that each has by itself; side by
    /// side where that pays.
    #[inline(always)]
    fn sin_cos_each<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        sin_cos::each(angles, Self::sin_cos)
    }
    /// `self · a + b`, fused where the target has the instruction and plain elsewhere.
    fn mul_add(self, a: Self, b: Self) -> Self;

    /// `self · a + b`, fused: slow where the processor has no instruction for it.
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        self.mul_add(a, b)
    }
}

/// A [`Real`] with an order, for control flow.
pub trait Scalar: Real + PartialOrd {
    /// Zero.
    const ZERO: Self;
    /// The unit roundoff times two.
    const EPSILON: Self;
    /// Whether it is a number of the processor: what only makes evaluations faster is compiled for
    /// no other.
    const PLAIN: bool = false;
    /// Whether it is a number of the processor with derivatives.
    const DIFFERENTIATED: bool = false;
    /// `|self|`.
    fn abs(self) -> Self;
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// `self · x`.
    #[inline(always)]
    fn scaled(self, x: f64) -> Self {
        self * Self::from_f64(x)
    }
    /// Neither infinite nor not a number.
    fn is_finite(self) -> bool;
}
