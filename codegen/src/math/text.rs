//! Formulas as text: `½ m l² (4 φ̇² − 3 cos φ)`.

use core::fmt;

use super::numbers::{number, superscript};
use super::{Equation, Math};

impl fmt::Display for Math {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number { numerator, denominator } => f.write_str(&number(*numerator, *denominator)),
            Self::Symbol(name, dots) => f.write_str(&name.text(*dots)),
            Self::Of(what, name) => write!(f, "{what}({name})"),
            Self::Entry(matrix, indices) => write!(f, "{matrix}[{}]", joined(indices, ", ")),
            Self::Words(words) => f.write_str(words),
            Self::Minus(inner) => write!(f, "−{inner}"),
            Self::Sum(terms) => sum(terms, f),
            Self::Product(factors) => f.write_str(&joined(factors, " ")),
            Self::Multiple(number, symbol) => write!(f, "{number}{}{symbol}", gap(symbol)),
            Self::Power(base, exponent) => {
                write!(f, "{base}{}", superscript(&exponent.to_string()))
            }
            Self::Fraction { parts, wide: false } => write!(f, "{}/{}", parts[0], parts[1]),
            Self::Fraction { parts, wide: true } => write!(f, "{} / {}", parts[0], parts[1]),
            Self::Apply { function, power, argument } => {
                let raised = if *power == 1 { String::new() } else { superscript(&power.to_string()) };
                let gap = if matches!(**argument, Self::Group(_)) { "" } else { " " };
                write!(f, "{function}{raised}{gap}{argument}")
            }
            Self::Root(inner) => write!(f, "√({inner})"),
            Self::Group(inner) => write!(f, "({inner})"),
        }
    }
}

fn sum(terms: &[Math], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (i, term) in terms.iter().enumerate() {
        match term {
            Math::Minus(inner) if i > 0 => write!(f, " − {inner}")?,
            term if i > 0 => write!(f, " + {term}")?,
            term => write!(f, "{term}")?,
        }
    }
    Ok(())
}

fn joined(parts: &[Math], between: &str) -> String {
    parts.iter().map(Math::to_string).collect::<Vec<_>>().join(between)
}

/// Words keep their distance to a number.
fn gap(symbol: &Math) -> &'static str {
    match symbol {
        Math::Symbol(name, _) if !name.is_letter() => " ",
        _ => "",
    }
}

impl fmt::Display for Equation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.left, self.right)
    }
}
