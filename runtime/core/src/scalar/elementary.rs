//! Functions of doubles that the standard library has and `core` has not, by the same names; from
//! the crate `libm`.

/// What integration without `std` asks of a double besides [`Real`](super::Real).
pub(crate) trait Elementary: Sized {
    fn sqrt(self) -> Self;
    fn mul_add(self, a: Self, b: Self) -> Self;
    fn cos(self) -> Self;
    fn atan2(self, x: Self) -> Self;
    fn hypot(self, other: Self) -> Self;
    fn ln(self) -> Self;
    fn log2(self) -> Self;
    fn powf(self, exponent: Self) -> Self;
    fn powi(self, exponent: i32) -> Self;
    fn round(self) -> Self;
    fn floor(self) -> Self;
    fn rem_euclid(self, modulus: Self) -> Self;
}

impl Elementary for f64 {
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }

    /// Not fused: where there is no standard library a call costs more than the digit is worth.
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn cos(self) -> Self {
        libm::cos(self)
    }

    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }

    fn hypot(self, other: Self) -> Self {
        libm::hypot(self, other)
    }

    fn ln(self) -> Self {
        libm::log(self)
    }

    fn log2(self) -> Self {
        libm::log2(self)
    }

    fn powf(self, exponent: Self) -> Self {
        libm::pow(self, exponent)
    }

    fn powi(self, exponent: i32) -> Self {
        libm::pow(self, f64::from(exponent))
    }

    fn round(self) -> Self {
        libm::round(self)
    }

    fn floor(self) -> Self {
        libm::floor(self)
    }

    fn rem_euclid(self, modulus: Self) -> Self {
        let rest = self % modulus;
        if rest < 0.0 { rest + modulus.abs() } else { rest }
    }
}
