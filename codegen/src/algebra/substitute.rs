//! Replacing symbols by series and angles.

use super::{Angle, Rational, Series, Symbol, Term};
use std::collections::BTreeSet;

impl Series {
    /// `value` in place of a symbol in the monomials, not in waves. A negative power needs a value
    /// that is a monomial of parameters; else the result is overflow.
    pub fn substitute(&self, symbol: Symbol, value: &Self) -> Self {
        if self.is_overflow() {
            return Self::overflow();
        }
        let powers = self.powers_of(symbol);
        if powers.iter().all(|&k| k == 0) {
            return self.clone();
        }
        let parts = powers.iter().map(|&k| {
            let part = self.coefficient(symbol, k);
            if k == 0 { part } else { part * value.integer_power(k) }
        });
        parts.sum()
    }

    /// An angle in place of a coordinate (or of a parameter that stands for an angle): in waves,
    /// and in the monomials with its rates, where q⁽ᵏ⁾ becomes the k-th time derivative of `value`.
    /// An angle with quarter turns in place of q itself in a monomial is no series: overflow.
    pub fn substitute_angle(&self, symbol: Symbol, value: &Angle) -> Self {
        let waves: Self = self.entries().iter().map(|(term, c)| term.with_angle(*c, symbol, value)).sum();
        let mut result = if self.is_overflow() { Self::overflow() } else { waves };
        for current in self.symbols() {
            if let Some(order) = order(symbol, current) {
                result = result.substitute(current, &value.derivative(order));
            }
        }
        result
    }

    /// The exponents with which a symbol occurs.
    pub(super) fn powers_of(&self, symbol: Symbol) -> BTreeSet<i16> {
        self.exponents(symbol).collect()
    }

    fn integer_power(&self, k: i16) -> Self {
        let magnitude = u32::from(k.unsigned_abs());
        if k.is_negative() {
            return self.recip_monomial().map_or_else(Self::overflow, |inverse| inverse.pow(magnitude));
        }
        self.pow(magnitude)
    }
}

/// Which time derivative of `symbol`, if any, the other one is: of a coordinate any, of others
/// themselves only.
fn order(symbol: Symbol, other: Symbol) -> Option<u8> {
    match (symbol, other) {
        (Symbol::Coordinate { index, .. }, Symbol::Coordinate { index: i, order }) if i == index => {
            Some(order)
        }
        _ => (other == symbol).then_some(0),
    }
}

impl Term {
    fn with_angle(&self, c: Rational, symbol: Symbol, value: &Angle) -> Series {
        let k = self.wave.argument.get(symbol);
        if k == 0 {
            return Series::term(c, self.clone());
        }
        let rest = Angle::from_multipliers(self.wave.argument.without(symbol));
        let angle = &rest + &value.scale(i32::from(k));
        let wave = if self.wave.sine { Series::sin(&angle) } else { Series::cos(&angle) };
        wave.times_monomial(c, &self.monomial)
    }
}

impl Angle {
    /// Its time derivative of that order as a series.
    fn derivative(&self, order: u8) -> Series {
        match order {
            0 => self.linear(),
            _ => (1..order).fold(self.rate(), |derivative, _| derivative.rate()),
        }
    }

    /// Σ kᵢ·symbolᵢ as a series; overflow where quarter turns, multiples of π, are left.
    fn linear(&self) -> Series {
        if self.quarter_turns() != 0 || self.multipliers().is_none() {
            return Series::overflow();
        }
        let terms = self.terms().iter();
        terms.map(|&(symbol, k)| Series::symbol(symbol).scale(i64::from(k).into())).sum()
    }
}
