//! Doubles one by one or side by side, with their bits.

use core::ops::{Add, BitAnd, BitXor, Mul, Neg, Shl, Sub};

#[cfg(feature = "std")]
use super::sin_cos;
use crate::scalar::library::Library;
#[cfg(feature = "std")]
use wide::{f64x2, f64x4, f64x8, u64x2, u64x4, u64x8};

/// What the reduction and the polynomials are made of.
pub trait Doubles:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// As unsigned integers.
    type Bits: Copy
        + Add<Output = Self::Bits>
        + BitAnd<Output = Self::Bits>
        + BitXor<Output = Self::Bits>
        + Shl<u32, Output = Self::Bits>;

    fn splat(x: f64) -> Self;
    fn abs(self) -> Self;
    /// Whether no magnitude is above `bound`, and none is not a number.
    fn within(self, bound: f64) -> bool;
    /// Sine and cosine, one by one.
    fn singly<const FUSED: bool>(self) -> (Self, Self);
    /// `self · a + b`, with one rounding if `FUSED`; what is side by side has it only where the
    /// target has.
    fn mul_add<const FUSED: bool>(self, a: Self, b: Self) -> Self;
    fn to_bits(self) -> Self::Bits;
    fn from_bits(bits: Self::Bits) -> Self;
    fn bits(bits: u64) -> Self::Bits;
    /// All ones where the lowest bit is one, else zero.
    fn lowest_bit_everywhere(bits: Self::Bits) -> Self::Bits;
}

impl Doubles for f64 {
    type Bits = u64;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn within(self, bound: f64) -> bool {
        self.abs() <= bound
    }

    #[inline(always)]
    fn singly<const FUSED: bool>(self) -> (Self, Self) {
        Library::sin_cos(self)
    }

    #[inline(always)]
    fn mul_add<const FUSED: bool>(self, a: Self, b: Self) -> Self {
        if FUSED { Library::mul_add(self, a, b) } else { self * a + b }
    }

    #[inline(always)]
    fn to_bits(self) -> u64 {
        self.to_bits()
    }

    #[inline(always)]
    fn from_bits(bits: u64) -> Self {
        Self::from_bits(bits)
    }

    #[inline(always)]
    fn bits(bits: u64) -> u64 {
        bits
    }

    #[inline(always)]
    fn lowest_bit_everywhere(bits: u64) -> u64 {
        (bits & 1).wrapping_neg()
    }
}

#[cfg(feature = "std")]
macro_rules! side_by_side {
    ($doubles:ident, $bits:ident) => {
        impl Doubles for $doubles {
            type Bits = $bits;

            #[inline(always)]
            fn splat(x: f64) -> Self {
                Self::splat(x)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline(always)]
            fn within(self, bound: f64) -> bool {
                self.abs().simd_le(Self::splat(bound)).all()
            }

            #[cold]
            fn singly<const FUSED: bool>(self) -> (Self, Self) {
                let pairs = self.to_array().map(sin_cos::<FUSED, f64>);
                (Self::new(pairs.map(|(sin, _)| sin)), Self::new(pairs.map(|(_, cos)| cos)))
            }

            #[inline(always)]
            fn mul_add<const FUSED: bool>(self, a: Self, b: Self) -> Self {
                if FUSED { self.mul_add(a, b) } else { self * a + b }
            }

            #[inline(always)]
            fn to_bits(self) -> $bits {
                self.to_bits()
            }

            #[inline(always)]
            fn from_bits(bits: $bits) -> Self {
                Self::from_bits(bits)
            }

            #[inline(always)]
            fn bits(bits: u64) -> $bits {
                $bits::splat(bits)
            }

            #[inline(always)]
            fn lowest_bit_everywhere(bits: $bits) -> $bits {
                $bits::splat(0) - (bits & $bits::splat(1))
            }
        }
    };
}

#[cfg(feature = "std")]
side_by_side!(f64x2, u64x2);
#[cfg(feature = "std")]
side_by_side!(f64x4, u64x4);
#[cfg(feature = "std")]
side_by_side!(f64x8, u64x8);
