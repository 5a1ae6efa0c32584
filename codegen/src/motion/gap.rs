//! Gaps of the one-sided constraints, their slip, and the forces that unit multipliers stand for.
//!
//! | constraint | gap g |
//! |---|---|
//! | a point r over a line through p with normal n | `n · (r − p)` |
//! | a bar (first point r, left normal n) over a corner c | `± n · (r − c)`, its foot at `s = e · (c − r)`, on the bar while `0 ≤ s ≤ l` |
//! | a point over an edge of a body (first point A, left normal n) | `± n · (r − A)`, its foot at `s = e · (r − A)`, on the edge while `0 ≤ s ≤ l` |
//! | a point outside a circle, in a bowl of radius R about c | `± (\|r − c\|² − L²) / 2L`, L = R |
//! | what slides along a bar (first point A) of length l, before its ends | `e · (r − A)`, `l − e · (r − A)` |
//! | a thread of length ℓ with one moving segment d, the others fixed and k long | `((ℓ − k)² − d²) / 2(ℓ − k)` |
//! | a thread with two moving segments | `ℓ − k − d₁ − d₂` |
//! | an angle or a position q before a bound a | `± (q − a)` |
//! | a distance d before a bound a | `± (d² − a²)/2a` |
//! | a distance d that is driven while a condition holds | `(d² − f(t)²)/2f(t)` |
//! | what else a drive prescribes while its condition holds | that of its joint |
//!
//! Of a disc of radius ϱ about the point the gap over lines is less by ϱ, and L = R ± ϱ.
//!
//! On the constraint the gradient of each is the unit force. The slip of a support that is rough or
//! has friction is the velocity of the point (of the bar at the corner) along the tangent, relative
//! to the surface; the tangent is the line's (the bar's) direction, on a circle a quarter turn
//! counter-clockwise from the radius.

use super::action::{Action, Scene, normal, unit};
use super::circle::{self, MeasuredCircle};
use super::expression::{Expression, OpaqueTerms};
use super::feeler::Feeler;
use super::measured::{Foot, Measured, TangentSlip, slips};
use super::row::{Row, bias};
use super::{dot, driving, edge, hinge, limit, stop, thread};
use crate::algebra::{Rational, Series, Symbol};
use crate::kinematics::height;
use crate::system::{OneSided, Support};

pub(super) fn measure(scene: &Scene, opaque_terms: &mut OpaqueTerms, support: &Support) -> Measured {
    let mut measured = at_rest(scene, opaque_terms, support);
    // A guide goes on beyond the ends of its bar.
    measured.foot = measured.foot.filter(|_| !support.two_sided);
    if let (Some(slip), Some(velocity)) = (&mut measured.tangent, &support.moving) {
        let velocity = Expression::from_formula(velocity, scene.system, scene.kinematics);
        slip.move_with(&opaque_terms.velocity(&format!("w_{}", support.name), velocity));
    }
    measured
}

/// With a surface that does not move along itself.
fn at_rest(scene: &Scene, opaque_terms: &mut OpaqueTerms, support: &Support) -> Measured {
    let n = scene.n();
    let points = &scene.kinematics.points;
    match &support.contact {
        OneSided::Line { point, through, direction } => {
            let feeler = Feeler::new(support, *point);
            let row = Row::from_gap(&feeler.less_radius(height(&points[*point], through, direction)), n);
            let (tangent, across) = (unit(direction), normal(direction));
            let spins: Vec<(usize, Series)> = feeler.spin(1).into_iter().collect();
            let slip =
                TangentSlip { spins: &spins, ..TangentSlip::new(&points[*point], &tangent) }.row(scene);
            let force = |force: [Series; 2]| vec![feeler.bear(scene, &across, force)];
            let actions = [force(across.clone()), force(tangent)];
            Measured { row, foot: None, tangent: slips(support).then_some(slip), actions }
        }
        OneSided::Corner { body, at, side } => corner(scene, *body, at, *side, slips(support)),
        OneSided::Edge { point, edge: side, side: sign } => {
            edge::measure(scene, support, *point, side, *sign)
        }
        OneSided::Circle { point, centre, radius, reach, inside } => {
            let ring = MeasuredCircle { centre, radius, reach, inside: *inside };
            circle::measure(scene, opaque_terms, support, *point, &ring)
        }
        OneSided::Stop { point, body, is_last } => stop::measure(scene, *point, *body, *is_last),
        OneSided::Hinge { body, from, radius, .. } => hinge::measure(scene, *body, *from, radius),
        OneSided::Thread { path, length } => {
            thread::measure(scene, opaque_terms, &support.name, path, length)
        }
        OneSided::Limit { driven, bound, is_upper, .. } => {
            limit::measure(scene, opaque_terms, driven, bound, *is_upper)
        }
        OneSided::Drive(i) => driving::measure(scene, opaque_terms, *i),
    }
}

fn corner(scene: &Scene, body: usize, at: &[Series; 2], side: i8, slips: bool) -> Measured {
    let n = scene.n();
    let direction = &scene.kinematics.directions[body];
    let bar = &scene.system.bodies[body];
    let local = scene.system.local(body, bar.from);
    let first = &scene.kinematics.compute_position(scene.system, body, &local);
    let side = Rational::integer(side.into());
    let row = Row::from_gap(&height(first, at, direction).scale(side), n);
    let (along, across) = (unit(direction), normal(direction));
    let reach = [0, 1].map(|axis| &at[axis] - &first[axis]);
    let from_first = dot(&along, &reach);
    let from_last = &bar.length - &from_first;
    // The bar's point at the corner slips as the first point does along the bar: their distance is
    // across its turn.
    let velocity = first.each_ref().map(Series::rate);
    let turning = &direction.rate() * &dot(&across, &velocity);
    let slip = Row::tangential(
        (0..n).map(|i| dot(&along, &first.each_ref().map(|x| x.derivative(Symbol::coordinate(i))))).collect(),
        &dot(&along, &first.each_ref().map(|x| bias(x, n))) + &turning,
    );
    let push = across.map(|part| part.scale(side));
    let force = |direction| vec![Action::at_place(body, at.clone(), from_first.clone(), direction)];
    let actions = [force(push), force(along)];
    Measured { row, foot: Some(Foot { from_first, from_last }), tangent: slips.then_some(slip), actions }
}
