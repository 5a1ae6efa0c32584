//! Sums and quotients in print, and the order of terms in them: highest derivatives first, then by
//! monomial, constants before waves, low multiples first; a positive term leads where there is one.

use super::super::{Powers, Quotient, Rational, Series, Symbol, Term};
use super::names::Names;
use super::numbers::power;
use super::products::{monomial, numbered, term, wave};
use std::cmp::Reverse;

impl Series {
    /// The series in textbook notation.
    pub fn text(&self, names: &dyn Names) -> String {
        if self.is_overflow() {
            return "overflow".to_owned();
        }
        match self.entries() {
            [] => "0".to_owned(),
            [(single, c)] => format!("{}{}", minus(*c), term(*c, single, names)),
            _ => self.sum_text(names),
        }
    }

    /// common factor (sum), or the sum alone where nothing is common.
    fn sum_text(&self, names: &dyn Names) -> String {
        let (number, common, rest) = self.factored();
        let sum = rest.terms_text(names);
        let mut factors = monomial(&common, names);
        if number.abs() == Rational::ONE && factors.is_empty() && number.signum() > 0 {
            return sum;
        }
        factors.push(format!("({sum})"));
        format!("{}{}", minus(number), numbered(number, factors))
    }

    /// The content with a sign, and the rest with a positive term.
    fn factored(&self) -> (Rational, super::super::Monomial, Self) {
        let (number, monomial, rest) = self.primitive();
        let all_negative = self.entries().iter().all(|(_, c)| c.signum() < 0);
        if number.signum() < 0 && !all_negative {
            return (-number, monomial, -rest);
        }
        (number, monomial, rest)
    }

    fn terms_text(&self, names: &dyn Names) -> String {
        let mut terms: Vec<_> = self.entries().iter().collect();
        terms.sort_by_cached_key(|(term, _)| rank(term));
        let leader = terms.iter().position(|(_, c)| c.signum() > 0);
        if let Some(leader) = leader {
            terms[..=leader].rotate_right(1);
        }
        let mut text = String::new();
        for (i, (each, c)) in terms.into_iter().enumerate() {
            text += match (i, c.signum() < 0) {
                (0, _) => minus(*c),
                (_, true) => " − ",
                (_, false) => " + ",
            };
            text += &term(*c, each, names);
        }
        text
    }

    /// As one factor of a denominator.
    fn factor_text(&self, k: u32, names: &dyn Names) -> String {
        match self.entries() {
            [(single, _)] if single.monomial.is_one() => wave(&single.wave, k, names),
            [(single, c)] => power(&term(*c, single, names), k),
            _ => power(&format!("({})", self.terms_text(names)), k),
        }
    }
}

impl Quotient {
    /// The quotient in textbook notation, the denominator in factors.
    pub fn text(&self, names: &dyn Names) -> String {
        let numerator = self.numerator().text(names);
        let several = self.numerator().len() > 1;
        let bare = several && self.numerator().factored().0 == Rational::ONE;
        let bare = bare && self.numerator().content().1.is_one();
        let above = if bare { format!("({numerator})") } else { numerator };
        let mut factors: Vec<_> = self.factors().iter().collect();
        factors.sort_by_key(|(factor, _)| factor.len());
        let below = factors.into_iter();
        let below: Vec<_> = below.map(|(f, k)| f.factor_text(*k, names)).collect();
        match below.as_slice() {
            [] => self.numerator().text(names),
            [single] => format!("{above} / {single}"),
            several => format!("{above} / ({})", several.join(" ")),
        }
    }
}

fn minus(c: Rational) -> &'static str {
    if c.signum() < 0 { "−" } else { "" }
}

type Rank = (Reverse<[i32; 3]>, Reverse<Powers>, i32, Reverse<Powers>, bool);

/// Degrees in accelerations (and beyond), rates, coordinates; monomial; multiple of the wave.
fn rank(term: &Term) -> Rank {
    let mut degrees = [0; 3];
    for &(symbol, k) in term.monomial.factors() {
        if let Symbol::Coordinate { order, .. } = symbol {
            degrees[2 - usize::from(order.min(2))] += i32::from(k);
        }
    }
    let multiples = term.wave.argument.iter();
    (
        Reverse(degrees),
        Reverse(term.monomial.0.clone()),
        multiples.map(|(_, k)| i32::from(k.abs())).sum(),
        Reverse(term.wave.argument.clone()),
        term.wave.sine,
    )
}
