//! Literals as exact rationals: `3`, `0.25`, `1e-3`.

use syn::{Lit, LitFloat};

use crate::algebra::Rational;
use crate::syntax::without_unit;

/// The exact value of a number.
pub(super) fn exact(literal: &Lit) -> syn::Result<Rational> {
    without_unit(literal)?;
    let value = match literal {
        Lit::Int(int) => int.base10_parse::<i128>().map(Rational::integer).ok(),
        Lit::Float(float) => decimal(float),
        other => return Err(syn::Error::new(other.span(), "expected a number")),
    };
    let text = "this number has too many digits for exact 128-bit fractions; make it a parameter";
    value.filter(|r| !r.is_overflow()).ok_or_else(|| syn::Error::new(literal.span(), text))
}

fn decimal(float: &LitFloat) -> Option<Rational> {
    let digits = float.base10_digits();
    let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let significand: i128 = format!("{whole}{fraction}").parse().ok()?;
    let exponent = exponent.parse::<i32>().ok()?.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    Some(Rational::integer(significand) * Rational::integer(10).pow(exponent))
}
