//! Values of expressions at one time. Velocities and accelerations of points are Taylor
//! coefficients of their positions along `q + u t + a t²/2`.

use core::convert::Infallible;

use super::environment::{self, Environment, Variable};
use super::tree::{Expression, Function, Operator};
use crate::context::{RunContext, slips};
use crate::integration::phase_point::PhasePoint;
use crate::system::{TIME_ORDERS, TimeSeries};

pub(super) fn evaluate(expression: &Expression, context: &RunContext, at: &PhasePoint) -> f64 {
    let Ok(value) = environment::evaluate(expression, &MotionEnvironment { context, at });
    value
}

impl Variable {
    /// Its value at a point of a motion.
    pub(crate) fn value(self, context: &RunContext, at: &PhasePoint) -> f64 {
        let Ok(value) = (MotionEnvironment { context, at }).get_value(self);
        value
    }
}

/// A model at one time of its motion.
struct MotionEnvironment<'a> {
    context: &'a RunContext,
    at: &'a PhasePoint,
}

impl Environment for MotionEnvironment<'_> {
    type Value = f64;
    type Error = Infallible;

    fn number(&self, x: f64) -> f64 {
        x
    }

    fn get_value(&self, variable: Variable) -> Result<f64, Infallible> {
        let Self { context, at } = *self;
        let system = context.system();
        Ok(match variable {
            Variable::Parameter(i) => context.model.parameters[i],
            Variable::Time => at.t(),
            Variable::Coordinate { index, order: 2 } => at.accelerations()[index],
            Variable::Coordinate { index, order } => {
                at.state()[index + order * context.layout().coordinates.len()]
            }
            Variable::Point { index, axis, order } => self.point(2 * index + axis, order),
            Variable::Reaction(contact) => at.reactions()[contact],
            Variable::Friction(contact) => self.friction(contact),
            Variable::Slip(entry) => slips(context.system(), at.state())[entry].velocity,
            Variable::Coefficient(entry) => self.coefficient(entry),
            Variable::Quantity(entry) => {
                let of_state = context.layout().quantities[entry].kind.is_of_state();
                let (accelerations, multipliers): (&[f64], &[f64]) =
                    if of_state { (&[], &[]) } else { (at.accelerations(), at.multipliers()) };
                system.quantity(entry, at.state(), accelerations, multipliers)
            }
            Variable::Gap(contact) => {
                let mut gaps = vec![0.0; contact + 1];
                system.gaps(at.state(), &mut gaps);
                gaps[contact]
            }
            Variable::Kinetic => at.energy().kinetic,
            Variable::Potential => at.energy().potential,
            Variable::Dissipated => at.dissipated(),
        })
    }

    fn apply(&self, function: Function, x: f64) -> Result<f64, Infallible> {
        Ok(function.apply(x))
    }

    fn join(&self, operator: Operator, a: f64, b: f64) -> Result<f64, Infallible> {
        Ok(operator.apply(a, b))
    }
}

impl MotionEnvironment<'_> {
    /// The friction force of the phase's own equations where it has one, else the sum over the
    /// tangential rows.
    fn friction(&self, contact: usize) -> f64 {
        let layout = self.context.layout();
        if let Some(entry) = layout.contacts[contact].friction {
            return self.at.reactions()[layout.contacts.len() + entry];
        }
        let first = layout.contacts.len() + layout.joints.len();
        let rows = layout.tangents.iter().zip(&self.at.multipliers()[first..]);
        rows.filter(|(of, _)| **of == contact).map(|(_, multiplier)| multiplier).sum()
    }

    /// μₛ while the contact sticks, else μ.
    fn coefficient(&self, entry: usize) -> f64 {
        let slip = slips(self.context.system(), self.at.state())[entry];
        let contact = self.context.layout().frictions[entry].contact;
        if self.at.sticks(contact) { slip.limit } else { slip.kinetic }
    }

    fn point(&self, entry: usize, order: usize) -> f64 {
        let Self { context, at } = *self;
        let layout = context.layout();
        if order == 0 {
            let mut points = vec![0.0; 2 * layout.points.len()];
            context.system().points(at.state(), &mut points);
            return points[entry];
        }
        let (n, state) = (layout.coordinates.len(), at.state());
        let acceleration = |i: usize| if order > 1 { at.accelerations()[i] } else { 0.0 };
        let along = |i: usize| {
            let mut series = [0.0; TIME_ORDERS];
            series[0] = state[i];
            match i / n {
                0 => (series[1], series[2]) = (state[n + i], 0.5 * acceleration(i)),
                1 => series[1] = acceleration(i - n),
                _ => series[1] = layout.slope(i) as f64,
            }
            TimeSeries::new(series)
        };
        let along: Vec<TimeSeries> = (0..state.len()).map(along).collect();
        let mut points = vec![TimeSeries::new([0.0; TIME_ORDERS]); 2 * layout.points.len()];
        context.model.series.points(&along, &mut points);
        points[entry].derivative(order)
    }
}
