//! A pose as the user gives it: some coordinates, some rates.

use crate::assembly::StartError;
use crate::context::{CLOSED, RunContext};
use crate::error::NameError;
use crate::expression::{contact_of, normalize_rate, unknown_support};
use crate::model::names::CoordinateName;
use crate::model::{ContactSet, DependentAngle, Layout, Term};
use crate::system::Model;

/// Some coordinates and rates by name; a rate is named with a prime, `phi'`. `below(P)` = 1 says
/// that P has gone round an end of its edge and is below that now, which the coordinates do not
/// tell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pose {
    values: Vec<(String, f64)>,
}

impl Pose {
    /// The nominal figure at rest.
    pub fn nominal() -> Self {
        Self::default()
    }

    /// One coordinate or rate given.
    pub fn new(name: impl CoordinateName, value: f64) -> Self {
        Self::nominal().with(name, value)
    }

    /// One more coordinate or rate given.
    #[must_use]
    pub fn with(mut self, name: impl CoordinateName, value: f64) -> Self {
        self.values.push((name.as_ref().to_owned(), value));
        self
    }

    /// All coordinates and all rates given, in the order of a state.
    pub fn of_state(layout: &Layout, state: &[f64]) -> Self {
        Self { values: layout.names_of_state().zip(state.iter().copied()).collect() }
    }

    /// The coordinates and the rates given, in their places; elsewhere what they are nominally, and
    /// zero.
    pub(crate) fn values(&self, model: &Model) -> Result<[Vec<f64>; 2], StartError> {
        let GivenPose { positions, rates, .. } = self.resolve(model)?;
        let positions =
            positions.iter().zip(&model.nominal).map(|(given, nominal)| given.unwrap_or(*nominal));
        Ok([positions.collect(), rates.into_iter().map(Option::unwrap_or_default).collect()])
    }

    pub(super) fn resolve(&self, model: &Model) -> Result<GivenPose, StartError> {
        let layout = model.layout();
        let n = layout.coordinates.len();
        let mut given =
            GivenPose { positions: vec![None; n], rates: vec![None; n], below: ContactSet::EMPTY };
        let mut following = Vec::new();
        for (k, (name, value)) in self.values.iter().enumerate() {
            if !value.is_finite() {
                return Err(StartError::NotFinite { name: name.clone(), value: *value });
            }
            if let Some(support) = name.strip_prefix("below(").and_then(|rest| rest.strip_suffix(')')) {
                given.below = given.below.with(edge_contact(layout, support, *value)?);
                continue;
            }
            let is_twice = match given.slot(layout, name)? {
                Slot::Coordinate(slot) => slot.replace(*value).is_some(),
                Slot::Dependent(follows) => {
                    following.push((k, follows));
                    self.values[..k].iter().any(|(known, _)| known == name)
                }
            };
            if is_twice {
                return Err(StartError::Twice { name: name.clone() });
            }
        }
        let mut equations: Vec<Equation> = following
            .into_iter()
            .map(|(k, (angle, is_rate))| Equation {
                angle,
                name: &self.values[k].0,
                value: self.values[k].1,
                right: self.values[k].1 - if is_rate { 0.0 } else { angle.constant(&model.parameters) },
                is_rate,
            })
            .collect();
        given.solve(layout, &mut equations)?;
        Ok(given)
    }
}

/// What is given of each coordinate and rate.
pub(super) struct GivenPose {
    pub(super) positions: Vec<Option<f64>>,
    pub(super) rates: Vec<Option<f64>>,
    /// Contacts that have gone round an end of their edges and are below these.
    pub(super) below: ContactSet,
}

/// The contact with an edge that is said to be below it.
fn edge_contact(layout: &'static Layout, support: &str, value: f64) -> Result<usize, StartError> {
    let (index, contact) = contact_of(layout, support).ok_or_else(|| unknown_support(layout, support))?;
    match contact.foot {
        Some(_) if value == 1.0 => Ok(index),
        _ => Err(StartError::NotBelow { support: support.to_owned(), value }),
    }
}

