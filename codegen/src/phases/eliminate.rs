//! What counts as closed form: a length that enters a gap linearly, an angle that a gap equates
//! with others or with a prescribed motion, `sin α = sin β` or `cos α = cos β` on the branch of the
//! nominal figure; and for a slip, which has velocities only, a rate: its coordinate stays.

use std::collections::BTreeMap;

use super::elimination::{CoordinateValue, Elimination};
use super::rules::{Candidate, cheapest, equal_angles, equal_waves, linear, solved};
use crate::algebra::{Angle, Quotient, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::Motion;

/// Solves `rows` one by one, cheapest pivot first; `None` where a row resists both rules or repeats
/// others.
pub(super) fn eliminate(
    kinematics: &Kinematics,
    motion: &Motion,
    rows: &[usize],
    samples: &[BTreeMap<Symbol, f64>],
) -> Option<Vec<Elimination>> {
    let values = samples.first()?;
    let slips = motion.slips();
    let mut open: Vec<(usize, Quotient)> = rows
        .iter()
        .filter(|&&row| row < slips)
        .map(|&row| (row, motion.rows[row].gap.clone().into()))
        .collect();
    let mut done: Vec<Elimination> = Vec::new();
    while !open.is_empty() {
        let numerators = || open.iter().map(|(row, gap)| (*row, gap.numerator()));
        let linear = numerators().flat_map(|(row, gap)| linear(kinematics, row, gap, values));
        let found = cheapest(linear)
            .or_else(|| numerators().find_map(|(row, gap)| equal_angles(kinematics, row, gap)))
            .or_else(|| numerators().find_map(|(row, gap)| equal_waves(kinematics, row, gap, samples)))?;
        open.retain(|(row, _)| *row != found.row);
        for (_, gap) in &mut open {
            *gap = substituted(gap, &found);
        }
        for earlier in &mut done {
            earlier.value = match &earlier.value {
                CoordinateValue::Length(value) => CoordinateValue::Length(substituted(value, &found)),
                CoordinateValue::Angle(angle) => CoordinateValue::Angle(turned(angle, &found)),
                CoordinateValue::Rate(rate) => CoordinateValue::Rate(substituted(rate, &found)),
            };
            earlier.pivot = earlier.pivot.take().map(|p| substituted(&p.into(), &found).numerator().clone());
        }
        done.push(found);
    }
    for &row in rows.iter().filter(|&&row| row >= slips) {
        let found = stick(motion, row, &done, values)?;
        for earlier in &mut done {
            if let CoordinateValue::Rate(rate) = &earlier.value {
                earlier.value = CoordinateValue::Rate(substituted(rate, &found));
            }
        }
        done.push(found);
    }
    Some(done)
}

/// `Σ Jᵢ uᵢ + ∂g/∂t = 0`, solved for the rate whose coefficient is simplest.
fn stick(
    motion: &Motion,
    row: usize,
    done: &[Elimination],
    values: &BTreeMap<Symbol, f64>,
) -> Option<Elimination> {
    let slip = substitute_all(&motion.rows[row].velocity().into(), done);
    let free = (0..motion.n).filter(|i| done.iter().all(|e| e.coordinate != *i));
    let candidates = free.filter_map(|coordinate| {
        let (value, pivot, cost) = solved(slip.numerator(), Symbol::rate(coordinate), values)?;
        let elimination =
            Elimination { coordinate, row, value: CoordinateValue::Rate(value), pivot, branch: None };
        Some(Candidate { elimination, cost })
    });
    cheapest(candidates)
}

/// An expression with everything eliminated replaced; rates twice, as the rate of one may bring in
/// another.
pub(super) fn substitute_all(expression: &Quotient, eliminated: &[Elimination]) -> Quotient {
    let rates = eliminated.iter().filter(|e| matches!(e.value, CoordinateValue::Rate(_)));
    eliminated.iter().chain(rates).fold(expression.clone(), |q, e| substituted(&q, e))
}

/// An expression with an eliminated coordinate, its rate and its acceleration replaced.
pub(super) fn substituted(expression: &Quotient, elimination: &Elimination) -> Quotient {
    let index = elimination.coordinate;
    match &elimination.value {
        CoordinateValue::Angle(angle) => expression.substitute_angle(Symbol::coordinate(index), angle),
        CoordinateValue::Length(value) => {
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
        CoordinateValue::Rate(value) => {
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
        CoordinateValue::Angle(value) => angle.substitute(Symbol::coordinate(elimination.coordinate), value),
        CoordinateValue::Length(_) | CoordinateValue::Rate(_) => angle.clone(),
    }
}

/// An angle with everything eliminated replaced, and the full turns that it has lost by that: as a
/// number it stands for the sum of what the coordinates stand for.
pub(super) fn turned_by_all(angle: &Angle, eliminated: &[Elimination]) -> (Angle, i64) {
    let quarters = |elimination: &Elimination| match &elimination.value {
        CoordinateValue::Angle(value) => {
            let coordinate = Symbol::coordinate(elimination.coordinate);
            i64::from(angle.coefficient(coordinate)) * value.signed_quarters()
        }
        CoordinateValue::Length(_) | CoordinateValue::Rate(_) => 0,
    };
    let all = angle.signed_quarters() + eliminated.iter().map(quarters).sum::<i64>();
    let found = eliminated.iter().fold(angle.clone(), |angle, elimination| turned(&angle, elimination));
    let lost_turns = (all - found.signed_quarters()) / 4;
    (found, lost_turns)
}
