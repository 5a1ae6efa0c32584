//! Forces of drives: of those that hold throughout, joints, and of those on a condition, contacts.

use super::action::{Action, Scene, unit};
use super::expression::{Expression, OpaqueTerms};
use super::measured::Measured;
use super::row::Row;
use super::{Vector, dot};
use crate::algebra::{Rational, Series};
use crate::system::{CoordinateKind, Driven, Reading, Reference};

/// The row of a drive on a condition. Its multiplier is the force.
pub(super) fn measure(scene: &Scene, opaque_terms: &mut OpaqueTerms, i: usize) -> Measured {
    let drive = &scene.system.drives[i];
    let prescribed = opaque_terms.prescribed(i);
    let (gap, actions) = match &drive.driven {
        Driven::Distance { ends, .. } => {
            let one = Expression::series(Series::one());
            let value = Expression::from_formula(&drive.value, scene.system, scene.kinematics);
            let inverse = opaque_terms.motion(format!("1/f{}", i + 1), one.over(value));
            let square = scene.kinematics.squared_distance(*ends);
            let gap = (&(&square * &inverse) - &prescribed).scale(Rational::HALF);
            (gap, between(scene, *ends, &inverse))
        }
        driven => {
            let gap = &scene.kinematics.driven(scene.system, driven).0 - &prescribed;
            (gap, actions(scene, driven, &Series::one()))
        }
    };
    Measured {
        row: Row::from_gap(&gap, scene.n()),
        foot: None,
        tangent: None,
        actions: [actions, Vec::new()],
    }
}

/// The forces of a drive with the multiplier `lambda`.
pub(super) fn actions(scene: &Scene, driven: &Driven, lambda: &Series) -> Vec<Action> {
    match *driven {
        Driven::Reading(reading) => of_reading(scene, reading, lambda),
        Driven::Distance { ends, ref inverse } => between(scene, ends, &(inverse * lambda)),
        Driven::Turn { from, body } => vec![
            Action::couple(scene, from, Some(body), -lambda),
            Action::couple(scene, body, Some(from), lambda.clone()),
        ],
        Driven::Along { point, body } => {
            let force = unit(&scene.kinematics.directions[body]).map(|part| &part * lambda);
            against(scene, point, body, force).into()
        }
    }
}

/// Forces that push two points apart, by this much of what is between them.
pub(super) fn between(scene: &Scene, [a, b]: [usize; 2], push: &Series) -> Vec<Action> {
    let points = &scene.kinematics.points;
    let force = [0, 1].map(|axis| &(&points[b][axis] - &points[a][axis]) * push);
    let back = force.each_ref().map(|part| -part);
    [(a, back), (b, force)].map(|(point, force)| Action::at_point(scene, point, force)).into()
}

/// A force at a point, and the opposite on the bar that it moves along.
pub(super) fn against(scene: &Scene, point: usize, body: usize, force: Vector) -> [Action; 2] {
    let place = &scene.kinematics.points[point];
    let direction = &scene.kinematics.directions[body];
    let local = scene.system.local(body, scene.system.bodies[body].from);
    let first = &scene.kinematics.compute_position(scene.system, body, &local);
    let reach = [0, 1].map(|axis| &place[axis] - &first[axis]);
    let local = dot(&unit(direction), &reach);
    let back = force.each_ref().map(|part| -part);
    [Action::at_point(scene, point, force), Action::at_place(body, place.clone(), local, back)]
}

fn of_reading(scene: &Scene, reading: Reading, lambda: &Series) -> Vec<Action> {
    let push = |point: usize, axis: usize, force: Series| {
        let mut vector = [Series::zero(), Series::zero()];
        vector[axis] = force;
        vec![Action::at_point(scene, point, vector)]
    };
    match reading {
        Reading::Position(point, axis) => push(point, axis, lambda.clone()),
        Reading::Direction(body) => vec![Action::couple(scene, body, None, lambda.clone())],
        Reading::Coordinate(i) => match &scene.system.coordinates[i].kind {
            CoordinateKind::Position { point, axis, sign } => {
                push(*point, *axis, lambda.scale(Rational::integer((*sign).into())))
            }
            CoordinateKind::Angle { body, reference, sign } => {
                let couple = lambda.scale(Rational::integer((*sign).into()));
                let from = match reference {
                    Reference::Ground(_) => None,
                    Reference::Body(other) => Some(*other),
                };
                let back = from.map(|from| Action::couple(scene, from, Some(*body), -&couple));
                back.into_iter().chain([Action::couple(scene, *body, from, couple)]).collect()
            }
        },
    }
}
