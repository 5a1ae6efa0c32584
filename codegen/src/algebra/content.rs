//! What all terms of a series have in common.

use super::{Monomial, Powers, Rational, Series};
use crate::math::is_long;

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

    /// [`content`](Self::content) as it is written in front: without the number where that, or what
    /// it leaves, is long.
    pub fn written_content(&self) -> (Rational, Monomial) {
        let (number, monomial) = self.content();
        let long = |c: Rational| is_long(c.numerator().unsigned_abs(), c.denominator().unsigned_abs());
        let left = self.entries().iter().map(|(_, c)| (*c * number.recip()).numerator().unsigned_abs());
        match long(number) || number.denominator() > 1 && left.max().is_some_and(|most| is_long(most, 2)) {
            true => (Rational::ONE, monomial),
            false => (number, monomial),
        }
    }

    /// The series over number · monomial, which divide every term; `None` where an exponent
    /// overflows.
    pub fn over(&self, number: Rational, monomial: &Monomial) -> Option<Self> {
        Some(self.times_monomial(number.recip(), &Monomial(monomial.0.times(-1)?)))
    }

    /// Splits self = ± number · monomial · primitive, the primitive part with coprime integer
    /// coefficients, the first positive, and without common symbols; the number has the sign.
    pub(super) fn primitive(&self) -> (Rational, Monomial, Self) {
        let (number, monomial) = self.content();
        self.split(number, monomial)
    }

    /// The same with the content that is written.
    pub(super) fn written(&self) -> (Rational, Monomial, Self) {
        let (number, monomial) = self.written_content();
        self.split(number, monomial)
    }

    fn split(&self, mut number: Rational, monomial: Monomial) -> (Rational, Monomial, Self) {
        if self.entries().first().is_some_and(|(_, c)| c.is_negative()) {
            number = -number;
        }
        let primitive = self.over(number, &monomial).unwrap_or_else(Self::overflow);
        (number, monomial, primitive)
    }
}

impl Monomial {
    /// What stands over a fraction bar, and the parameters below it.
    pub fn over_parameters(&self) -> (Self, Self) {
        let (mut above, mut below) = (Powers::ZERO, Powers::ZERO);
        for &(symbol, k) in self.factors() {
            if k.is_positive() { above.push(symbol, k) } else { below.push(symbol, k.saturating_neg()) }
        }
        (Self(above), Self(below))
    }

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
