//! What counts as closed form: a length that enters a gap linearly, an angle that a gap equates with others or with a
//! prescribed motion, `sin α = sin β` or `cos α = cos β` on the branch of the nominal figure; and for a slip, which has
//! velocities only, a rate: its coordinate stays.

use core::f64::consts::PI;
use std::collections::BTreeMap;

use crate::algebra::{Angle, Quotient, Series, Symbol, Term};
use crate::kinematics::{Kinematics, nominal_values};
use crate::motion::Motion;
use crate::system::System;

/// A coordinate in terms of others.
#[derive(Clone, Debug)]
pub enum Value {
    /// A length.
    Length(Quotient),
    /// An angle.
    Angle(Angle),
    /// A rate, in terms of coordinates and kept rates; the coordinate itself stays.
    Rate(Quotient),
}

/// A coordinate that a closed row determines.
#[derive(Clone, Debug)]
pub struct Elimination {
    /// Index of the coordinate.
    pub coordinate: usize,
    /// Index of the row that determines it.
    pub row: usize,
    /// Its value, in terms of the coordinates kept.
    pub value: Value,
    /// The row's coefficient of the coordinate, where it is not constant.
    pub pivot: Option<Series>,
}

/// Terms of the pivot, then how far it is from its largest value in the nominal figure.
struct Candidate {
    elimination: Elimination,
    cost: (usize, f64),
}

/// Solves `rows` one by one, cheapest pivot first; `None` where a row resists both rules or repeats others.
pub(super) fn eliminate(
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    rows: &[usize],
    nominal: &[f64],
) -> Option<Vec<Elimination>> {
    let values = nominal_values(system, nominal);
    let slips = motion.rows.len() - motion.tangents.len();
    let mut open: Vec<(usize, Quotient)> = rows
        .iter()
        .filter(|&&row| row < slips)
        .map(|&row| (row, motion.rows[row].gap.clone().into()))
        .collect();
    let mut done: Vec<Elimination> = Vec::new();
    while !open.is_empty() {
        let numerators = || open.iter().map(|(row, gap)| (*row, gap.numerator()));
        let linear = numerators().flat_map(|(row, gap)| linear(kinematics, row, gap, &values));
        let found = cheapest(linear)
            .or_else(|| numerators().find_map(|(row, gap)| equal_angles(kinematics, row, gap)))
            .or_else(|| numerators().find_map(|(row, gap)| equal_waves(kinematics, row, gap, &values)))?;
        open.retain(|(row, _)| *row != found.row);
        for (_, gap) in &mut open {
            *gap = substituted(gap, &found);
        }
        for earlier in &mut done {
            earlier.value = match &earlier.value {
                Value::Length(value) => Value::Length(substituted(value, &found)),
                Value::Angle(angle) => Value::Angle(turned(angle, &found)),
                Value::Rate(rate) => Value::Rate(substituted(rate, &found)),
            };
            earlier.pivot = earlier.pivot.take().map(|p| substituted(&p.into(), &found).numerator().clone());
        }
        done.push(found);
    }
    for &row in rows.iter().filter(|&&row| row >= slips) {
        let found = stick(motion, row, &done, &values)?;
        for earlier in &mut done {
            if let Value::Rate(rate) = &earlier.value {
                earlier.value = Value::Rate(substituted(rate, &found));
            }
        }
        done.push(found);
    }
    Some(done)
}

/// `Σ Jᵢ uᵢ = 0`, solved for the rate whose coefficient is simplest.
fn stick(
    motion: &Motion,
    row: usize,
    done: &[Elimination],
    values: &BTreeMap<Symbol, f64>,
) -> Option<Elimination> {
    let slip = motion.rows[row].jacobian.iter().enumerate();
    let slip: Series = slip.map(|(i, slope)| slope * &Series::symbol(Symbol::rate(i))).sum();
    let slip = onto(&slip.into(), done);
    let free = (0..motion.n).filter(|i| done.iter().all(|e| e.coordinate != *i));
    let candidates = free.filter_map(|coordinate| {
        let (value, pivot, cost) = solved(slip.numerator(), Symbol::rate(coordinate), values)?;
        let elimination = Elimination { coordinate, row, value: Value::Rate(value), pivot };
        Some(Candidate { elimination, cost })
    });
    cheapest(candidates)
}

fn cheapest(candidates: impl Iterator<Item = Candidate>) -> Option<Elimination> {
    let cheaper = |a: &Candidate, b: &Candidate| a.cost.0.cmp(&b.cost.0).then(a.cost.1.total_cmp(&b.cost.1));
    candidates.min_by(cheaper).map(|candidate| candidate.elimination)
}

/// An expression with everything eliminated replaced; rates twice, as the rate of one may bring in another.
pub(super) fn onto(expression: &Quotient, eliminated: &[Elimination]) -> Quotient {
    let rates = eliminated.iter().filter(|e| matches!(e.value, Value::Rate(_)));
    eliminated.iter().chain(rates).fold(expression.clone(), |q, e| substituted(&q, e))
}

