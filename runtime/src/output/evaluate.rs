//! Values of expressions at one time. Velocities and accelerations of points are Taylor coefficients of their
//! positions along `q + u t + a t²/2`.

use super::expression::Expression;
use crate::contact::ORDERS;
use crate::model::{Array, BarSystem, KernelView};
use crate::moment::{Moment, Scene};
use crate::scalar::Jet;

pub(super) fn evaluate<M: BarSystem>(
    expression: &Expression,
    scene: &Scene<M>,
    moment: &dyn Moment<M>,
) -> f64 {
    let of = |x: &Expression| evaluate(x, scene, moment);
    match expression {
        Expression::Number(x) => *x,
        Expression::Parameter(i) => scene.parameters[*i],
        Expression::Time => moment.t(),
        Expression::Coordinate { index, order: 2 } => moment.accelerations().as_ref()[*index],
        Expression::Coordinate { index, order } => {
            moment.state().as_ref()[index + order * M::LAYOUT.coordinates.len()]
        }
        Expression::Point { index, axis, order } => point(scene, moment, 2 * index + axis, *order),
        Expression::Reaction { contact, share } => moment.reactions().as_ref()[*contact] / share,
        Expression::Friction { contact, share } => friction(moment, *contact) / share,
        Expression::Quantity { entry, of_state: true } => {
            let unknown = (M::Accelerations::from_fn(|_| f64::NAN), M::Multipliers::from_fn(|_| f64::NAN));
            M::quantity(&scene.constants, *entry, moment.state(), &unknown.0, &unknown.1)
        }
        Expression::Quantity { entry, of_state: false } => {
            let (accelerations, multipliers) = (moment.accelerations(), moment.multipliers());
            M::quantity(&scene.constants, *entry, moment.state(), &accelerations, &multipliers)
        }
        Expression::Gap(contact) => M::kernel(&scene.constants, moment.state()).gap()[*contact],
        Expression::Kinetic => moment.energy().kinetic,
        Expression::Potential => moment.energy().potential,
        Expression::Energy => moment.energy().kinetic + moment.energy().potential,
        Expression::Apply(function, x) => function.of(of(x)),
        Expression::Join(operator, a, b) => operator.of(of(a), of(b)),
    }
}

/// The sum over the tangential rows of a contact.
fn friction<M: BarSystem>(moment: &dyn Moment<M>, contact: usize) -> f64 {
    let first = M::LAYOUT.contacts.len() + M::LAYOUT.joints.len();
    let multipliers = moment.multipliers();
    let rows = M::LAYOUT.tangents.iter().zip(&multipliers.as_ref()[first..]);
    rows.filter(|(of, _)| **of == contact).map(|(_, multiplier)| multiplier).sum()
}

fn point<M: BarSystem>(scene: &Scene<M>, moment: &dyn Moment<M>, entry: usize, order: usize) -> f64 {
    if order == 0 {
        return M::points(&scene.constants, moment.state()).as_ref()[entry];
    }
    let n = M::LAYOUT.coordinates.len();
    let state = moment.state().as_ref();
    let accelerations = if order > 1 { moment.accelerations() } else { M::Accelerations::from_fn(|_| 0.0) };
    let accelerations = accelerations.as_ref();
    let along = M::State::from_fn(|i| {
        let mut series = [0.0; ORDERS];
        series[0] = state[i];
        // Coordinates, rates, and the time, whose rate is one.
        match i / n {
            0 => (series[1], series[2]) = (state[n + i], 0.5 * accelerations[i]),
            1 => series[1] = accelerations[i - n],
            _ => series[1] = 1.0,
        }
        Jet::new(series)
    });
    M::points(&scene.series, &along).as_ref()[entry].derivative(order)
}
