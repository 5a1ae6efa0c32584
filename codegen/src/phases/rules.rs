//! The rules by which a row is solved for one coordinate or rate.

use std::collections::BTreeMap;

use super::elimination::{AngleBranch, CoordinateValue, Elimination};
use crate::algebra::{Angle, Quotient, Series, Symbol};
use crate::kinematics::Kinematics;

/// Angles that differ by less are taken for equal: far above the rounding of a figure's numbers.
const NEAR: f64 = 1e-9;

/// Terms of the pivot, then how far it is from its largest value in the nominal figure.
pub(super) struct Candidate {
    pub elimination: Elimination,
    pub cost: (usize, f64),
}

/// The one with the simplest pivot.
pub(super) fn cheapest(candidates: impl Iterator<Item = Candidate>) -> Option<Elimination> {
    let cheaper = |a: &Candidate, b: &Candidate| a.cost.0.cmp(&b.cost.0).then(a.cost.1.total_cmp(&b.cost.1));
    candidates.min_by(cheaper).map(|candidate| candidate.elimination)
}

/// `p q + r = 0` with a length `q`: `q = −r / p`.
pub(super) fn linear<'a>(
    kinematics: &'a Kinematics,
    row: usize,
    gap: &'a Series,
    nominal: &'a BTreeMap<Symbol, f64>,
) -> impl Iterator<Item = Candidate> + 'a {
    let lengths = kinematics.coordinates.iter().enumerate().filter(|(_, c)| !c.is_angle());
    lengths.filter_map(move |(coordinate, _)| {
        let (value, pivot, cost) = solved(gap, Symbol::coordinate(coordinate), nominal)?;
        let elimination =
            Elimination { coordinate, row, value: CoordinateValue::Length(value), pivot, branch: None };
        Some(Candidate { elimination, cost })
    })
}

/// `−r / p` of `p x + r = 0`, with p where it may be small, and how many moving terms that has and
/// how small it is. At parameters as different as the angle of a slope and that of a wall there is
/// no nominal value: slopes are taken for gentle ones.
pub(super) fn solved(
    equation: &Series,
    symbol: Symbol,
    nominal: &BTreeMap<Symbol, f64>,
) -> Option<(Quotient, Option<Series>, (usize, f64))> {
    if equation.degree(symbol) != 1 || equation.in_wave(symbol) {
        return None;
    }
    let pivot = equation.coefficient(symbol, 1);
    let rest = equation.coefficient(symbol, 0);
    let moving = pivot.symbols().iter().any(|s| !s.is_parameter());
    let flat = || {
        let angles = pivot.symbols().into_iter().filter(|symbol| pivot.in_wave(*symbol));
        nominal.clone().into_iter().chain(angles.map(|angle| (angle, 0.0))).collect()
    };
    let cost = match moving {
        true => (pivot.len(), 1.0 - relative(&pivot, nominal)),
        false => (0, 1.0 - relative(&pivot, &flat())),
    };
    let may_be_small = moving || pivot.len() > 1 || pivot.terms().any(|(term, _)| !term.wave.is_one());
    Some((Quotient::new(-&rest, pivot.clone()), may_be_small.then_some(pivot), cost))
}

/// `Σ kᵢ αᵢ = 0` of angles outside waves, prescribed ones among them.
pub(super) fn equal_angles(kinematics: &Kinematics, row: usize, gap: &Series) -> Option<Elimination> {
    let mut zero = Angle::zero();
    for (term, c) in gap.terms() {
        let &[(symbol, 1)] = term.monomial.factors() else { return None };
        let angle = match symbol {
            Symbol::Coordinate { index, order: 0 } => kinematics.coordinates[usize::from(index)].is_angle(),
            Symbol::Opaque { .. } => true,
            _ => false,
        };
        let whole = (c.denominator() == 1).then(|| i32::try_from(c.numerator()).ok()).flatten();
        if !angle || !term.wave.is_one() {
            return None;
        }
        zero = &zero + &Angle::from_symbol(symbol).scale(whole?);
    }
    solve_angle(kinematics, row, &zero)
}

