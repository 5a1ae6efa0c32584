//! Single terms in print: number, parameters, reactions, coordinates by order, wave.

use super::super::{Monomial, Rational, Symbol, Term, Wave};
use super::names::{Names, symbol};
use super::numbers::{magnitude, power};

/// |c| · term.
pub(super) fn term(c: Rational, term: &Term, names: &dyn Names) -> String {
    let mut factors = monomial(&term.monomial, names);
    if !term.wave.is_one() {
        factors.push(wave(&term.wave, 1, names));
    }
    numbered(c, factors)
}

/// |c| in front of factors, left out where it is 1.
pub(super) fn numbered(c: Rational, mut factors: Vec<String>) -> String {
    if factors.is_empty() || c.abs() != Rational::ONE {
        factors.insert(0, magnitude(c));
    }
    factors.join(" ")
}

/// The factors of a monomial; parameters with negative exponents make one fraction of parameters.
pub(super) fn monomial(monomial: &Monomial, names: &dyn Names) -> Vec<String> {
    let mut sorted = monomial.factors().to_vec();
    sorted.sort_by_key(|&(symbol, _)| place(symbol));
    let (parameters, others): (Vec<_>, Vec<_>) =
        sorted.into_iter().partition(|(symbol, _)| symbol.is_parameter());
    let mut factors = fraction(&parameters, names);
    factors.extend(others.iter().map(|&(s, k)| factor(s, k, names)));
    factors
}

/// Parameters, reactions, then coordinates by order of derivative.
fn place(symbol: Symbol) -> (u16, Symbol) {
    let class = match symbol {
        Symbol::Parameter(_) => 0,
        Symbol::Reaction(_) | Symbol::Atom { .. } | Symbol::Time => 1,
        Symbol::Coordinate { order, .. } => 2 + u16::from(order),
    };
    (class, symbol)
}

fn factor(s: Symbol, exponent: i16, names: &dyn Names) -> String {
    power(&symbol(s, names), u32::from(exponent.unsigned_abs()))
}

fn fraction(parameters: &[(Symbol, i16)], names: &dyn Names) -> Vec<String> {
    let printed = |sign: i16| -> Vec<String> {
        let chosen = parameters.iter().filter(|(_, k)| k.signum() == sign);
        chosen.map(|&(s, k)| factor(s, k, names)).collect()
    };
    let (above, below) = (printed(1), printed(-1));
    let top = if above.is_empty() { "1".to_owned() } else { above.join(" ") };
    match below.as_slice() {
        [] => above,
        [single] => vec![format!("({top}/{single})")],
        several => vec![format!("({top}/({}))", several.join(" "))],
    }
}

/// sinᵏ or cosᵏ of an argument, in brackets unless it is a multiple of one letter.
pub(super) fn wave(wave: &Wave, k: u32, names: &dyn Names) -> String {
    let function = power(if wave.sine { "sin" } else { "cos" }, k);
    match &*wave.argument {
        &[(s, 1)] => format!("{function} {}", symbol(s, names)),
        &[(s, n)] if starts_with_one_letter(&symbol(s, names)) => {
            format!("{function} {n}{}", symbol(s, names))
        }
        arguments => format!("{function}({})", combination(arguments, names)),
    }
}

fn starts_with_one_letter(name: &str) -> bool {
    !name.chars().nth(1).is_some_and(|c| c.is_alphabetic())
}

fn combination(arguments: &[(Symbol, i16)], names: &dyn Names) -> String {
    let mut text = String::new();
    for &(s, k) in arguments {
        text += match (text.is_empty(), k < 0) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        let name = symbol(s, names);
        let gap = if starts_with_one_letter(&name) { "" } else { " " };
        text += &match k.unsigned_abs() {
            1 => name,
            n => format!("{n}{gap}{name}"),
        };
    }
    text
}
