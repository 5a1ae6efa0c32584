//! What all terms of a series have in common.

use super::{Monomial, Powers, Rational, Series};

impl Series {
    /// The greatest positive rational and the greatest monomial that divide every term:
    /// coefficients over the former are coprime integers. (1, 1) for a series without terms.
    pub fn content(&self) -> (Rational, Monomial) {
        let mut entries = self.entries().iter();
        let Some((first, c)) = entries.next() else {
            return (Rational::ONE, Monomial::ONE);
        };
        let (mut number, mut powers) = (c.abs(), first.monomial.0.clone());
        for (term, c) in entries {
            number = number.gcd(*c);
            powers = powers.minimum(&term.monomial.0);
        }
        (number, Monomial(powers))
    }

    /// Splits self = ± number · monomial · primitive, the primitive part with coprime integer
    /// coefficients, the first positive, and without common symbols; the number has the sign.
    pub(super) fn primitive(&self) -> (Rational, Monomial, Self) {
        let (mut number, monomial) = self.content();
        if self.entries().first().is_some_and(|(_, c)| c.signum() < 0) {
            number = -number;
        }
        let primitive = match monomial.0.times(-1) {
            Some(inverse) => self.times_monomial(number.recip(), &Monomial(inverse)),
            None => Self::overflow(),
        };
        (number, monomial, primitive)
    }
}

impl Monomial {
    /// The part made of parameters and the rest.
    pub fn split_units(&self) -> (Self, Self) {
        let (mut units, mut rest) = (Powers::ZERO, Powers::ZERO);
        for &(symbol, k) in self.factors() {
            let part = if symbol.is_parameter() { &mut units } else { &mut rest };
            part.push(symbol, k);
        }
        (Self(units), Self(rest))
    }
}
