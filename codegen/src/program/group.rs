//! Terms of a series that share their powers of coordinates and rates, and how each such group is
//! evaluated.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::polynomial::{FactoredPolynomial, Polynomial};
use crate::algebra::{Monomial, Series, Symbol, Wave};

type Exponents = Vec<(Symbol, i16)>;

/// A trigonometric polynomial: what multiplies each wave depends on parameters only.
pub(super) type Group = BTreeMap<Wave, Series>;

/// Beyond this multiple of an angle, powers of its cosine lose more digits than addition theorems
/// do.
const DEGREE: i16 = 6;

/// How a group is evaluated.
pub(super) enum Plan {
    Plain,
    Versed,
    Polynomial { direction: Exponents, cosine: FactoredPolynomial, sine: FactoredPolynomial },
    Products(Vec<Product>),
}

/// A product of a sine or cosine of α and one of β, with its coefficient.
pub(super) struct Product {
    pub coefficient: Series,
    /// The argument, and whether it is the sine.
    pub factors: [(Exponents, bool); 2],
}

/// The terms by their powers of coordinates and rates; coefficients keep the parameters.
pub(super) fn groups(series: &Series) -> BTreeMap<Monomial, Group> {
    let mut groups: BTreeMap<Monomial, Group> = BTreeMap::new();
    for (term, coefficient) in series.terms() {
        let (parameters, powers) = term.monomial.split_units();
        let coefficient = Series::monomial(coefficient, parameters);
        match groups.entry(powers).or_default().entry(term.wave.clone()) {
            Entry::Vacant(entry) => {
                entry.insert(coefficient);
            }
            Entry::Occupied(mut entry) => *entry.get_mut() += coefficient,
        }
    }
    groups
}

/// Whether some cosines of the series could cancel: two of opposite signs, or a wave that might be
/// expanded.
pub(super) fn may_cancel(series: &Series) -> bool {
    let sign =
        |positive: bool| series.terms().any(|(term, c)| !term.wave.sine && (c.signum() > 0) == positive);
    let sines = || series.terms().filter(|(term, _)| term.wave.sine).count() > 1;
    sign(true) && sign(false) || sines()
}

pub(super) fn plan(group: &Group) -> Plan {
    let sum: Series = group.iter().filter(|(w, _)| !w.sine).map(|(_, c)| c.clone()).sum();
    let cosines = group.keys().filter(|w| !w.sine).count();
    if let Some(direction) = direction(group) {
        let highest = group.keys().map(|w| multiple(w, &direction)).max().unwrap_or(0);
        if highest <= DEGREE && (highest > 1 || sum.is_zero() && cosines > 1) {
            let (mut cosine, mut sine) = (Polynomial::default(), Polynomial::default());
            for (wave, coefficient) in group {
                let k = multiple(wave, &direction).unsigned_abs().into();
                match wave.sine {
                    false => cosine.add_first_kind(k, coefficient),
                    true => sine.add_second_kind(k - 1, coefficient),
                }
            }
            debug_assert!(!(cosine.is_zero() && sine.is_zero()));
            return Plan::Polynomial { direction, cosine: cosine.factored(), sine: sine.factored() };
        }
    }
    if let Some(products) = products(group) {
        return Plan::Products(products);
    }
    if cosines > 1 && sum.is_zero() { Plan::Versed } else { Plan::Plain }
}

/// a cos (α + β) + b cos (α − β) = (a + b) cos α cos β + (b − a) sin α sin β, of sines likewise;
/// `None` where other waves are among them.
fn products(group: &Group) -> Option<Vec<Product>> {
    let mut products = Vec::new();
    for sine in [false, true] {
        let waves: Vec<(&Wave, &Series)> = group.iter().filter(|(wave, _)| wave.sine == sine).collect();
        let [(p, a), (q, b)] = waves[..] else { if waves.is_empty() { continue } else { return None } };
        let half = |sign: i16| {
            let mut half: BTreeMap<Symbol, i16> = p.argument.iter().copied().collect();
            q.argument.iter().for_each(|&(symbol, k)| *half.entry(symbol).or_default() += sign * k);
            let even = half.values().all(|k| k % 2 == 0);
            let half = half.into_iter().filter(|(_, k)| *k != 0).map(|(symbol, k)| (symbol, k / 2));
            even.then(|| half.collect::<Exponents>())
        };
        let (alpha, beta) = (half(1)?, half(-1)?);
        if alpha.is_empty() || beta.is_empty() {
            return None;
        }
        let pairs = if sine {
            [(a + b, true, false), (a - b, false, true)]
        } else {
            [(a + b, false, false), (b - a, true, true)]
        };
        let pairs = pairs.into_iter().filter(|(coefficient, ..)| !coefficient.is_zero());
        products.extend(pairs.map(|(coefficient, first, second)| Product {
            coefficient,
            factors: [(alpha.clone(), first), (beta.clone(), second)],
        }));
    }
    Some(products)
}

/// The primitive argument of which all arguments are multiples, if there is one.
fn direction(group: &Group) -> Option<Exponents> {
    let first = group.keys().find(|wave| !wave.is_one())?;
    let gcd = first.argument.iter().fold(0, |g, &(_, k)| gcd(g, k.unsigned_abs()));
    let divisor = i16::try_from(gcd).ok()?;
    let direction: Exponents = first.argument.iter().map(|&(symbol, k)| (symbol, k / divisor)).collect();
    let along = |wave: &Wave| {
        let k = multiple(wave, &direction);
        wave.argument.len() == if k == 0 { 0 } else { direction.len() }
            && wave.argument.iter().zip(&direction).all(|(a, d)| a.0 == d.0 && a.1 == k * d.1)
    };
    group.keys().all(along).then_some(direction)
}

fn multiple(wave: &Wave, direction: &[(Symbol, i16)]) -> i16 {
    wave.argument.first().zip(direction.first()).map_or(0, |(a, d)| a.1 / d.1)
}

fn gcd(a: u16, b: u16) -> u16 {
    if b == 0 { a } else { gcd(b, a % b) }
}
