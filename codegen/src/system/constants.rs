//! Constants derived from parameters that are no Poisson series of them: roots, reciprocals of
//! sums, and angles that are no integer combination of parameters and quarter turns. Each distinct
//! one is a symbol.

use super::roots::{power, reduce_root, square_part};
use crate::algebra::{Angle, Rational, Series, Symbol, work};

/// How a derived constant is computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Definition {
    /// Square root.
    Sqrt(Series),
    /// Numerator over denominator.
    Ratio(Series, Series),
}

/// A convergent of π whose parts are exact in `f64` and which is within 5.4e-32 of it: what a
/// double-double can hold.
pub(super) const PI: (i128, i128) = (6_134_899_525_417_045, 1_952_799_169_684_491);

/// The largest part of a fraction that is a coefficient.
const LONGEST: i128 = 1_000_000_000_000;

/// The derived constants met so far.
#[derive(Clone, Debug)]
pub(super) struct Constants {
    parameters: usize,
    definitions: Vec<Definition>,
}

impl Constants {
    /// None yet, after so many parameters.
    pub fn after(parameters: usize) -> Self {
        Self { parameters, definitions: Vec::new() }
    }

    /// The definitions, each after those it depends on.
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// What a parameter symbol stands for, if it is a derived constant.
    pub fn definition(&self, index: usize) -> Option<&Definition> {
        self.definitions.get(index.checked_sub(self.parameters)?)
    }

    fn symbol(&self, index: usize) -> Symbol {
        Symbol::parameter(self.parameters + index)
    }

    fn define(&mut self, definition: Definition) -> Symbol {
        let index = match self.definitions.iter().position(|known| *known == definition) {
            Some(known) => known,
            None => {
                self.definitions.push(definition);
                self.definitions.len() - 1
            }
        };
        self.symbol(index)
    }

    /// A number; one of many digits is a symbol, so that products of several do not overflow.
    pub fn number(&mut self, value: Rational) -> Series {
        let parts = [value.numerator(), value.denominator()];
        if parts.iter().all(|part| part.abs() <= LONGEST) {
            return Series::constant(value);
        }
        let [n, d] = parts.map(|part| Series::constant(Rational::integer(part)));
        Series::symbol(self.define(Definition::Ratio(n, d)))
    }

    /// π.
    pub fn pi(&mut self) -> Symbol {
        self.define(pi())
    }

    fn known_pi(&self) -> Option<Symbol> {
        self.definitions.iter().position(|d| *d == pi()).map(|i| self.symbol(i))
    }

    /// a · b.
    pub fn multiply(&self, a: &Series, b: &Series) -> Series {
        self.reduce(a * b)
    }

    /// a / b; `None` for b = 0.
    pub fn divide(&mut self, a: &Series, b: &Series) -> Option<Series> {
        if b.is_zero() {
            return None;
        }
        if let Some(inverse) = b.recip_monomial() {
            return Some(self.multiply(a, &inverse));
        }
        if let Some(quotient) = a.divide_exact(b) {
            return Some(quotient);
        }
        let unit = unit(b).recip_monomial()?;
        let inverse = self.define(Definition::Ratio(Series::one(), b * &unit));
        Some(self.multiply(&self.multiply(a, &unit), &Series::symbol(inverse)))
    }

    /// √a; `None` for a negative number.
    pub fn sqrt(&mut self, a: &Series) -> Option<Series> {
        if a.is_zero() || a.is_overflow() {
            return Some(a.clone());
        }
        if a.as_constant().is_some_and(|c| c.signum() < 0) {
            return None;
        }
        let (content, _) = a.content();
        let (outside, inside) = square_part(content);
        let radicand = a.scale(content.recip()).scale(inside);
        if radicand.as_constant() == Some(Rational::ONE) {
            return Some(Series::constant(outside));
        }
        Some(Series::symbol(self.define(Definition::Sqrt(radicand))).scale(outside))
    }

    /// The angle of a series: integer multiples of parameters and of π/2 stay exact, the rest is
    /// one constant.
    pub fn angle(&mut self, a: &Series) -> Angle {
        let pi = self.known_pi();
        let (mut angle, mut exact) = (Angle::zero(), Series::zero());
        for (term, coefficient) in a.terms().filter(|(term, _)| term.wave.is_one()) {
            let &[(symbol, 1)] = term.monomial.factors() else {
                continue;
            };
            if Some(symbol) == pi {
                let quarters = nearest(coefficient * Rational::integer(2));
                angle = angle + Angle::quarters(quarters);
                exact += Series::symbol(symbol).scale(Rational::new(quarters.into(), 2));
            } else if let Some(k) = whole(coefficient) {
                angle = angle + Angle::from_symbol(symbol).scale(k);
                exact += Series::symbol(symbol).scale(coefficient);
            }
        }
        angle + self.inexact_angle(&(a - &exact))
    }

    /// What is no integer combination, as a constant of positive leading coefficient.
    fn inexact_angle(&mut self, rest: &Series) -> Angle {
        let Some(leading) = rest.terms().next().map(|(_, c)| c.signum()) else {
            return Angle::zero();
        };
        let denominator = Rational::integer(rest.content().0.denominator());
        let numerator = rest.scale(denominator * Rational::integer(leading.into()));
        let symbol = self.define(Definition::Ratio(numerator, Series::constant(denominator)));
        Angle::from_symbol(symbol).scale(leading)
    }

    fn reduce(&self, a: Series) -> Series {
        work::spend(self.definitions.len());
        self.definitions.iter().enumerate().rev().fold(a, |a, (i, definition)| match definition {
            Definition::Sqrt(radicand) => reduce_root(a, self.symbol(i), radicand),
            _ => a,
        })
    }
}

/// The content of a series as a series: a unit of the ring.
fn unit(a: &Series) -> Series {
    let (rational, monomial) = a.content();
    monomial
        .factors()
        .iter()
        .fold(Series::constant(rational), |product, &(symbol, k)| &product * &power(symbol, k))
}

fn pi() -> Definition {
    let [n, d] = [PI.0, PI.1].map(|part| Series::constant(Rational::integer(part)));
    Definition::Ratio(n, d)
}

fn whole(r: Rational) -> Option<i32> {
    (r.denominator() == 1).then(|| i16::try_from(r.numerator()).ok())?.map(i32::from)
}

/// The nearest integer to a ratio, halves up; 0 where it is no ratio.
fn nearest(r: Rational) -> i64 {
    let (n, d) = (r.numerator(), r.denominator());
    i64::try_from((2 * n + d).checked_div_euclid(2 * d).unwrap_or(0)).unwrap_or(0)
}
