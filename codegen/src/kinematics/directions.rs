//! Directions of the bodies from the affine relations `Σ kᵢ xᵢ + constant = 0` (integer `kᵢ`) that
//! declared coordinates, welds, equal angles and the mirror impose; Gaussian elimination on unit
//! coefficients.

use std::collections::BTreeMap;

use proc_macro2::Span;

use super::affine::{AffineAngle, Unknown};
use super::relations::{Relation, Subject, relations};
use super::{Coordinate, DependentAngle, evaluate_reading, figure_direction};
use crate::algebra::{Angle, Series, Symbol};
use crate::syntax::plain;
use crate::system::{CoordinateKind, Declared, ParameterValues, Reference, Settled, System};

/// A direction's component above this, negative, is taken for zero: far above the rounding of a
/// figure's numbers.
const NEAR: f64 = 1e-9;

/// The angular coordinates and the direction of each body in terms of them.
pub struct Directions {
    /// Declared coordinates that stay free, in order, then undeclared angles.
    pub coordinates: Vec<Coordinate>,
    /// Declared angles that follow them.
    pub dependent: Vec<DependentAngle>,
    /// Direction of each body.
    pub directions: Vec<Angle>,
    /// What the figure said of them, to be checked with a model's own parameters.
    pub settled: Vec<Settled>,
}

type Solved = BTreeMap<Unknown, AffineAngle>;

impl Directions {
    /// Solves all relations of `system`.
    ///
    /// # Errors
    /// Equal angles that contradict or repeat what is known already.
    pub fn solve(system: &System) -> syn::Result<Self> {
        let (mut solved, mut open) = (Solved::new(), Vec::new());
        let relations = relations(system).into_iter();
        let errors = relations.filter_map(|r| eliminate(system, r, &mut solved, &mut open).err());
        let errors = errors.reduce(|mut all, error| {
            all.combine(error);
            all
        });
        errors.map_or_else(|| Ok(name(system, &solved, open)), Err)
    }
}

fn eliminate(
    system: &System,
    relation: Relation,
    solved: &mut Solved,
    open: &mut Vec<Settled>,
) -> syn::Result<()> {
    let reduced = solved.iter().fold(relation.affine, |affine, (&x, value)| affine.substitute(x, value));
    if reduced.coefficients.is_empty() {
        return settled(&reduced.constant, &relation.subject, relation.span);
    }
    let unit = |x: &Unknown| reduced.coefficients.get(x).is_some_and(|k| k.abs() == 1);
    let pivot =
        relation.preferred.filter(unit).or_else(|| reduced.coefficients.keys().rev().copied().find(unit));
    let (pivot, value) = match pivot {
        Some(pivot) => {
            let k = reduced.coefficients[&pivot];
            let mut rest = reduced;
            rest.coefficients.remove(&pivot);
            (pivot, AffineAngle::constant(Angle::zero()).plus(-k, &rest))
        }
        None => halved(system, &reduced, open).ok_or_else(|| {
            let text = match reduced.coefficients.len() {
                1 => "this fixes a multiple of an angle; declare the angle itself",
                _ => {
                    "of angles that turn together one is a whole multiple of the other: `equal(phi, 2 * psi)`; where none is, \
                     both are multiples of the angle of a third bar"
                }
            };
            syn::Error::new(relation.span, text)
        })?,
    };
    for affine in solved.values_mut() {
        *affine = affine.clone().substitute(pivot, &value);
    }
    solved.insert(pivot, value);
    Ok(())
}

fn settled(constant: &Angle, subject: &Subject, span: Span) -> syn::Result<()> {
    let text = match (constant == &Angle::zero(), subject) {
        (true, Subject::Angle) => return Ok(()),
        (true, Subject::Weld(what)) => {
            format!("{what} repeats a constraint on these angles; remove it")
        }
        (false, Subject::Weld(what)) => {
            format!("{what} contradicts another constraint on these angles; remove it")
        }
        (true, Subject::Equal([a, b])) => format!("{a} and {b} are equal already; remove this constraint"),
        (false, Subject::Equal([a, b])) => {
            format!("{a} and {b} cannot be equal: other constraints make them differ by a constant")
        }
        (false, Subject::Angle) => "this contradicts another constraint on these angles".to_owned(),
    };
    Err(syn::Error::new(span, text))
}

