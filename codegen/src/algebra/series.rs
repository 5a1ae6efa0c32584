//! Poisson series Σ c · monomial · sin|cos(argument) in canonical form.

use super::{Angle, Monomial, Powers, Rational, Symbol, Term, Wave};
use std::collections::BTreeSet;

/// A Poisson series: terms in strictly increasing order, none with coefficient zero.
///
/// Once a coefficient or an exponent overflows, the whole series is *overflow*, and so is whatever
/// is computed from it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Series {
    terms: Vec<(Term, Rational)>,
    overflow: bool,
}

impl Series {
    /// 0.
    pub fn zero() -> Self {
        Self::from_sorted(Vec::new())
    }

    /// 1.
    pub fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// A number.
    pub fn constant(c: Rational) -> Self {
        Self::term(c, Term::ONE)
    }

    /// An integer.
    pub fn integer(n: i64) -> Self {
        Self::constant(n.into())
    }

    /// One symbol.
    pub fn symbol(symbol: Symbol) -> Self {
        Self::monomial(Rational::ONE, Monomial(Powers::single(symbol, 1)))
    }

    /// c · monomial.
    pub fn monomial(c: Rational, monomial: Monomial) -> Self {
        let wave = Wave::ONE;
        Self::term(c, Term { monomial, wave })
    }

    /// cos(angle), quarter turns folded away.
    pub fn cos(angle: &Angle) -> Self {
        Self::wave(angle, 0)
    }

    /// sin(angle), quarter turns folded away.
    pub fn sin(angle: &Angle) -> Self {
        Self::wave(angle, 3)
    }

    /// cos(x + n·π/2) is cos x, −sin x, −cos x, sin x for n = 0, 1, 2, 3.
    fn wave(angle: &Angle, quarters: u8) -> Self {
        let Some(multipliers) = angle.multipliers() else {
            return Self::overflow();
        };
        let n = (angle.quarter_turns() + quarters) % 4;
        let Some((odd, wave)) = Wave::canonical(n % 2 == 1, multipliers.clone()) else {
            return Self::zero();
        };
        let sign = if odd != (n == 1 || n == 2) { -1 } else { 1 };
        let monomial = Monomial::ONE;
        Self::term(Rational::integer(sign), Term { monomial, wave })
    }

    /// c · term, for a term already canonical.
    pub(super) fn term(c: Rational, term: Term) -> Self {
        if c.is_overflow() {
            return Self::overflow();
        }
        let terms = if c.is_zero() { Vec::new() } else { vec![(term, c)] };
        Self::from_sorted(terms)
    }

    /// The absorbing value.
    pub(super) fn overflow() -> Self {
        Self { terms: Vec::new(), overflow: true }
    }

    /// From terms in strictly increasing order, with non-zero coefficients.
    pub(super) fn from_sorted(terms: Vec<(Term, Rational)>) -> Self {
        Self { terms, overflow: false }
    }

    /// The same terms in the same order, each with its coefficient mapped to a non-zero one.
    pub(super) fn map_coefficients(mut self, map: impl Fn(Rational) -> Rational) -> Self {
        for entry in &mut self.terms {
            entry.1 = map(entry.1);
            self.overflow |= entry.1.is_overflow();
        }
        if self.overflow {
            return Self::overflow();
        }
        self
    }

    /// The terms with their coefficients, in increasing order; none for overflow.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Term, Rational)> + Clone {
        self.terms.iter().map(|(term, c)| (term, *c))
    }

    pub(super) fn entries(&self) -> &[(Term, Rational)] {
        &self.terms
    }

    pub(super) fn into_entries(self) -> Vec<(Term, Rational)> {
        self.terms
    }

    /// The number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether there are no terms (true for zero and for overflow).
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether it is exactly zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty() && !self.overflow
    }

    /// Whether something that went into it did not fit, or was undefined.
    pub fn is_overflow(&self) -> bool {
        self.overflow
    }

    /// Its value if it is a number.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.as_monomial() {
            Some((c, monomial)) => monomial.is_one().then_some(c),
            None => self.is_zero().then_some(Rational::ZERO),
        }
    }

    /// Coefficient and monomial if it is a single term without sine or cosine.
    pub fn as_monomial(&self) -> Option<(Rational, &Monomial)> {
        match self.terms.as_slice() {
            [(term, c)] if term.wave.is_one() => Some((*c, &term.monomial)),
            _ => None,
        }
    }

    /// Whether a symbol occurs at all.
    pub fn depends_on(&self, symbol: Symbol) -> bool {
        self.degree_present(symbol) || self.in_wave(symbol)
    }

    /// Whether a symbol occurs inside a sine or cosine.
    pub fn in_wave(&self, symbol: Symbol) -> bool {
        self.terms.iter().any(|(term, _)| term.wave.argument.get(symbol) != 0)
    }

    fn degree_present(&self, symbol: Symbol) -> bool {
        self.terms.iter().any(|(term, _)| term.monomial.exponent(symbol) != 0)
    }

    /// Every symbol that occurs.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let mut symbols = BTreeSet::new();
        for (term, _) in &self.terms {
            for &(symbol, _) in term.monomial.factors().iter().chain(&term.wave.argument) {
                symbols.insert(symbol);
            }
        }
        symbols
    }

    /// The greatest exponent of a symbol in the monomials; 0 for a series without terms.
    pub fn degree(&self, symbol: Symbol) -> i16 {
        self.exponents(symbol).max().unwrap_or(0)
    }

    /// The exponent of a symbol in every term.
    pub(super) fn exponents(&self, symbol: Symbol) -> impl Iterator<Item = i16> {
        self.terms.iter().map(move |(term, _)| term.monomial.exponent(symbol))
    }

    /// The series that multiplies symbol^exponent in the monomials.
    pub fn coefficient(&self, symbol: Symbol, exponent: i16) -> Self {
        self.collect(|sum| {
            for (term, c) in &self.terms {
                if term.monomial.exponent(symbol) == exponent {
                    let monomial = Monomial(term.monomial.0.without(symbol));
                    let wave = term.wave.clone();
                    sum.push(Term { monomial, wave }, *c);
                }
            }
        })
    }
}
