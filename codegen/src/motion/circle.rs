//! A point, or the disc about it, outside a circle or inside: with D from the circle's centre to
//! the point and L the distance where they touch, the gap is `± (|D|² − L²)/2L`, its unit force
//! along `u = ± D/L`, the tangent a quarter turn counter-clockwise from D. A circle of radius R
//! about a point of a body moves and turns with it: the slip is `t · Ḋ ∓ r ω − R Ω`, and both bear
//! the reaction.

use super::action::{Action, Scene};
use super::dot;
use super::expression::OpaqueTerms;
use super::feeler::{self, Feeler};
use super::measured::{Measured, TangentSlip, inverse, slips};
use super::row::{Row, bias};
use crate::algebra::{Rational, Series};
use crate::system::{Centre, Support};

/// A circle of which the gap is measured.
pub(super) struct MeasuredCircle<'a> {
    pub centre: &'a Centre,
    pub radius: &'a Series,
    pub reach: &'a Series,
    pub inside: bool,
}

pub(super) fn measure(
    scene: &Scene,
    opaque_terms: &mut OpaqueTerms,
    support: &Support,
    point: usize,
    ring: &MeasuredCircle,
) -> Measured {
    let n = scene.n();
    let feeler = Feeler::new(support, point);
    let (sign, inverse) = (if ring.inside { -1 } else { 1 }, inverse(opaque_terms, ring.reach));
    let (at, turns) = match ring.centre {
        Centre::Ground(at) => (at, None),
        Centre::Point { point, body } => {
            (&scene.kinematics.points[*point], body.map(|body| (body, -ring.radius)))
        }
    };
    let arm = [0, 1].map(|axis| &scene.kinematics.points[point][axis] - &at[axis]);
    let bulge = &dot(&arm, &arm) - &(ring.reach * ring.reach);
    let outwards = arm.each_ref().map(|part| part * &inverse);
    let tangent = [-&outwards[1], outwards[0].clone()];
    let push = outwards.map(|part| part.scale(Rational::integer(sign.into())));
    let spins: Vec<(usize, Series)> = feeler.spin(-sign).into_iter().chain(turns).collect();
    let slip = TangentSlip { spins: &spins, ..TangentSlip::new(&arm, &tangent) };
    let half = Rational::new(sign.into(), 2);
    let mut row = Row::from_gap(&(&bulge * &inverse).scale(half), n);
    // The opaque term of a length is a constant.
    row.prescribed_gap_rate = Series::zero();
    row.bias = (&bias(&bulge, n) * &inverse).scale(half);
    let pair = |force: [Series; 2]| {
        let back = force.each_ref().map(|part| -part);
        let place = feeler.compute_contact_point(scene, &push);
        let back = match *ring.centre {
            Centre::Ground(_) => None,
            Centre::Point { point, body: Some(body) } => {
                Some(feeler::apply_force(scene, (body, point), place, back))
            }
            Centre::Point { point, body: None } => Some(Action::at_point(scene, point, back)),
        };
        [feeler.bear(scene, &push, force)].into_iter().chain(back).collect()
    };
    let actions = [pair(push.clone()), pair(tangent.clone())];
    Measured { row, foot: None, tangent: slips(support).then(|| slip.row(scene)), actions }
}
