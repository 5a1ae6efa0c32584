//! Square roots: x = √r never stays with an exponent other than 0 or 1, xᵏ = x^(k mod 2) · r^⌊k/2⌋
//! (for k < 0 where r is a monomial).

use std::collections::BTreeSet;

use crate::algebra::{Rational, Series, Symbol};

/// The series with powers of a root reduced.
pub(super) fn reduce_root(a: Series, root: Symbol, radicand: &Series) -> Series {
    let exponents: BTreeSet<i16> = a.terms().map(|(term, _)| term.monomial.exponent(root)).collect();
    if exponents.iter().all(|k| (0..2).contains(k)) {
        return a;
    }
    let inverse = radicand.recip_monomial();
    let part = |&k: &i16| {
        let rest = a.coefficient(root, k);
        let squares = u32::from(k.div_euclid(2).unsigned_abs());
        match (&inverse, k < 0) {
            (None, true) => &rest * &power(root, k),
            (Some(inverse), true) => &(&rest * &power(root, k.rem_euclid(2))) * &inverse.pow(squares),
            (_, false) => &(&rest * &power(root, k.rem_euclid(2))) * &radicand.pow(squares),
        }
    };
    exponents.iter().map(part).sum()
}

/// √r = outside · √inside with an integer inside, free of the squares of primes below 1000.
pub(super) fn square_part(r: Rational) -> (Rational, Rational) {
    if let Some(root) = r.sqrt_exact() {
        return (root, Rational::ONE);
    }
    let mut inside = r * Rational::integer(r.denominator()) * Rational::integer(r.denominator());
    let mut outside = Rational::new(1, r.denominator());
    for p in (2..1000).map(Rational::integer) {
        let square = p * p;
        while (inside / square).denominator() == 1 {
            inside = inside / square;
            outside = outside * p;
        }
    }
    match inside.is_overflow() || outside.is_overflow() {
        true => (Rational::ONE, r),
        false => (outside, inside),
    }
}

/// symbolᵏ.
pub(super) fn power(symbol: Symbol, k: i16) -> Series {
    let power = Series::symbol(symbol).pow(k.unsigned_abs().into());
    match k < 0 {
        true => power.recip_monomial().unwrap_or(power),
        false => power,
    }
}
