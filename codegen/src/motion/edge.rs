//! A point on one side of an edge of a body: with e the edge's direction, n its left normal, A its first point, the gap is
//! `± n · (r − A)`, along the edge while the foot `s = e · (r − A)` lies between its ends. Both bear the reaction.

use super::action::{Action, Scene};
use super::dot;
use super::gap::{Foot, Measured, Sliding, slips};
use super::row::Row;
use crate::algebra::{Rational, Series};
use crate::kinematics::offset;
use crate::system::{Edge, Support};

pub(super) fn measure(scene: &Scene, support: &Support, point: usize, edge: &Edge, side: i8) -> Measured {
    let place = &scene.kinematics.points[point];
    let direction = &scene.kinematics.directions[edge.body];
    let local = scene.system.local(edge.body, edge.ends[0]);
    let first = scene.kinematics.place(scene.system, edge.body, &local);
    let origin = [Series::zero(), Series::zero()];
    let along = offset(&origin, direction, &edge.along);
    let across = [-&along[1], along[0].clone()];
    let span = [0, 1].map(|axis| &place[axis] - &first[axis]);
    let sign = Rational::integer(side.into());
    let row = Row::of(&dot(&across, &span).scale(sign), scene.n());
    let from_first = dot(&along, &span);
    // ė · ṡ of the slip e · ṡ, ė = δ̇ n.
    let turning = &direction.rate() * &dot(&across, &span.each_ref().map(Series::rate));
    let slip = Sliding { span: &span, tangent: &along, spins: &[], bias: turning };
    let reach = &local[0] + &(&edge.along[0] * &from_first);
    let pair = |force: [Series; 2]| {
        let back = force.each_ref().map(|part| -part);
        let back = Action::at_place(edge.body, place.clone(), reach.clone(), back);
        vec![Action::at_point(scene, point, force), back]
    };
    let actions = [pair(across.each_ref().map(|part| part.scale(sign))), pair(along.clone())];
    let tangent = slips(support).then(|| slip.row(scene));
    let from_last = &edge.length - &from_first;
    Measured { row, foot: Some(Foot { from_first, from_last }), tangent, actions }
}
