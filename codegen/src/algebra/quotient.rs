//! Quotients N / (f₁^k₁ f₂^k₂ …) of Poisson series.
//!
//! Each factor is primitive (coprime integer coefficients, the first positive, no common symbol),
//! not constant, and does not divide another; rational numbers and parameters are units and stand
//! in the numerator. Every operation divides out the factors that divide the numerator.
//! Trigonometric polynomials have no unique factorisation, so equality is by cross-multiplication.

use super::{Monomial, Series, Symbol};

/// A quotient of Poisson series with a factored denominator.
///
/// `==` compares representations; [`Quotient::equals`] compares values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quotient {
    numerator: Series,
    factors: Vec<(Series, u32)>,
}

impl From<Series> for Quotient {
    fn from(numerator: Series) -> Self {
        Self { numerator, factors: Vec::new() }
    }
}

impl Quotient {
    /// numerator / denominator; overflow for denominator 0.
    pub fn new(numerator: Series, denominator: Series) -> Self {
        Self::over(numerator, &[(denominator, 1)])
    }

    /// numerator / Π fᵏ for any series f, reduced.
    pub(super) fn over(numerator: Series, factors: &[(Series, u32)]) -> Self {
        let mut quotient = Self::from(numerator);
        for (factor, exponent) in factors {
            quotient.divide_by(factor, *exponent);
        }
        quotient.reduce();
        quotient
    }

    /// N.
    pub fn numerator(&self) -> &Series {
        &self.numerator
    }

    /// The distinct factors of the denominator with their exponents; none means 1.
    pub fn factors(&self) -> &[(Series, u32)] {
        &self.factors
    }

    /// Π fᵏ multiplied out.
    pub fn denominator(&self) -> Series {
        expand(&self.factors)
    }

    /// The numerator if the denominator is 1.
    pub fn as_series(&self) -> Option<&Series> {
        self.factors.is_empty().then_some(&self.numerator)
    }

    /// Whether it is exactly zero.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Whether a number overflowed or was divided by zero.
    pub fn is_overflow(&self) -> bool {
        self.numerator.is_overflow()
    }

    /// Whether both have the same value; false if either is overflow.
    pub fn equals(&self, other: &Self) -> bool {
        (self - other).is_zero()
    }

    /// Whether a symbol occurs.
    pub fn depends_on(&self, symbol: Symbol) -> bool {
        let mut factors = self.factors.iter();
        self.numerator.depends_on(symbol) || factors.any(|(factor, _)| factor.depends_on(symbol))
    }

    /// The value where every symbol has the value given; NaN for overflow.
    pub fn evaluate(&self, value: &impl Fn(Symbol) -> f64) -> f64 {
        let powers = self.factors.iter();
        let denominator: f64 = powers.map(|(factor, k)| factor.evaluate(value).powf(f64::from(*k))).product();
        self.numerator.evaluate(value) / denominator
    }

    /// 1/self; overflow for 0.
    pub fn recip(&self) -> Self {
        Self::new(self.denominator(), self.numerator.clone())
    }

    /// Maps the numerator and keeps the denominator; the result must be zero or overflow only if
    /// `self` is.
    pub(super) fn map_numerator(mut self, map: impl FnOnce(Series) -> Series) -> Self {
        self.numerator = map(self.numerator);
        self
    }

    /// Divides by divisorᵏ: its unit goes into the numerator, its primitive part into the factors.
    fn divide_by(&mut self, divisor: &Series, k: u32) {
        let (Ok(power), false) = (i32::try_from(k), divisor.is_zero()) else {
            *self = Self::from(Series::overflow());
            return;
        };
        let (waves, rest) = divisor.split_waves();
        let (number, monomial, primitive) = rest.primitive();
        let (units, symbols) = monomial.split_units();
        self.numerator = match units.0.times(-power) {
            Some(inverse) => self.numerator.times_monomial(number.pow(-power), &Monomial(inverse)),
            None => Series::overflow(),
        };
        for &(symbol, exponent) in symbols.factors() {
            self.insert(Series::symbol(symbol), k * u32::from(exponent.unsigned_abs()));
        }
        for (wave, exponent) in waves {
            self.insert(wave, k * exponent);
        }
        self.insert(primitive, k);
    }

    /// Adds a primitive factor, splitting it or those present where one divides the other.
    fn insert(&mut self, factor: Series, k: u32) {
        if factor.is_overflow() {
            self.numerator = Series::overflow();
            return;
        }
        if k == 0 || factor == Series::one() {
            return;
        }
        for i in 0..self.factors.len() {
            let (present, exponent) = &mut self.factors[i];
            if *present == factor {
                *exponent += k;
                return;
            }
            if let Some(rest) = factor.divide_exact(present) {
                *exponent += k;
                return self.divide_by(&rest, k);
            }
            if let Some(rest) = present.divide_exact(&factor) {
                let (_, exponent) = self.factors.remove(i);
                self.insert(factor, k + exponent);
                return self.divide_by(&rest, exponent);
            }
        }
        let (Ok(at) | Err(at)) = self.factors.binary_search_by(|(present, _)| present.cmp(&factor));
        self.factors.insert(at, (factor, k));
    }

    /// Divides out the factors that divide the numerator; all factors if the numerator is zero or
    /// overflow.
    fn reduce(&mut self) {
        for (factor, k) in &mut self.factors {
            while *k > 0 {
                let Some(quotient) = self.numerator.divide_exact(factor) else {
                    break;
                };
                self.numerator = quotient;
                *k -= 1;
            }
        }
        self.factors.retain(|(_, k)| *k > 0);
    }
}

/// Π fᵏ multiplied out.
pub(super) fn expand(factors: &[(Series, u32)]) -> Series {
    let powers = factors.iter().map(|(factor, k)| factor.pow(*k));
    powers.fold(Series::one(), |product, power| product * power)
}
