//! How long an expression may be, and what a pivot may lose.

use std::collections::BTreeMap;

use super::super::reduction::{TERMS, is_small, solve};
use super::super::rules::solved;
use crate::algebra::{Angle, Quotient, Rational, Series, Symbol};
use crate::tests::analysis;

fn parameter(i: usize) -> Series {
    Series::symbol(Symbol::parameter(i))
}

/// So many terms.
fn long(terms: usize) -> Series {
    (0..terms).map(parameter).sum()
}

#[test]
fn expressions_have_so_many_terms_at_most() {
    let lost = Series::constant(Rational::OVERFLOW);
    assert_eq!([long(TERMS), long(TERMS + 1), lost].map(|f| is_small(&f.into())), [true, false, false]);
    // x₀ = 0, x₀ + x₁ = r.
    let [zero, one] = [Series::zero(), Series::one()];
    for (terms, found) in [(TERMS, true), (TERMS + 1, false)] {
        let mut matrix =
            [[&one, &zero], [&one, &one]].map(|row| row.map(|x| Quotient::from(x.clone())).to_vec());
        let mut right = [zero.clone(), long(terms)].map(Quotient::from);
        assert_eq!(solve(&mut matrix, &mut right).is_some(), found);
        assert_eq!(right[1].numerator(), &long(terms));
    }
}

/// k (1 + a) (1 + b) … (1 + h) has 256 terms.
#[test]
fn where_nothing_is_eliminated_expressions_may_be_long() {
    let names = ["a", "b", "c", "d", "e", "f", "h", "i"];
    let product: String = names.map(|name| format!(" * (1 + {name})")).concat();
    let fields: String = names.map(|name| format!("{name}: f64, ")).concat();
    let driven = analysis(&format!(
        "#[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[couple(OA = k{product})] #[figure(A = (l, 0))]
         struct Driven {{ {fields} k: f64, m: f64, l: f64 }}"
    ));
    assert_eq!(driven.phases.len(), 1);
    assert_eq!(driven.phases[0].forces[0].numerator().len(), 256);
    const { assert!(256 > TERMS) };
}

/// p q + r = 0: a moving pivot may be small, a sum of parameters and a wave too, a product of
/// parameters not.
#[test]
fn pivots_that_may_vanish_are_reported() {
    let [x, q] = [0, 1].map(Symbol::coordinate);
    let cosine = Series::cos(&Angle::from_symbol(Symbol::parameter(2)));
    let pivot = |p: &Series| solved(&(p * &Series::symbol(q) + parameter(3)), q, &BTreeMap::new()).unwrap();
    for p in [
        Series::symbol(x),
        Series::symbol(x) * parameter(0),
        Series::cos(&Angle::from_symbol(x)),
        &parameter(0) + &parameter(1),
        cosine,
    ] {
        let (value, told, _) = pivot(&p);
        assert_eq!(told, Some(p.clone()));
        assert!((value * Quotient::from(p) + Quotient::from(parameter(3))).is_zero());
    }
    assert_eq!(
        [parameter(0), &parameter(0) * &parameter(1), Series::integer(-2)].map(|p| pivot(&p).1),
        [None, None, None]
    );
}

#[test]
fn only_what_is_linear_is_solved() {
    let q = Symbol::coordinate(1);
    let series = Series::symbol(q);
    let equations = [
        series.pow(2) + parameter(0),
        Series::sin(&Angle::from_symbol(q)) + &series,
        parameter(0),
        Series::cos(&Angle::from_symbol(q)),
    ];
    assert!(equations.iter().all(|equation| solved(equation, q, &BTreeMap::new()).is_none()));
}
