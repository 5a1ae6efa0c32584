//! Ends of a bar for what slides along it: with e the bar's direction, A its first point and l its
//! length, the gaps are `s = e · (P − A)` and `l − s`. Both bear the reaction.

use super::action::{Action, Scene, unit};
use super::dot;
use super::measured::Measured;
use super::row::Row;
use crate::algebra::{Rational, Series};

pub(super) fn measure(scene: &Scene, point: usize, body: usize, is_last: bool) -> Measured {
    let bar = &scene.system.bodies[body];
    let place = &scene.kinematics.points[point];
    let local = scene.system.local(body, bar.from);
    let first = scene.kinematics.compute_position(scene.system, body, &local);
    let along = unit(&scene.kinematics.directions[body]);
    let from_first = dot(&along, &[0, 1].map(|axis| &place[axis] - &first[axis]));
    let gap = if is_last { &bar.length - &from_first } else { from_first.clone() };
    let push = along.map(|part| part.scale(Rational::integer(if is_last { -1 } else { 1 })));
    let back = push.each_ref().map(|part| -part);
    let reach: Series = &local[0] + &from_first;
    let actions =
        vec![Action::at_point(scene, point, push), Action::at_place(body, place.clone(), reach, back)];
    Measured {
        row: Row::from_gap(&gap, scene.n()),
        foot: None,
        tangent: None,
        actions: [actions, Vec::new()],
    }
}