impl GivenPose {
    /// Whether a state has every value that was given, within a relative bound: what was left open
    /// follows the contacts.
    pub(super) fn is_kept(&self, context: &RunContext, state: &[f64], bound: f64) -> bool {
        let given = self.positions.iter().chain(&self.rates);
        let entries = given.zip(state).zip(context.scales.state(context.layout()));
        entries.into_iter().all(|((given, value), unit)| {
            given.is_none_or(|given| (value - given).abs() <= bound * unit.max(given.abs()))
        })
    }

    fn slot(&mut self, layout: &Layout, name: &str) -> Result<Slot<'_>, StartError> {
        let name = &*normalize_rate(name);
        let (base, list) = match name.strip_suffix('\'') {
            Some(base) => (base, &mut self.rates),
            None => (name, &mut self.positions),
        };
        let is_rate = base != name;
        let dependent = layout.dependent.iter().find(|angle| angle.name == base);
        match (layout.coordinates.iter().position(|c| c.name == base), dependent) {
            (Some(i), _) => Ok(Slot::Coordinate(&mut list[i])),
            (None, Some(angle)) => Ok(Slot::Dependent((angle, is_rate))),
            (None, None) => Err(NameError::new("coordinate", base, layout.names_of_positions()).into()),
        }
    }

    /// Solves the equations of dependent angles, Σ factor coordinate = right, one after the other
    /// as soon as all coordinates but one are known.
    fn solve(&mut self, layout: &Layout, equations: &mut Vec<Equation<'_>>) -> Result<(), StartError> {
        while !equations.is_empty() {
            let open = |equation: &Equation<'_>, given: &Self| -> Vec<Term> {
                let terms = equation.angle.coordinates.iter().copied();
                terms.filter(|term| given.list(equation.is_rate)[term.index].is_none()).collect()
            };
            let Some(next) = equations.iter().position(|equation| open(equation, self).len() <= 1) else {
                let Equation { name, is_rate, .. } = equations[0];
                let prime = if is_rate { "'" } else { "" };
                let names = open(&equations[0], self);
                let names =
                    names.iter().map(|term| format!("{}{prime}", layout.coordinates[term.index].name));
                return Err(StartError::NotDetermined {
                    name: name.to_owned(),
                    open: names.collect::<Vec<_>>().join(", "),
                });
            };
            let equation = equations.swap_remove(next);
            let known =
                |term: &Term| f64::from(term.factor) * self.list(equation.is_rate)[term.index].unwrap_or(0.0);
            let terms = equation.angle.coordinates;
            let sum: f64 = terms.iter().map(known).sum();
            let size =
                terms.iter().map(|term| known(term).abs()).fold(equation.right.abs().max(1.0), f64::max);
            match open(&equation, self)[..] {
                [Term { index, factor }] => {
                    self.list_mut(equation.is_rate)[index] = Some((equation.right - sum) / f64::from(factor));
                }
                _ if (equation.right - sum).abs() <= CLOSED * size => {}
                _ => {
                    return Err(StartError::Contradicts {
                        name: equation.name.to_owned(),
                        value: equation.value,
                        follows: equation.value - (equation.right - sum),
                    });
                }
            }
        }
        Ok(())
    }

    fn list(&self, is_rate: bool) -> &[Option<f64>] {
        if is_rate { &self.rates } else { &self.positions }
    }

    fn list_mut(&mut self, is_rate: bool) -> &mut [Option<f64>] {
        if is_rate { &mut self.rates } else { &mut self.positions }
    }
}

/// What a name of a start stands for.
enum Slot<'a> {
    Coordinate(&'a mut Option<f64>),
    /// A dependent angle, or its rate.
    Dependent((&'static DependentAngle, bool)),
}

/// What is given of a dependent angle: Σ factor coordinate = `right`, or the same of rates.
struct Equation<'a> {
    angle: &'static DependentAngle,
    name: &'a str,
    value: f64,
    right: f64,
    is_rate: bool,
}
