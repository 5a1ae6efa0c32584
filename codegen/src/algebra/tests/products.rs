//! Which sums of waves are written as products, and that these have the same value.

use super::super::{Angle, Monomial, Rational, Series, Shorthand, Symbol, Term};
use super::random::*;
use super::text::Pair;
use proptest::collection::vec;
use proptest::prelude::*;

/// The series with every product of waves multiplied out.
fn expanded(series: &Series, names: &Shorthand) -> Series {
    let products = series.symbols().into_iter().filter_map(|s| match s {
        Symbol::Opaque { index, .. } => Some((s, &names.products[usize::from(index)])),
        _ => None,
    });
    products.fold(series.clone(), |series, (symbol, factors)| {
        let waves = factors.clone().map(|wave| Term { monomial: Monomial::ONE, wave });
        let waves = waves.map(|term| Series::term(Rational::ONE, term));
        series.substitute(symbol, &(&waves[0] * &waves[1]))
    })
}

/// Sums of products of two waves.
fn waves() -> impl Strategy<Value = Series> {
    let parts = prop::sample::select(vec![Series::one(), symbol(M), symbol(L)]);
    let wave = || (-2..=2, -2..=2, 0..4_i64).prop_map(|(k, n, q)| Series::cos(&angle(k, n, q)));
    let term = (-3..=3_i64, wave(), wave(), parts).prop_map(|(c, a, b, part)| (part * a * b).scale(c.into()));
    vec(term, 0..4).prop_map(|terms| terms.iter().sum())
}

proptest! {
    #[test]
    fn products_have_the_value_of_their_sums(a in waves(), b in waves()) {
        let series = a + b * symbol(Y);
        let mut names = Shorthand::new(&Pair);
        let short = names.shortened(&series);
        prop_assert!(short.len() <= series.len());
        prop_assert_eq!(expanded(&short, &names), series);
    }
}

fn text(series: &Series) -> String {
    let mut names = Shorthand::new(&Pair);
    let short = names.shortened(series);
    assert_eq!(expanded(&short, &names), *series);
    short.text(&names)
}

fn doubled() -> Series {
    Series::cos(&angle(2, 0, 0))
}

#[test]
fn sums_stay_where_products_are_not_shorter() {
    let unchanged = |series: &Series| assert_eq!(Shorthand::new(&Pair).shortened(series), *series);
    // 1 + 2 cos² φ has no smaller numbers, and a sine of twice an angle is no square.
    unchanged(&(Series::integer(2) + doubled()));
    unchanged(&(Series::integer(5) + Series::sin(&angle(2, 0, 0)).scale(3.into())));
    // 5 cos φ cos ψ + sin φ sin ψ has as many terms.
    let (sum, difference) = (Series::cos(&angle(1, 1, 0)), Series::cos(&angle(1, -1, 0)));
    unchanged(&(sum.scale(2.into()) + difference.scale(3.into())));
    unchanged(&(Series::sin(&angle(1, 1, 0)) + difference));
    // Of an odd and an even multiple there is no half.
    unchanged(&(Series::cos(&angle(1, 1, 0)) + Series::cos(&angle(2, 1, 0))));
}

#[test]
fn the_square_of_fewer_signs_and_smaller_numbers_is_taken() {
    // −8 + 6 cos² φ has smaller numbers than −5 + 3 cos 2φ too, but one sign less than the other
    // square.
    assert_eq!(text(&(Series::integer(-5) + doubled().scale(3.into()))), "−2 (1 + 3 sin² φ)");
    // Against 5 m + 5 l + (m − 3 l) cos 2φ: sums 3 + 1 + 1 + 3 of sin², 2 + 4 + 1 + 3 of cos².
    let (m, l) = (symbol(M), symbol(L));
    let mixed = (&m + &l).scale(5.into()) + (&m - &l.scale(3.into())) * doubled();
    let found = text(&mixed);
    assert!(found.contains("sin² φ") && !found.contains("cos² φ"), "{found}");
}

#[test]
fn a_product_that_returns_is_the_same() {
    let [sin, cos] = [Series::sin, Series::cos].map(|wave| [PHI, PSI].map(|s| wave(&Angle::from_symbol(s))));
    let (sines, cosines, y) = (&sin[0] * &sin[1], &cos[0] * &cos[1], symbol(Y));
    let series = &sines + &(&y * &cosines) + y.pow(2) * sines.scale(3.into());
    let mut names = Shorthand::new(&Pair);
    let short = names.shortened(&series);
    assert_eq!((short.len(), names.products.len()), (3, 2));
    assert_eq!(expanded(&short, &names), series);
}

/// Of one symbol, low multiples first.
#[test]
fn factors_of_products_stand_in_order() {
    assert_eq!(text(&(Series::cos(&angle(1, 0, 0)) + Series::cos(&angle(3, 0, 0)))), "2 cos φ cos 2φ");
    assert_eq!(text(&(Series::sin(&angle(1, 0, 0)) + Series::sin(&angle(3, 0, 0)))), "2 cos φ sin 2φ");
    assert_eq!(text(&(Series::sin(&angle(3, 0, 0)) - Series::sin(&angle(1, 0, 0)))), "2 sin φ cos 2φ");
}

/// 46 waves of 46 angles, and two that make a product; with another one nothing is tried.
#[test]
fn sums_of_too_many_waves_stay() {
    let other = |range: std::ops::Range<usize>| -> Series {
        range.map(|i| Series::cos(&Angle::from_symbol(Symbol::coordinate(i)))).sum()
    };
    let pair = Series::cos(&angle(1, -1, 0)) - Series::cos(&angle(1, 1, 0));
    let length = |series: Series| Shorthand::new(&Pair).shortened(&series).len();
    assert_eq!([48, 49].map(|end| length(other(2..end) + &pair)), [47, 49]);
}
