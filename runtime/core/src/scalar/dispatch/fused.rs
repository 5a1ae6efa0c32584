//! Doubles for code that is compiled for AVX2 and FMA, whatever the target has.
//!
//! In a binary for any x86-64 a double pendulum takes 0.74, 0.79, 0.82, 0.86 of the time by them, a
//! chain of eight bars 0.70, 0.75, 0.79, 0.84, at tolerances of 1e-4, 1e-6, 1e-9, 1e-12; by DOP853
//! the chain takes 0.80, the pendulum 1.04 at 1e-6.
//!
//! # Safety
//!
//! The one `unsafe` is the call of a function compiled for both. The type is private to `dispatch`,
//! whose [`by_doubles`](super::by_doubles) alone hands it out, after the standard library's test.
#![allow(unsafe_code, reason = "the module's proof")]

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::found::Avx2;
use super::{Double, Inside, Vector};
use crate::scalar::library::Library;
use crate::scalar::sin_cos::sin_cos;
use crate::scalar::{LANES, Real};

/// A double that is multiplied and added to in one instruction.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Fused(f64);

macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Fused {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Fused {
    #[inline(always)]
    fn ratio(p: i64, q: i64) -> Self {
        Self(f64::ratio(p, q))
    }

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self(x)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(Real::sqrt(self.0))
    }

    #[inline(always)]
    fn sign(self) -> Self {
        Self(self.0.sign())
    }

    #[inline(always)]
    fn exp(self) -> Self {
        Self(Real::exp(self.0))
    }

    #[inline(always)]
    fn ln(self) -> Self {
        Self(Real::ln(self.0))
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        Self(Real::tanh(self.0))
    }

    #[inline(always)]
    fn atan(self) -> Self {
        Self(Real::atan(self.0))
    }

    fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5] {
        self.0.piece(knots, pieces).map(Self)
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self.0.is_zero()
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = sin_cos::<true, f64>(self.0);
        (Self(sin), Self(cos))
    }

    /// Eight at once, and one by one what is left, by loops without closures, which would be
    /// functions of their own.
    #[inline(always)]
    fn sin_cos_each<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let (mut sin, mut cos) = (angles, angles);
        for first in 0..K / LANES {
            let mut values = [0.0; LANES];
            for k in 0..LANES {
                values[k] = angles[LANES * first + k].0;
            }
            let (sines, cosines) = sin_cos::<true, Avx2>(Avx2::new(values));
            for k in 0..LANES {
                sin[LANES * first + k] = Self(sines.as_array()[k]);
                cos[LANES * first + k] = Self(cosines.as_array()[k]);
            }
        }
        for k in K / LANES * LANES..K {
            (sin[k], cos[k]) = angles[k].sin_cos();
        }
        (sin, cos)
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(Library::mul_add(self.0, a.0, b.0))
    }
}

impl Double for Fused {
    #[inline(always)]
    fn value(self) -> f64 {
        self.0
    }

    #[inline(always)]
    fn inside<W: Inside>(work: W) -> W::Output {
        // SAFETY: where there is such a number, the processor has both.
        unsafe { with_fma(work) }
    }
}

#[target_feature(enable = "avx2,fma")]
fn with_fma<W: Inside>(work: W) -> W::Output {
    work.run()
}
