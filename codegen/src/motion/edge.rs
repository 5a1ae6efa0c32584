//! A point, or the disc of radius r about it, on one side of an edge of a body: with e the edge's
//! direction, n its left normal, A its first point, the gap is `± n · (P − A) − r`, along the edge
//! while the foot `s = e · (P − A)` lies between its ends. Both bear the reaction; the slip is
//! `e · (Ṗ − Ȧ) ± r ω`.

use super::action::Scene;
use super::dot;
use super::feeler::{self, Feeler};
use super::measured::{Foot, Measured, TangentSlip, slips};
use super::row::Row;
use crate::algebra::{Rational, Series};
use crate::kinematics::offset;
use crate::system::{Edge, Support};

pub(super) fn measure(scene: &Scene, support: &Support, point: usize, edge: &Edge, side: i8) -> Measured {
    let feeler = Feeler::new(support, point);
    let place = &scene.kinematics.points[point];
    let direction = &scene.kinematics.directions[edge.body];
    let local = scene.system.local(edge.body, edge.ends[0]);
    let first = scene.kinematics.compute_position(scene.system, edge.body, &local);
    let along = offset(&[Series::zero(), Series::zero()], direction, &edge.along);
    let across = [-&along[1], along[0].clone()];
    let span = [0, 1].map(|axis| &place[axis] - &first[axis]);
    let sign = Rational::integer(side.into());
    let row = Row::from_gap(&feeler.less_radius(dot(&across, &span).scale(sign)), scene.n());
    let from_first = dot(&along, &span);
    // ė · ṡ of the slip e · ṡ, ė = δ̇ n.
    let turning = &direction.rate() * &dot(&across, &span.each_ref().map(Series::rate));
    let spins: Vec<(usize, Series)> = feeler.spin(side).into_iter().collect();
    let slip = TangentSlip { span: &span, tangent: &along, spins: &spins, bias: turning };
    let push = across.each_ref().map(|part| part.scale(sign));
    let pair = |force: [Series; 2]| {
        let back = force.each_ref().map(|part| -part);
        let touched = feeler.compute_contact_point(scene, &push);
        vec![
            feeler.bear(scene, &push, force),
            feeler::apply_force(scene, (edge.body, edge.ends[0]), touched, back),
        ]
    };
    let actions = [pair(push.clone()), pair(along.clone())];
    let tangent = slips(support).then(|| slip.row(scene));
    let from_last = &edge.length - &from_first;
    Measured { row, foot: Some(Foot { from_first, from_last }), tangent, actions }
}
