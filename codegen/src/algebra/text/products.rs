//! Single terms as they are written: number, parameters, reactions, coordinates by order, wave.

use super::super::{Angle, Monomial, Rational, Symbol, Term, Wave};
use super::names::{PRODUCT, SymbolNames, symbol};
use crate::math::Math;

/// c · term.
pub(super) fn term(c: Rational, term: &Term, names: &dyn SymbolNames) -> Math {
    let waves = (!term.wave.is_one()).then(|| wave(&term.wave, 1, names));
    let (above, below) = term.monomial.over_parameters();
    let [above, below] = [above, below].map(|part| monomial(&part, names));
    // What stands below a function would be read as part of its argument.
    let plain = waves.is_none()
        && !above.iter().any(|factor| matches!(factor, Math::Apply { .. } | Math::Product(_)));
    if plain && !above.is_empty() && !below.is_empty() {
        return numbered(c, vec![Math::product(above).over(Math::product(below))]);
    }
    numbered(c, monomial(&term.monomial, names).into_iter().chain(waves).collect())
}

/// c in front of factors, left out where it is 1.
pub(super) fn numbered(c: Rational, factors: Vec<Math>) -> Math {
    let number =
        Math::Number { numerator: c.numerator().unsigned_abs(), denominator: c.denominator().unsigned_abs() };
    Math::product([number].into_iter().chain(factors)).signed(c.is_negative())
}

/// The factors of a monomial; parameters with negative exponents make one fraction of parameters.
pub(super) fn monomial(monomial: &Monomial, names: &dyn SymbolNames) -> Vec<Math> {
    let mut sorted = monomial.factors().to_vec();
    sorted.sort_by_key(|&(symbol, _)| rank_symbol(symbol, names));
    let (parameters, others): (Vec<_>, Vec<_>) =
        sorted.into_iter().partition(|(symbol, _)| symbol.is_parameter());
    let mut factors = fraction(&parameters, names);
    factors.extend(others.iter().map(|&(s, k)| factor(s, k, names)));
    factors
}

/// Parameters, reactions, then coordinates by order of derivative; products of waves last.
fn rank_symbol(symbol: Symbol, names: &dyn SymbolNames) -> (u16, u8, Symbol) {
    let (class, among) = match symbol {
        Symbol::Parameter(index) => (0, names.rank_parameter(index)),
        Symbol::Opaque { order: PRODUCT, .. } => (u16::MAX, 0),
        Symbol::Reaction(_) | Symbol::Opaque { .. } | Symbol::Time | Symbol::Sense(_) | Symbol::Switch(_) => {
            (1, 0)
        }
        Symbol::Coordinate { order, .. } => (2 + u16::from(order), 0),
    };
    (class, among, symbol)
}

fn factor(s: Symbol, exponent: i16, names: &dyn SymbolNames) -> Math {
    symbol(s, names).power(i32::from(exponent.unsigned_abs()))
}

fn fraction(parameters: &[(Symbol, i16)], names: &dyn SymbolNames) -> Vec<Math> {
    let written = |sign: i16| -> Vec<Math> {
        let chosen = parameters.iter().filter(|(_, k)| k.signum() == sign);
        chosen.map(|&(s, k)| factor(s, k, names)).collect()
    };
    let (above, below) = (written(1), written(-1));
    match below.len() {
        0 => above,
        _ => vec![Math::product(above).over(Math::product(below)).group()],
    }
}

/// sinᵏ or cosᵏ of an argument, in brackets unless it is one symbol or a multiple of one letter.
pub(super) fn wave(wave: &Wave, k: u32, names: &dyn SymbolNames) -> Math {
    let argument = match (combination(&wave.argument, names), &*wave.argument) {
        (single @ Math::Symbol(..), _) => single,
        (Math::Multiple(n, s), [_]) if is_letter(&s) => Math::Multiple(n, s),
        (other, _) => other.group(),
    };
    Math::Apply { function: if wave.sine { "sin" } else { "cos" }, power: k, argument: Box::new(argument) }
}

fn is_letter(symbol: &Math) -> bool {
    matches!(symbol, Math::Symbol(name, _) if name.is_letter())
}

fn combination(arguments: &[(Symbol, i16)], names: &dyn SymbolNames) -> Math {
    Math::sum(arguments.iter().map(|&(s, k)| multiple(k, symbol(s, names))))
}

fn multiple(k: i16, symbol: Math) -> Math {
    let symbol = if matches!(symbol, Math::Symbol(..)) { symbol } else { symbol.group() };
    let multiple = match k.unsigned_abs() {
        1 => symbol,
        n => Math::Multiple(Box::new(Math::integer(n.into())), Box::new(symbol)),
    };
    multiple.signed(k.is_negative())
}

impl Angle {
    /// The angle as it is written: integer multiples of symbols, then of ½π.
    pub fn math(&self, names: &dyn SymbolNames) -> Math {
        let mut terms = self.terms().to_vec();
        lead(&mut terms, |(_, k)| k.is_positive());
        let terms = terms.into_iter().map(|(s, k)| multiple(k, symbol(s, names)));
        let half = || Math::Number { numerator: 1, denominator: 2 };
        let pi = || Math::symbol("pi");
        let turns = match self.quarter_turns() {
            0 => None,
            2 => Some(pi()),
            quarters => Some(Math::Multiple(Box::new(half()), Box::new(pi())).signed(quarters == 3)),
        };
        Math::sum(terms.chain(turns))
    }
}

/// Puts the first of which this is true in front.
pub fn lead<T>(terms: &mut [T], is_leader: impl Fn(&T) -> bool) {
    if let Some(leader) = terms.iter().position(is_leader) {
        terms[..=leader].rotate_right(1);
    }
}
