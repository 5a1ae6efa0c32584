//! Logarithms and powers for what needs no more than a few digits, by the exponent's bits.

use super::{Lanes, Vector};

/// Bits of a double's fraction.
const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
/// 2⁵²: added to a small integer, it has that in its last bits.
const INTEGERS: f64 = (1_u64 << FRACTION) as f64;
/// What exponents are stored above.
const BIAS: f64 = (f64::MAX_EXP - 1) as f64;

impl<X: Vector> Lanes<1, X> {
    /// log₂ of a positive number to 0.01: the exponent, and a parabola through the ends and the
    /// middle of what the fraction adds.
    #[inline(always)]
    pub(crate) fn rough_log2(self) -> Self {
        let bits = self.0[0].to_bits();
        let exponent = X::from_bits(bits >> FRACTION | X::bits(INTEGERS.to_bits()));
        let ones = X::bits(1.0_f64.to_bits());
        let fraction = Self([X::from_bits(bits & X::bits((1 << FRACTION) - 1) | ones)]) - Self::splat(1.0);
        let exponent = Self([exponent]) - Self::splat(INTEGERS + BIAS);
        exponent + fraction * (Self::splat(1.34) - Self::splat(0.34) * fraction)
    }

    /// 2ˣ to 0.3 %, for |x| < 1000.
    #[inline(always)]
    pub(crate) fn rough_exp2(self) -> Self {
        let bound = X::splat(1000.0);
        let floor = self.0[0].floor().max(-bound).min(bound);
        let scale = X::from_bits((floor + X::splat(INTEGERS + BIAS)).to_bits() << FRACTION);
        let fraction = Self([self.0[0] - floor]);
        Self([scale]) * (Self::splat(1.0) + fraction * (Self::splat(0.66) + Self::splat(0.34) * fraction))
    }
}
