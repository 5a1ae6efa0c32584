//! Replacing symbols by quotients and angles: with v = n/d and exponents k from −a to b,
//! Σ cₖ vᵏ = Σ cₖ nᵏ⁺ᵃ dᵇ⁻ᵏ / (nᵃ dᵇ).

use super::{Angle, Quotient, Series, Symbol};

impl Series {
    /// `value` in place of a symbol in the monomials, not in waves; overflow for 0 in place of a
    /// symbol with a negative power.
    pub fn substitute_quotient(&self, symbol: Symbol, value: &Quotient) -> Quotient {
        let powers = self.powers_of(symbol);
        if powers.iter().all(|&k| k == 0) {
            return self.clone().into();
        }
        let least = powers.first().map_or(0, |&k| i32::from(k).min(0));
        let greatest = powers.last().map_or(0, |&k| i32::from(k).max(0));
        let (n, d) = (value.numerator(), value.denominator());
        let terms = powers.iter().map(|&k| {
            let raised = n.pow((i32::from(k) - least).unsigned_abs());
            let lowered = d.pow((greatest - i32::from(k)).unsigned_abs());
            self.coefficient(symbol, k) * raised * lowered
        });
        let mut factors = vec![(n.clone(), least.unsigned_abs())];
        let denominators = value.factors().iter();
        factors.extend(denominators.map(|(f, k)| (f.clone(), k * greatest.unsigned_abs())));
        factors.retain(|(_, k)| *k > 0);
        Quotient::over(terms.sum(), &factors)
    }
}

impl Quotient {
    /// `value` in place of a symbol, as [`Series::substitute_quotient`].
    pub fn substitute_quotient(&self, symbol: Symbol, value: &Self) -> Self {
        let mut result = self.numerator().substitute_quotient(symbol, value);
        for (factor, k) in self.factors() {
            let inverse = factor.substitute_quotient(symbol, value).recip();
            for _ in 0..*k {
                result = result * &inverse;
            }
        }
        result
    }

    /// An angle in place of a coordinate, as [`Series::substitute_angle`].
    pub fn substitute_angle(&self, symbol: Symbol, value: &Angle) -> Self {
        let factors = self.factors().iter();
        let factors: Vec<_> =
            factors.map(|(factor, k)| (factor.substitute_angle(symbol, value), *k)).collect();
        Self::over(self.numerator().substitute_angle(symbol, value), &factors)
    }
}
