//! Conditions on positions and rates alone.

use crate::{Number, arithmetic};
use liftoff::__private::expression::{Environment, Function, Operator, Variable};
use liftoff::Condition;
use liftoff_core::system::ModelOn;

/// The left side of a condition less its right one at a full state; `None` where it reads time,
/// forces, accelerations or energies.
pub fn difference<S: Number>(condition: &Condition, model: &ModelOn<S>, state: &[S]) -> Option<S> {
    let [left, right] = condition.values(&Kinematic { model, state }).ok()?;
    Some(left - right)
}

/// A full state, and what it tells without a phase.
pub(crate) struct Kinematic<'a, S: Number> {
    pub(crate) model: &'a ModelOn<S>,
    pub(crate) state: &'a [S],
}

impl<S: Number> Kinematic<'_, S> {
    /// Parameters, coordinates and their rates, positions of points, gaps.
    pub(crate) fn value(&self, variable: Variable) -> Option<S> {
        let layout = self.model.system.layout();
        Some(match variable {
            Variable::Parameter(i) => self.model.parameters[i],
            Variable::Coordinate { index, order: order @ (0 | 1) } => {
                self.state[index + order * layout.coordinates.len()]
            }
            Variable::Point { index, axis, order: 0 } => {
                let mut points = vec![S::ZERO; 2 * layout.points.len()];
                self.model.system.points(self.state, &mut points);
                points[2 * index + axis]
            }
            Variable::Gap(contact) => self.gap(contact),
            _ => return None,
        })
    }

    pub(crate) fn gap(&self, contact: usize) -> S {
        let mut gaps = vec![S::ZERO; contact + 1];
        self.model.system.gaps(self.state, &mut gaps);
        gaps[contact]
    }
}

/// A condition does not depend on positions and rates alone.
pub(crate) struct Others;

impl<S: Number> Environment for Kinematic<'_, S> {
    type Value = S;
    type Error = Others;

    fn number(&self, x: f64) -> S {
        arithmetic::number(x)
    }

    fn get_value(&self, variable: Variable) -> Result<S, Others> {
        self.value(variable).ok_or(Others)
    }

    fn apply(&self, function: Function, x: S) -> Result<S, Others> {
        Ok(arithmetic::apply(function, x))
    }

    fn join(&self, operator: Operator, a: S, b: S) -> Result<S, Others> {
        arithmetic::join(operator, a, b).ok_or(Others)
    }
}
