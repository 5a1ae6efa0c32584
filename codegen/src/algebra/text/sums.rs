//! Sums and quotients as they are written, and the order of terms in them: highest derivatives
//! first, then by monomial, constants before waves, low multiples first; a positive term leads
//! where there is one.

use super::super::{Powers, Quotient, Rational, Series, Symbol, Term};
use super::names::{PRODUCT, SymbolNames};
use super::products::{lead, monomial, numbered, term, wave};
use crate::math::Math;
use std::cmp::Reverse;

impl Series {
    /// The series as it is written.
    pub fn math(&self, names: &dyn SymbolNames) -> Math {
        if self.is_overflow() {
            return Math::Words("overflow".to_owned());
        }
        match self.entries() {
            [] => Math::ZERO,
            [(single, c)] => term(*c, single, names),
            _ => self.sum(names),
        }
    }

    /// The series in textbook notation.
    pub fn text(&self, names: &dyn SymbolNames) -> String {
        self.math(names).to_string()
    }

    /// common factor (sum), or the sum alone where nothing is common.
    fn sum(&self, names: &dyn SymbolNames) -> Math {
        let (number, common, rest) = self.factored();
        let sum = rest.terms_in_order(names);
        let (above, below) = common.over_parameters();
        let (mut factors, below) = (monomial(&above, names), monomial(&below, names));
        if number == Rational::ONE && factors.is_empty() && below.is_empty() {
            return sum;
        }
        factors.push(sum.group());
        match below.is_empty() {
            true => numbered(number, factors),
            false => numbered(number, vec![Math::product(factors).over(Math::product(below))]),
        }
    }

    /// The content with a sign, and the rest with a positive term.
    fn factored(&self) -> (Rational, super::super::Monomial, Self) {
        let (number, monomial, rest) = self.written();
        let all_negative = self.entries().iter().all(|(_, c)| c.is_negative());
        if number.is_negative() && !all_negative {
            return (-number, monomial, -rest);
        }
        (number, monomial, rest)
    }

    fn terms_in_order(&self, names: &dyn SymbolNames) -> Math {
        let mut terms: Vec<_> = self.entries().iter().collect();
        terms.sort_by_cached_key(|(term, _)| rank(term));
        lead(&mut terms, |(_, c)| !c.is_negative());
        Math::sum(terms.into_iter().map(|(each, c)| term(*c, each, names)))
    }

    /// As one factor of a denominator.
    fn factor(&self, k: u32, names: &dyn SymbolNames) -> Math {
        let power = i32::try_from(k).unwrap_or(i32::MAX);
        match self.entries() {
            [(single, _)] if single.monomial.is_one() => wave(&single.wave, k, names),
            [(single, c)] => term(*c, single, names).power(power),
            _ => self.terms_in_order(names).group().power(power),
        }
    }
}

impl Quotient {
    /// The quotient as it is written, the denominator in factors.
    pub fn math(&self, names: &dyn SymbolNames) -> Math {
        let above = self.numerator().math(names);
        let mut factors: Vec<_> = self.factors().iter().collect();
        factors.sort_by_key(|(factor, _)| factor.len());
        let below: Vec<Math> = factors.into_iter().map(|(f, k)| f.factor(*k, names)).collect();
        match below.len() {
            0 => above,
            _ => above.all_over(Math::product(below)),
        }
    }

    /// The quotient in textbook notation.
    pub fn text(&self, names: &dyn SymbolNames) -> String {
        self.math(names).to_string()
    }
}

/// Degrees in accelerations (and beyond), rates, coordinates; monomial, product of waves; multiple
/// of the wave.
pub type Rank = (Reverse<[i32; 3]>, Reverse<Powers>, Powers, i32, Reverse<Powers>, bool);

/// The place of a term in a sum.
pub fn rank(term: &Term) -> Rank {
    let (mut degrees, mut monomial, mut products) = ([0; 3], Powers::ZERO, Powers::ZERO);
    for &(symbol, k) in term.monomial.factors() {
        let product = matches!(symbol, Symbol::Opaque { order: PRODUCT, .. });
        if product {
            products.push(symbol, k)
        } else {
            monomial.push(symbol, k)
        }
        if let Symbol::Coordinate { order, .. } = symbol {
            degrees[2 - usize::from(order.min(2))] += i32::from(k);
        }
    }
    let multiples = term.wave.argument.iter();
    (
        Reverse(degrees),
        Reverse(monomial),
        products,
        multiples.map(|(_, k)| i32::from(k.abs())).sum(),
        Reverse(term.wave.argument.clone()),
        term.wave.sine,
    )
}
