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

/// [`LANES`] doubles, or `V` times as many; every operation acts on each by itself, with the bits that it has on an `f64`.
///
/// [`LANES`] are one vector where the target has AVX-512, else two or four. Twice as many hide the latency of operations that
/// wait for one another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<const V: usize = 1>([f64x8; V]);

impl<const V: usize> Lanes<V> {
    /// How many.
    pub const COUNT: usize = LANES * V;

    /// The value of each lane.
    #[inline(always)]
    pub fn from_fn(value: impl Fn(usize) -> f64) -> Self {
        // One by one: an array that is copied whole is read before it has left the processor's store buffer.
        let vector = |v: usize| f64x8::new(core::array::from_fn(|i| value(LANES * v + i)));
        Self(core::array::from_fn(vector))
    }

    /// One value in all lanes.
    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self([f64x8::splat(value); V])
    }

    /// The value in one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> f64 {
        self.0[lane / LANES].as_array()[lane % LANES]
    }

    /// Replaces the value in one lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, value: f64) {
        self.0[lane / LANES].as_mut_array()[lane % LANES] = value;
    }

    /// Magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(f64x8::abs)
    }

    /// The larger of two; of a number and what is none, either.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.zip(other, f64x8::fast_max)
    }

    /// The smaller of two; of a number and what is none, either.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.zip(other, f64x8::fast_min)
    }

    #[inline(always)]
    fn map(self, operation: impl Fn(f64x8) -> f64x8) -> Self {
        Self(core::array::from_fn(|v| operation(self.0[v])))
    }

    #[inline(always)]
    fn zip(self, other: Self, operation: impl Fn(f64x8, f64x8) -> f64x8) -> Self {
        Self(core::array::from_fn(|v| operation(self.0[v], other.0[v])))
    }
}

impl Lanes {
    /// These values.
    #[inline(always)]
    pub fn new(values: [f64; LANES]) -> Self {
        Self::from_fn(|lane| values[lane])
    }

    /// The values.
    #[inline(always)]
    pub fn to_array(self) -> [f64; LANES] {
        self.0[0].to_array()
    }
}

/// Logarithms and powers for what needs no more than a few digits, by the exponent's bits.
impl Lanes {
    /// log₂ of a positive number to 0.01: the exponent, and a parabola through the ends and the middle of what the fraction
    /// adds.
    #[inline(always)]
    pub(crate) fn rough_log2(self) -> Self {
        let bits = self.0[0].to_bits();
        let exponent = f64x8::from_bits(bits >> FRACTION | u64x8::splat(INTEGERS.to_bits()));
        let ones = u64x8::splat(1.0_f64.to_bits());
        let fraction =
            Self([f64x8::from_bits(bits & u64x8::splat((1 << FRACTION) - 1) | ones)]) - Self::splat(1.0);
        let exponent = Self([exponent]) - Self::splat(INTEGERS + BIAS);
        exponent + fraction * (Self::splat(1.34) - Self::splat(0.34) * fraction)
    }

    /// 2ˣ to 0.3 %, for |x| < 1000.
    #[inline(always)]
    pub(crate) fn rough_exp2(self) -> Self {
        let bound = f64x8::splat(1000.0);
        let floor = self.0[0].floor().fast_max(-bound).fast_min(bound);
        let scale = f64x8::from_bits((floor + f64x8::splat(INTEGERS + BIAS)).to_bits() << FRACTION);
        let fraction = Self([self.0[0] - floor]);
        Self([scale]) * (Self::splat(1.0) + fraction * (Self::splat(0.66) + Self::splat(0.34) * fraction))
    }
}

impl<const V: usize> Add for Lanes<V> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<const V: usize> Sub for Lanes<V> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<const V: usize> Mul for Lanes<V> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl<const V: usize> Div for Lanes<V> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |a, b| a / b)
    }
}

impl<const V: usize> Neg for Lanes<V> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const V: usize> Real for Lanes<V> {
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
        self.map(f64x8::sqrt)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sin, mut cos) = (self, self);
        for v in 0..V {
            (sin.0[v], cos.0[v]) = sin_cos::<{ cfg!(target_feature = "fma") }, f64x8>(self.0[v]);
        }
        (sin, cos)
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        if cfg!(target_feature = "fma") {
            Self(core::array::from_fn(|v| self.0[v].mul_add(a.0[v], b.0[v])))
        } else {
            self * a + b
        }
    }
}
