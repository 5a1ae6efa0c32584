//! Random series, and points at which to evaluate them.

use super::super::{Angle, Rational, Series, Symbol};
use proptest::collection::vec;
use proptest::prelude::*;

pub(super) const L: Symbol = Symbol::Parameter(1);
pub(super) const M: Symbol = Symbol::Parameter(0);
pub(super) const PHI: Symbol = Symbol::coordinate(0);
pub(super) const PSI: Symbol = Symbol::coordinate(1);
pub(super) const PHI_RATE: Symbol = Symbol::rate(0);
pub(super) const Y: Symbol = Symbol::coordinate(2);

pub(super) fn symbol(s: Symbol) -> Series {
    Series::symbol(s)
}

/// k·φ + n·ψ + quarters·π/2.
pub(super) fn angle(k: i32, n: i32, quarters: i64) -> Angle {
    let waves = Angle::from_symbol(PHI).scale(k) + Angle::from_symbol(PSI).scale(n);
    waves + Angle::quarters(quarters)
}

fn factor() -> impl Strategy<Value = Series> {
    let symbols = [L, M, PHI_RATE, Symbol::rate(1), Symbol::acceleration(0), Y];
    prop_oneof![
        4 => prop::sample::select(symbols.to_vec()).prop_map(Series::symbol),
        1 => Just(Series::symbol(L).recip_monomial().unwrap()),
        4 => (-3..=3, -2..=2, 0..4_i64).prop_map(|(k, n, q)| Series::cos(&angle(k, n, q))),
    ]
}

fn term() -> impl Strategy<Value = Series> {
    let number = (-9..=9_i128, 1..=6_i128).prop_map(|(n, d)| Series::constant(Rational::new(n, d)));
    (number, vec(factor(), 0..4)).prop_map(|(c, factors)| factors.iter().fold(c, |p, f| p * f))
}

/// Sums of up to four products of up to three factors.
pub(super) fn series() -> impl Strategy<Value = Series> {
    vec(term(), 0..4).prop_map(|terms| terms.iter().sum())
}

/// Series other than zero.
pub(super) fn nonzero() -> impl Strategy<Value = Series> {
    series().prop_filter("zero", |series| !series.is_zero())
}

/// A value for every symbol, of order one and away from zero.
pub(crate) fn point(seed: u32) -> impl Fn(Symbol) -> f64 {
    move |s| {
        let code = match s {
            Symbol::Parameter(i) => f64::from(i),
            Symbol::Coordinate { index, order } => 10.0 + f64::from(index) + 3.7 * f64::from(order),
            Symbol::Reaction(i) => 20.0 + f64::from(i),
            Symbol::Opaque { index, order } => 30.0 + f64::from(index) + 3.7 * f64::from(order),
            Symbol::Time => 40.0,
            Symbol::Sense(i) => 50.0 + f64::from(i),
            Symbol::Switch(i) => 60.0 + f64::from(i),
        };
        1.2 + 0.7 * (code * 2.3 + f64::from(seed)).sin()
    }
}

/// Σ |terms|: what rounding is relative to.
pub(super) fn magnitude(series: &Series, value: &impl Fn(Symbol) -> f64) -> f64 {
    let terms = series.terms().map(|(term, c)| {
        let powers = term.monomial.factors().iter();
        let power: f64 = powers.map(|&(s, k)| value(s).powi(k.into())).product();
        (c.to_f64() * power).abs()
    });
    terms.sum()
}

/// A few hundred roundings, in products of magnitudes: arguments of waves reach some 20 rad, and
/// expanded products some hundred terms.
pub(super) const ROUNDING: f64 = 400.0 * f64::EPSILON;