/// `2 δ + constant = 0` has two solutions; the nominal figure says which.
fn halved(system: &System, affine: &AffineAngle, open: &mut Vec<Settled>) -> Option<(Unknown, AffineAngle)> {
    let (&unknown, &k) = affine.coefficients.first_key_value()?;
    let Unknown::Direction(body) = unknown else { return None };
    let quarters = i64::from(affine.constant.quarter_turns());
    let plain = affine.coefficients.len() == 1 && affine.constant.terms().is_empty();
    if !plain || k.abs() != 2 || quarters % 2 != 0 {
        return None;
    }
    let first = -i64::from(k.signum()) * quarters / 2;
    let nearer = |numbers: &ParameterValues, quarters: i64| {
        let off = quarters as f64 * core::f64::consts::FRAC_PI_2 - figure_direction(system, numbers, body);
        off.cos() >= -NEAR
    };
    let holds = |quarters: &i64| system.samples.iter().all(|numbers| nearer(numbers, *quarters));
    let quarters = [first, first + 2].into_iter().find(holds)?;
    open.extend(system.settled_direction(body, quarters));
    Some((unknown, AffineAngle::constant(Angle::quarters(quarters))))
}

fn name(system: &System, solved: &Solved, settled: Vec<Settled>) -> Directions {
    let mut coordinates = Vec::new();
    let mut symbols = BTreeMap::new();
    for (i, declared) in system.coordinates.iter().enumerate() {
        let angle = matches!(declared.kind, CoordinateKind::Angle { .. });
        if angle && !solved.contains_key(&Unknown::Declared(i)) {
            symbols.insert(Unknown::Declared(i), coordinates.len());
            let name = plain(&declared.name);
            coordinates.push(Coordinate { name, reading: declared.kind.clone() });
        }
    }
    for (body, declared) in system.bodies.iter().enumerate() {
        if !solved.contains_key(&Unknown::Direction(body)) {
            symbols.insert(Unknown::Direction(body), coordinates.len());
            let reference = Reference::Ground(Angle::zero());
            let reading = CoordinateKind::Angle { body, reference, sign: 1 };
            coordinates.push(Coordinate { name: format!("theta_{}", declared.name), reading });
        }
    }
    let angle = |x: Unknown| match solved.get(&x) {
        None => Angle::from_symbol(Symbol::coordinate(symbols[&x])),
        Some(value) => value.coefficients.iter().fold(value.constant.clone(), |sum, (x, &k)| {
            &sum + &Angle::from_symbol(Symbol::coordinate(symbols[x])).scale(k)
        }),
    };
    let directions = (0..system.bodies.len()).map(|body| angle(Unknown::Direction(body))).collect();
    let follows = |(i, declared): (usize, &Declared)| {
        let value = solved.contains_key(&Unknown::Declared(i)).then(|| angle(Unknown::Declared(i)))?;
        let declared = Coordinate { name: plain(&declared.name), reading: declared.kind.clone() };
        dependent(system, &coordinates, declared, &value)
    };
    let dependent = system.coordinates.iter().enumerate().filter_map(follows).collect();
    Directions { coordinates, dependent, directions, settled }
}

/// A declared angle by its value; none where that has a constant which is no whole multiple of
/// parameters.
fn dependent(
    system: &System,
    independent: &[Coordinate],
    declared: Coordinate,
    value: &Angle,
) -> Option<DependentAngle> {
    let (mut parameters, mut coordinates) = (Vec::new(), Vec::new());
    for &(symbol, factor) in value.terms() {
        match symbol {
            Symbol::Coordinate { index, .. } => coordinates.push((usize::from(index), i32::from(factor))),
            Symbol::Parameter(i) if usize::from(i) < system.parameters.len() => {
                parameters.push((usize::from(i), i32::from(factor)));
            }
            _ => return None,
        }
    }
    let turns = system.samples.first().map_or(0.0, |numbers| {
        let nominal = value.evaluate(&|symbol| match symbol {
            Symbol::Coordinate { index, .. } => {
                evaluate_reading(system, numbers, &independent[usize::from(index)].reading)
            }
            _ => numbers.evaluate(&Series::symbol(symbol)),
        });
        ((evaluate_reading(system, numbers, &declared.reading) - nominal) / core::f64::consts::TAU).round()
    });
    let quarters = i32::from(value.quarter_turns()) + 4 * turns as i32;
    Some(DependentAngle { declared, quarters, parameters, coordinates })
}
