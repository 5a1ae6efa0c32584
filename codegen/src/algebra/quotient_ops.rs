//! Arithmetic and derivatives of quotients.

use super::ops::by_reference;
use super::quotient::expand;
use super::{Quotient, Series, Symbol};
use std::iter::Sum;
use std::num::NonZeroU32;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

impl Quotient {
    /// ∂/∂symbol, all other symbols held.
    pub fn derivative(&self, symbol: Symbol) -> Self {
        self.differentiate(|series| series.derivative(symbol))
    }

    /// d/dt as [`Series::rate`].
    pub fn rate(&self) -> Self {
        self.differentiate(Series::rate)
    }

    /// (N/Π fᵏ)′ = (N′ Π f − N Σ k f′ Π others) / Π fᵏ⁺¹, over the factors with f′ ≠ 0.
    fn differentiate(&self, derivative: impl Fn(&Series) -> Series) -> Self {
        let slopes = self.factors().iter().map(|(f, k)| (f, *k, derivative(f)));
        let varying: Vec<_> = slopes.filter(|(_, _, slope)| !slope.is_zero()).collect();
        let mut numerator = derivative(self.numerator());
        for (factor, _, _) in &varying {
            numerator = numerator * *factor;
        }
        for (i, (_, k, slope)) in varying.iter().enumerate() {
            let others = varying.iter().enumerate().filter(|(j, _)| *j != i);
            let product = others.fold(self.numerator() * slope, |p, (_, (f, _, _))| p * *f);
            numerator -= product.scale(i64::from(*k).into());
        }
        let raised = |f: &Series| u32::from(varying.iter().any(|(g, _, _)| *g == f));
        let factors = self.factors().iter();
        let factors: Vec<_> = factors.map(|(f, k)| (f.clone(), k + raised(f))).collect();
        Self::over(numerator, &factors)
    }
}

/// The factors of `of` to the power in which `than` lacks them.
fn excess(of: &[(Series, u32)], than: &[(Series, u32)]) -> Vec<(Series, u32)> {
    let missing = of.iter().filter_map(|(factor, k)| {
        let present = than.iter().find(|(other, _)| other == factor);
        let k = NonZeroU32::new(k.saturating_sub(present.map_or(0, |(_, k)| *k)))?;
        Some((factor.clone(), k.get()))
    });
    missing.collect()
}

impl Add for Quotient {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (mine, theirs) =
            (excess(self.factors(), other.factors()), excess(other.factors(), self.factors()));
        let numerator = self.numerator() * expand(&theirs) + other.numerator() * expand(&mine);
        let factors: Vec<_> = self.factors().iter().cloned().chain(theirs).collect();
        Self::over(numerator, &factors)
    }
}

impl Mul for Quotient {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let left = Self::over(self.numerator().clone(), other.factors());
        let right = Self::over(other.numerator().clone(), self.factors());
        let factors: Vec<_> = left.factors().iter().chain(right.factors()).cloned().collect();
        Self::over(left.numerator() * right.numerator(), &factors)
    }
}

impl Div for Quotient {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.mul(other.recip())
    }
}

impl Neg for Quotient {
    type Output = Self;
    fn neg(self) -> Self {
        self.map_numerator(|n| -n)
    }
}

impl Neg for &Quotient {
    type Output = Quotient;
    fn neg(self) -> Quotient {
        -self.clone()
    }
}

impl Sub for Quotient {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl AddAssign for Quotient {
    fn add_assign(&mut self, other: Self) {
        *self = &*self + other;
    }
}

impl Sum for Quotient {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self::from(Series::zero()), |sum, quotient| sum + quotient)
    }
}

by_reference!(Quotient, Add add, Sub sub, Mul mul, Div div);