/// An expression with an eliminated coordinate, its rate and its acceleration replaced.
pub(super) fn substituted(expression: &Quotient, elimination: &Elimination) -> Quotient {
    let index = elimination.coordinate;
    match &elimination.value {
        Value::Angle(angle) => expression.substitute_angle(Symbol::coordinate(index), angle),
        Value::Length(value) => {
            let mut result = expression.clone();
            let orders = [Symbol::acceleration(index), Symbol::rate(index), Symbol::coordinate(index)];
            for (order, symbol) in orders.into_iter().enumerate() {
                if result.depends_on(symbol) {
                    let value = (order..2).fold(value.clone(), |v, _| v.rate());
                    result = result.substitute_quotient(symbol, &value);
                }
            }
            result
        }
        Value::Rate(value) => {
            let mut result = expression.clone();
            let rate = Symbol::rate(index);
            if result.depends_on(Symbol::acceleration(index)) {
                result = result.substitute_quotient(Symbol::acceleration(index), &value.rate());
            }
            if result.depends_on(rate) {
                result = result.substitute_quotient(rate, value);
            }
            result
        }
    }
}

pub(super) fn turned(angle: &Angle, elimination: &Elimination) -> Angle {
    match &elimination.value {
        Value::Angle(value) => angle.substitute(Symbol::coordinate(elimination.coordinate), value),
        Value::Length(_) | Value::Rate(_) => angle.clone(),
    }
}

/// `p q + r = 0` with a length `q`: `q = −r / p`.
fn linear<'a>(
    kinematics: &'a Kinematics,
    row: usize,
    gap: &'a Series,
    nominal: &'a BTreeMap<Symbol, f64>,
) -> impl Iterator<Item = Candidate> + 'a {
    let lengths = kinematics.coordinates.iter().enumerate().filter(|(_, c)| !c.is_angle());
    lengths.filter_map(move |(coordinate, _)| {
        let (value, pivot, cost) = solved(gap, Symbol::coordinate(coordinate), nominal)?;
        let elimination = Elimination { coordinate, row, value: Value::Length(value), pivot };
        Some(Candidate { elimination, cost })
    })
}

/// `−r / p` of `p x + r = 0`, with p where it moves, and how many terms that has and how small it is.
fn solved(
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
    let cost = if moving { (pivot.len(), 1.0 - relative(&pivot, nominal)) } else { (0, 0.0) };
    Some((Quotient::new(-&rest, pivot.clone()), moving.then_some(pivot), cost))
}

/// `Σ kᵢ αᵢ = 0` of angles outside waves, prescribed ones among them.
fn equal_angles(kinematics: &Kinematics, row: usize, gap: &Series) -> Option<Elimination> {
    let mut zero = Angle::zero();
    for (term, c) in gap.terms() {
        let &[(symbol, 1)] = term.monomial.factors() else { return None };
        let angle = match symbol {
            Symbol::Coordinate { index, order: 0 } => kinematics.coordinates[usize::from(index)].is_angle(),
            Symbol::Atom { .. } => true,
            _ => false,
        };
        let whole = (c.denominator() == 1).then(|| i32::try_from(c.numerator()).ok()).flatten();
        if !angle || !term.wave.is_one() {
            return None;
        }
        zero = &zero + &Angle::of(symbol).scale(whole?);
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
fn equal_waves(
    kinematics: &Kinematics,
    row: usize,
    gap: &Series,
    nominal: &BTreeMap<Symbol, f64>,
) -> Option<Elimination> {
    let terms: Vec<_> = gap.terms().collect();
    let branches = match terms[..] {
        [(a, _)] => {
            let zero = Angle::quarters(if a.wave.sine { 0 } else { 1 });
            vec![&phase(a) - &zero, &(&phase(a) - &zero) - &Angle::quarters(2)]
        }
        [(a, p), (b, r)] => {
            let alike = a.monomial == b.monomial && a.wave.sine == b.wave.sine && (p == r || p == -r);
            if !alike {
                return None;
            }
            let half_turn = Angle::quarters(if p == r { 2 } else { 0 });
            let (alpha, beta) = (phase(a), &phase(b) + &half_turn);
            let other = if a.wave.sine { &Angle::quarters(2) - &beta } else { -&beta };
            vec![&alpha - &beta, &alpha - &other]
        }
        _ => return None,
    };
    let distance = |angle: &Angle| wrapped_value(angle, nominal).abs();
    let zero = branches.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    solve_angle(kinematics, row, &zero)
}

fn solve_angle(kinematics: &Kinematics, row: usize, zero: &Angle) -> Option<Elimination> {
    let (coordinate, k) = (0..kinematics.coordinates.len()).rev().find_map(|i| {
        let k = zero.coefficient(Symbol::coordinate(i));
        (k.abs() == 1).then_some((i, k))
    })?;
    let own = Angle::of(Symbol::coordinate(coordinate)).scale(i32::from(k));
    let value = Value::Angle((&own - zero).scale(i32::from(k)));
    Some(Elimination { coordinate, row, value, pivot: None })
}

fn phase(term: &Term) -> Angle {
    term.wave
        .argument
        .iter()
        .fold(Angle::zero(), |sum, &(symbol, k)| &sum + &Angle::of(symbol).scale(i32::from(k)))
}

fn wrapped_value(angle: &Angle, values: &BTreeMap<Symbol, f64>) -> f64 {
    let turns = f64::from(angle.quarter_turns()) * PI / 2.0;
    let sum = angle
        .terms()
        .iter()
        .fold(turns, |sum, (symbol, k)| sum + f64::from(*k) * values.get(symbol).copied().unwrap_or(0.0));
    (sum + PI).rem_euclid(2.0 * PI) - PI
}
