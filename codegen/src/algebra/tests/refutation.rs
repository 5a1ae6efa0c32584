//! What an image modulo a prime refutes, and what it must leave open.

use super::super::modular::{P, refutes};
use super::super::{Angle, Rational, Series, work};
use super::random::*;
use proptest::prelude::*;

proptest! {
    /// b | ab + 1 would make b a unit.
    #[test]
    fn all_that_does_not_divide_is_refuted(a in series(), b in nonzero()) {
        // A symbol or an angle is the widest.
        let (high, fast) = (symbol(Y).pow(9), Series::cos(&angle(9, 9, 0)));
        for b in [&b + &high, &b + fast, b].map(|b| b.primitive().2) {
            let product = &a * &b;
            prop_assert_eq!(refutes(&(&product + Series::one()), &b), b.as_constant().is_none());
            prop_assert!(!refutes(&product, &b));
        }
    }
}

/// y³ − u | y³ − v only if u = v.
#[test]
fn every_variable_has_a_value_of_its_own() {
    let angles = [PHI, PSI, M, L].map(|s| Series::cos(&Angle::from_symbol(s)));
    let all: Vec<_> = [M, L, PHI_RATE, PSI].map(symbol).into_iter().chain(angles).collect();
    let cube = symbol(Y).pow(3);
    for (i, u) in all.iter().enumerate() {
        for (k, v) in all.iter().enumerate() {
            assert_eq!(refutes(&(&cube - u), &(&cube - v)), i != k, "{i} {k}");
        }
    }
}

/// (1 + l³) (2 + cos 2φ) does not divide 1 + l³, but does so where z = exp(iφ) is a number: x = z
/// of degrees −2 to 2 tells.
#[test]
fn the_image_is_one_in_the_widest_variable() {
    let cube = Series::one() + symbol(L).pow(3);
    let wide = &cube * &(Series::integer(2) + Series::cos(&angle(2, 0, 0)));
    assert!(refutes(&cube, &wide));
    // And that of −l⁻⁵ … 1 where z has 2.
    let inverse = Series::one() + symbol(L).recip_monomial().unwrap().pow(5);
    let turning = Series::integer(2) + Series::cos(&angle(1, 0, 0));
    assert!(refutes(&turning, &(&turning * &inverse)));
}

#[test]
fn numbers_that_the_prime_divides_refute_nothing() {
    let p = Series::integer(P as i64);
    let (y, one) = (symbol(Y), Series::one());
    let q = &y + Series::integer(3);
    for d in [&p * y.pow(2) + &y + &one, y.pow(2) + &y + &p, &p * &y + symbol(L)] {
        assert_eq!((&d * &q).divide_exact(&d), Some(q.clone()));
    }
    let fine = y.scale(Rational::new(1, P.into())) + &one;
    let d = symbol(L) + &y;
    assert_eq!((&d * &fine).divide_exact(&d), Some(fine));
    assert!(!refutes(&one, &(&p * &d)));
}

/// (y²⁰⁰⁰ + 1) / (y¹⁰⁰⁰ + 1): 1001 steps of 1001 coefficients, each of which is less than an
/// operation on terms, but not for nothing.
#[test]
fn long_divisions_are_work() {
    let [n, d] = [2000, 1000].map(|k| symbol(Y).pow(k) + Series::one());
    let spends = |budget| {
        work::limited(budget, || {
            refutes(&n, &d);
            work::is_spent()
        })
    };
    assert!(spends(1001 * 1001 / 100) && !spends(1001 * 1001));
}
