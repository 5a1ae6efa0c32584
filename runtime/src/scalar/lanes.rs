//! Eight doubles side by side: eight states, or eight systems, in one evaluation.

use core::ops::{Add, Div, Mul, Neg, Sub};

use wide::{f64x8, u64x8};

use super::Real;
use super::sin_cos::sin_cos;

/// How many.
pub const LANES: usize = 8;

/// Bits of a double's fraction.
const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
/// 2⁵²: added to a small integer, it has that in its last bits.
const INTEGERS: f64 = (1_u64 << FRACTION) as f64;
/// What exponents are stored above.
const BIAS: f64 = (f64::MAX_EXP - 1) as f64;

/// [`LANES`] doubles; every operation acts on each by itself, with the bits that it has on an `f64`.
///
/// One vector where the target has AVX-512, else two or four.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes(f64x8);

impl Lanes {
    /// These values.
    #[inline(always)]
    pub fn new(values: [f64; LANES]) -> Self {
        // One by one: an array that is copied whole is read before it has left the processor's store buffer.
        Self(f64x8::new(core::array::from_fn(|lane| values[lane])))
    }

    /// One value in all lanes.
    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self(f64x8::splat(value))
    }

    /// The values.
    #[inline(always)]
    pub fn to_array(self) -> [f64; LANES] {
        self.0.to_array()
    }

    /// The value in one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> f64 {
        self.0.as_array()[lane]
    }

    /// Replaces the value in one lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, value: f64) {
        self.0.as_mut_array()[lane] = value;
    }

    /// Magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(self.0.abs())
    }

    /// The larger of two; of a number and what is none, either.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(self.0.fast_max(other.0))
    }

    /// The smaller of two; of a number and what is none, either.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self(self.0.fast_min(other.0))
    }
}

/// Logarithms and powers for what needs no more than a few digits, by the exponent's bits.
impl Lanes {
    /// log₂ of a positive number to 0.01: the exponent, and a parabola through the ends and the middle of what the fraction
    /// adds.
    #[inline(always)]
    pub(crate) fn rough_log2(self) -> Self {
        let bits = self.0.to_bits();
        let exponent = f64x8::from_bits(bits >> FRACTION | u64x8::splat(INTEGERS.to_bits()));
        let ones = u64x8::splat(1.0_f64.to_bits());
        let fraction =
            Self(f64x8::from_bits(bits & u64x8::splat((1 << FRACTION) - 1) | ones)) - Self::splat(1.0);
        let exponent = Self(exponent) - Self::splat(INTEGERS + BIAS);
        exponent + fraction * (Self::splat(1.34) - Self::splat(0.34) * fraction)
    }

    /// 2ˣ to 0.3 %, for |x| < 1000.
    #[inline(always)]
    pub(crate) fn rough_exp2(self) -> Self {
        let bound = f64x8::splat(1000.0);
        let floor = self.0.floor().fast_max(-bound).fast_min(bound);
        let scale = f64x8::from_bits((floor + f64x8::splat(INTEGERS + BIAS)).to_bits() << FRACTION);
        let fraction = Self(self.0 - floor);
        Self(scale) * (Self::splat(1.0) + fraction * (Self::splat(0.66) + Self::splat(0.34) * fraction))
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Lanes {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Lanes {
    #[inline(always)]
    fn ratio(p: i64, q: i64) -> Self {
        Self::splat(f64::ratio(p, q))
    }

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self::splat(x)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = sin_cos::<{ cfg!(target_feature = "fma") }, f64x8>(self.0);
        (Self(sin), Self(cos))
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        if cfg!(target_feature = "fma") { Self(self.0.mul_add(a.0, b.0)) } else { self * a + b }
    }
}