/// The pivot over the sum of its terms' magnitudes, waves taken as 1.
fn relative(pivot: &Series, nominal: &BTreeMap<Symbol, f64>) -> f64 {
    let value = |symbol: Symbol| nominal.get(&symbol).copied().unwrap_or(1.0);
    let bound: f64 = pivot
        .terms()
        .map(|(term, c)| {
            let powers = term.monomial.factors().iter().map(|&(s, k)| value(s).abs().powi(k.into()));
            c.to_f64().abs() * powers.product::<f64>()
        })
        .sum();
    pivot.evaluate(&value).abs() / bound
}

/// `c sin α ± c sin β = 0`, the same with cosines, or a single wave that vanishes.
pub(super) fn equal_waves(
    kinematics: &Kinematics,
    row: usize,
    gap: &Series,
    samples: &[BTreeMap<Symbol, f64>],
) -> Option<Elimination> {
    let terms: Vec<_> = gap.terms().collect();
    let branches = match terms[..] {
        [(a, _)] => {
            let zero = a.wave.angle().turned(if a.wave.sine { 0 } else { 3 });
            [zero.clone(), zero.turned(2)]
        }
        [(a, p), (b, r)] => {
            let alike = a.monomial == b.monomial && a.wave.sine == b.wave.sine && (p == r || p == -r);
            if !alike {
                return None;
            }
            let (alpha, beta) = (a.wave.angle(), b.wave.angle().turned(if p == r { 2 } else { 0 }));
            let other = if a.wave.sine { -beta.turned(2) } else { -&beta };
            [&alpha - &beta, &alpha - &other]
        }
        _ => return None,
    };
    let (branch, open) = nearest(branches, samples)?;
    let solved = solve_angle(kinematics, row, &branch.zero)?;
    Some(Elimination { branch: open.then_some(branch), ..solved })
}

/// The branch that is the nearer at every sample, and whether by how much depends on the
/// parameters.
pub(super) fn nearest([a, b]: [Angle; 2], samples: &[BTreeMap<Symbol, f64>]) -> Option<(AngleBranch, bool)> {
    let snapped = |x: f64| if x.abs() < NEAR { 0.0 } else { x };
    let farther = |values| snapped(wrapped_value(&b, values).abs() - wrapped_value(&a, values).abs());
    let by: Vec<f64> = samples.iter().map(farther).collect();
    let known =
        [&a, &b].into_iter().flat_map(Angle::terms).all(|(symbol, _)| samples[0].contains_key(symbol));
    let open = known && by.iter().any(|x| snapped(x - by[0]) != 0.0);
    if by.iter().all(|x| *x >= 0.0) {
        Some((AngleBranch { zero: a, other: b }, open))
    } else {
        by.iter().all(|x| *x <= 0.0).then_some((AngleBranch { zero: b, other: a }, open))
    }
}

fn solve_angle(kinematics: &Kinematics, row: usize, zero: &Angle) -> Option<Elimination> {
    let (coordinate, k) = (0..kinematics.coordinates.len()).rev().find_map(|i| {
        let k = zero.coefficient(Symbol::coordinate(i));
        (k.abs() == 1).then_some((i, k))
    })?;
    let own = Angle::from_symbol(Symbol::coordinate(coordinate)).scale(i32::from(k));
    let value = CoordinateValue::Angle((&own - zero).scale(i32::from(k)));
    Some(Elimination { coordinate, row, value, pivot: None, branch: None })
}

fn wrapped_value(angle: &Angle, values: &BTreeMap<Symbol, f64>) -> f64 {
    let value = angle.evaluate(&|symbol| values.get(&symbol).copied().unwrap_or(0.0));
    value.sin().atan2(value.cos())
}
