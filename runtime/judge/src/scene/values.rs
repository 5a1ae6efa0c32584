//! Numbers of a declaration for the values of its parameters.

use crate::tape::whole;
use liftoff_codegen::algebra::{Angle, Rational, Series, Symbol};
use liftoff_codegen::system::{Definition, System};
use liftoff_core::scalar::Scalar;

/// Values of the parameters, then of the constants derived from them.
pub(crate) struct Values<S>(Vec<S>);

impl<S: Scalar> Values<S> {
    pub fn new(system: &System, parameters: &[f64]) -> Self {
        let mut values = Self(parameters.iter().map(|&x| S::from_f64(x)).collect());
        for constant in &system.constants {
            let value = match constant {
                Definition::Sqrt(a) => values.number(a).sqrt(),
                Definition::Ratio(a, b) => values.number(a) / values.number(b),
            };
            values.0.push(value);
        }
        values
    }

    /// Of a series of parameters; not a number if it has anything else in it.
    pub fn number(&self, series: &Series) -> S {
        if series.is_overflow() {
            return S::from_f64(f64::NAN);
        }
        series.terms().fold(S::ZERO, |sum, (term, coefficient)| {
            let factors = term.monomial.factors().iter();
            let product = factors
                .fold(ratio(coefficient), |product, &(symbol, k)| product * power(self.symbol(symbol), k));
            if term.wave.is_one() {
                return sum + product;
            }
            let (sin, cos) = self.sum(&term.wave.argument).sin_cos();
            sum + product * if term.wave.sine { sin } else { cos }
        })
    }

    pub fn pair(&self, pair: &[Series; 2]) -> [S; 2] {
        [self.number(&pair[0]), self.number(&pair[1])]
    }

    pub fn angle(&self, angle: &Angle) -> S {
        self.sum(angle.terms()) + S::pi() * whole(angle.quarter_turns().into()) / whole(2)
    }

    fn sum(&self, terms: &[(Symbol, i16)]) -> S {
        terms.iter().fold(S::ZERO, |sum, &(symbol, k)| sum + self.symbol(symbol) * whole(k.into()))
    }

    fn symbol(&self, symbol: Symbol) -> S {
        let known = if let Symbol::Parameter(i) = symbol { self.0.get(usize::from(i)) } else { None };
        known.copied().unwrap_or(S::from_f64(f64::NAN))
    }
}

fn ratio<S: Scalar>(rational: Rational) -> S {
    integer::<S>(rational.numerator()) / integer(rational.denominator())
}

/// In parts of 40 bits, so that no digit is lost.
fn integer<S: Scalar>(n: i128) -> S {
    let mut parts = Vec::new();
    let mut rest = n;
    while rest != 0 {
        parts.push((rest % (1 << 40)) as i64);
        rest /= 1 << 40;
    }
    parts.iter().rev().fold(S::ZERO, |sum, &part| sum * whole(1 << 40) + whole(part))
}

fn power<S: Scalar>(x: S, k: i16) -> S {
    let product = (0..k.unsigned_abs()).fold(whole::<S>(1), |product, _| product * x);
    if k < 0 { whole::<S>(1) / product } else { product }
}
