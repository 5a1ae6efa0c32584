//! Formulas as they are set: what a fraction bar holds together needs no brackets, signs stand in
//! front, functions last.

use super::line_breaks::WHOLE;
use super::{Equation, Math};

impl Math {
    /// The same, to be set with fractions in two storeys.
    pub(super) fn normalise(&self) -> Self {
        match self {
            Self::Number { .. } | Self::Symbol(..) | Self::Of(..) | Self::Words(_) => self.clone(),
            Self::Entry(matrix, indices) => {
                Self::Entry(matrix, indices.iter().map(Self::normalise).collect())
            }
            Self::Minus(inner) => match inner.normalise() {
                Self::Group(inner) if matches!(*inner, Self::Minus(_)) => inner.minus(),
                other => other.minus(),
            },
            Self::Sum(terms) => Self::sum(terms.iter().map(Self::normalise)),
            Self::Product(factors) => product(factors.iter().map(Self::normalise)),
            Self::Multiple(number, symbol) => {
                Self::Multiple(Box::new(number.normalise()), Box::new(symbol.normalise()))
            }
            Self::Power(base, exponent) => base.normalise().power(*exponent),
            Self::Fraction { parts, wide } => fraction(parts.each_ref().map(|part| part.normalise()), *wide),
            Self::Apply { function, power, argument } => {
                Self::Apply { function, power: *power, argument: Box::new(argument.normalise()) }
            }
            Self::Root(inner) => Self::Root(Box::new(inner.normalise().without_brackets())),
            Self::Group(inner) => match inner.normalise() {
                fraction @ (Self::Fraction { .. } | Self::Symbol(..)) => fraction,
                inner => inner.group(),
            },
        }
    }

    fn without_brackets(self) -> Self {
        if let Self::Group(inner) = self { *inner } else { self }
    }
}

/// Factors with functions of angles last, and all signs in one.
fn product(factors: impl Iterator<Item = Math>) -> Math {
    let mut negative = false;
    let (mut first, mut last) = (Vec::new(), Vec::new());
    for factor in factors.flat_map(opened) {
        let factor = match factor {
            Math::Minus(inner) => {
                negative = !negative;
                *inner
            }
            other => other,
        };
        match factor {
            Math::Apply { .. } => last.push(factor),
            Math::Number { numerator: 1, denominator: 1 } => {}
            _ => first.push(factor),
        }
    }
    Math::product(joined(first).into_iter().chain(last)).signed(negative)
}

/// `½ (1/r)` as one fraction.
fn joined(mut factors: Vec<Math>) -> Vec<Math> {
    if let [Math::Number { numerator, denominator }, Math::Fraction { parts, .. }, ..] = &factors[..]
        && parts[0] == Math::ONE
    {
        let below = Math::product([Math::integer(*denominator), parts[1].clone()]);
        let parts = Box::new([Math::integer(*numerator), below]);
        let joined = Math::Fraction { parts, wide: false };
        factors.splice(..2, [joined]);
    }
    factors
}

/// What a pair of brackets holds, where it is no sum.
fn opened(factor: Math) -> Vec<Math> {
    match factor {
        Math::Group(inner) if !matches!(*inner, Math::Sum(_)) => opened(*inner),
        Math::Product(factors) => factors.into_iter().flat_map(opened).collect(),
        Math::Minus(inner) => {
            let mut factors = opened(*inner);
            factors[0] = factors[0].clone().minus();
            factors
        }
        other => vec![other],
    }
}

/// What is long stands behind the fraction, where lines can be broken: `(m/cos φ) (a + b + …)`.
fn fraction([above, below]: [Math; 2], wide: bool) -> Math {
    let long = |factor: &Math| matches!(factor, Math::Group(_) | Math::Sum(_)) && factor.width() > WHOLE;
    let factors = match above.without_brackets() {
        Math::Minus(above) => return fraction([*above, below], wide).minus(),
        Math::Product(factors) => factors,
        other => vec![other],
    };
    let (long, mut short): (Vec<Math>, Vec<Math>) = factors.into_iter().partition(long);
    let outside = match short.first() {
        Some(Math::Number { denominator: 2.., .. }) if !long.is_empty() => Some(short.remove(0)),
        _ => None,
    };
    let parts = Box::new([Math::product(short), below.without_brackets()]);
    let first = outside.into_iter().chain([Math::Fraction { parts, wide }]);
    Math::product(joined(first.collect()).into_iter().chain(long.into_iter().map(Math::group)))
}

impl Equation {
    pub(super) fn normalise(&self) -> Self {
        Self { left: self.left.normalise(), right: self.right.normalise() }
    }
}
