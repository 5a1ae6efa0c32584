//! Supports against their mirror images. A line of direction δ with its normal at δ + π/2 is
//! reflected in x = a to the direction −δ, in y = a to π − δ, so that the free side stays the
//! normal's.

use super::{Images, Pairing, motion};
use crate::algebra::{Angle, Series};
use crate::system::scope::Scope;
use crate::system::{Centre, Edge, Formula, Friction, OneSided, Support};

/// The image of each support; `None` if one has none.
pub(super) fn supports(
    scope: &mut Scope,
    pairing: &Pairing,
    bodies: &[(usize, bool)],
    supports: &[Support],
) -> Option<Vec<usize>> {
    let expected: Vec<OneSided> = supports.iter().map(|s| reflected(pairing, bodies, &s.contact)).collect();
    let find = |a: usize| {
        let rank = (0..a).filter(|&b| same(pairing, &expected[b], &expected[a])).count();
        (0..supports.len()).filter(|&b| same(pairing, &expected[a], &supports[b].contact)).nth(rank)
    };
    let images: Vec<Option<usize>> = (0..supports.len()).map(find).collect();
    for (i, image) in expected.iter().enumerate().filter(|(i, _)| images[*i].is_none()) {
        let counterpart = supports.iter().position(|other| carries_the_same(&other.contact, image));
        if counterpart.is_none_or(|other| i <= other || images[other].is_some()) {
            let text = missing(pairing, &supports[i], image, counterpart.map(|other| &supports[other]));
            scope.report.add_message(supports[i].span, text);
        }
    }
    let images: Vec<usize> = images.into_iter().collect::<Option<_>>()?;
    for (i, &image) in images.iter().enumerate().filter(|(i, image)| i < image) {
        manners(scope, pairing, &supports[i], &supports[image]);
    }
    Some(images)
}

/// Reports in what the manners of two images differ; without restitution means with 0.
fn manners(scope: &mut Scope, pairing: &Pairing, a: &Support, b: &Support) {
    let [e, f] = [a, b].map(|support| support.restitution.clone().unwrap_or_else(Series::zero));
    let radius =
        |support: &Support| support.disc.as_ref().map_or_else(Series::zero, |disc| disc.radius.clone());
    let differences = [
        (!pairing.same(&e, &f), "restitution"),
        (a.rough != b.rough, "roughness"),
        (a.law != b.law, "the law of impact"),
        (!pairing.same(&radius(a), &radius(b)), "the radius of their discs"),
        (a.stop != b.stop, "whether they stop the run"),
        (a.armed != b.armed, "when they are there"),
        (a.breaks != b.breaks, "when they break"),
    ];
    for (_, what) in differences.into_iter().filter(|(differ, _)| *differ) {
        let text = format!("`{}` and `{}` are mirror images but differ in {what}", a.name, b.name);
        scope.report.add_message(b.span, text);
    }
}

/// Reports in what the friction of two images differs. They slip alike; their surfaces move
/// oppositely along tangents that a mirror turns.
pub(super) fn frictions(scope: &mut Scope, images: &Images, pairs: &[usize]) {
    let supports = &images.parts.supports;
    for (i, &image) in pairs.iter().enumerate().filter(|(i, image)| *i <= **image) {
        let (a, b) = (&supports[i], &supports[image]);
        let still = || Formula::Constant(Series::zero());
        let [w, back] = [a, b].map(|support| support.moving.clone().unwrap_or_else(still));
        let text = if !same_friction(images, a.friction.as_ref(), b.friction.as_ref()) {
            format!("`{}` and `{}` are mirror images but differ in friction", a.name, b.name)
        } else if motion::same(images, &motion::negated(&w), &back) {
            continue;
        } else {
            let moves = "in a mirror their surfaces move against each other";
            format!("{moves}: `{}` and `{}` have velocities that are not opposite", a.name, b.name)
        };
        scope.report.add_message(b.span, text);
    }
}

fn same_friction(images: &Images, a: Option<&Friction>, b: Option<&Friction>) -> bool {
    let (Some(a), Some(b)) = (a, b) else { return a.is_none() && b.is_none() };
    let [e, f] = [a, b].map(|friction| friction.tangential.clone().unwrap_or_else(Series::zero));
    let numbers = images.pairing.same(&a.limit, &b.limit) && images.pairing.same(&e, &f);
    numbers && a.jams == b.jams && motion::same(images, &a.kinetic, &b.kinetic)
}

fn missing(pairing: &Pairing, support: &Support, image: &OneSided, counterpart: Option<&Support>) -> String {
    let name = &support.name;
    let (kind, differs) = match image {
        OneSided::Thread { .. } => ("thread", "lengths"),
        OneSided::Circle { .. } => ("support", "circles"),
        _ => ("support", "places or free sides"),
    };
    match counterpart {
        Some(other) if other.name == *name => {
            format!("{kind} `{name}` is not symmetric to the mirror")
        }
        Some(other) => {
            format!("{kind}s `{name}` and `{}` are not mirror images: their {differs} differ", other.name)
        }
        None => {
            let carried = match *image {
                OneSided::Line { point, .. }
                | OneSided::Hinge { point, .. }
                | OneSided::Circle { point, .. }
                | OneSided::Edge { point, .. }
                | OneSided::Stop { point, .. } => {
                    format!("point `{}`", pairing.name(point))
                }
                OneSided::Thread { ref path, .. } => {
                    let names: Vec<_> = path.iter().map(|&point| pairing.name(point)).collect();
                    format!("`{}`", names.join(" -> "))
                }
                OneSided::Drive(_) | OneSided::Limit { .. } => format!("`{name}`"),
                OneSided::Corner { body, .. } => {
                    let body = &pairing.structure.bodies[body];
                    format!("{} `{}`", body.kind(), body.name)
                }
            };
            format!("{kind} `{name}` has no mirror image; declare one for {carried} too")
        }
    }
}

fn carries_the_same(a: &OneSided, b: &OneSided) -> bool {
    match (a, b) {
        (OneSided::Line { point: a, .. }, OneSided::Line { point: b, .. }) => a == b,
        (OneSided::Corner { body: a, .. }, OneSided::Corner { body: b, .. }) => a == b,
        (
            OneSided::Circle { point: a, centre: c, inside, .. },
            OneSided::Circle { point: b, centre: d, inside: other, .. },
        ) => {
            let met = |point: &usize, centre: &Centre| match centre {
                Centre::Point { point: other, .. } => Some([*point.min(other), *point.max(other)]),
                Centre::Ground(_) => None,
            };
            inside == other && (a == b || !inside && met(a, c).is_some_and(|pair| met(b, d) == Some(pair)))
        }
        (OneSided::Edge { point: a, edge, .. }, OneSided::Edge { point: b, edge: other, .. }) => {
            a == b && (edge.ends == other.ends || edge.ends.iter().rev().eq(&other.ends))
        }
        (
            OneSided::Stop { point: a, body, is_last },
            OneSided::Stop { point: b, body: other, is_last: last },
        ) => (a, body, is_last) == (b, other, last),
        (OneSided::Thread { path: a, .. }, OneSided::Thread { path: b, .. }) => {
            a == b || a.iter().rev().eq(b)
        }
        _ => false,
    }
}

fn reflected(pairing: &Pairing, bodies: &[(usize, bool)], contact: &OneSided) -> OneSided {
    match contact {
        OneSided::Line { point, through, direction } => {
            let half_turn = Angle::quarters(if pairing.line.axis == 0 { 0 } else { 2 });
            OneSided::Line {
                point: pairing.points[*point],
                through: pairing.line.image(through),
                direction: &half_turn - direction,
            }
        }
        OneSided::Corner { body, at, side } => {
            let (image, reversed) = bodies[*body];
            let side = if reversed { *side } else { -side };
            OneSided::Corner { body: image, at: pairing.line.image(at), side }
        }
        OneSided::Circle { point, centre, radius, reach, inside } => OneSided::Circle {
            point: pairing.points[*point],
            centre: match centre {
                Centre::Ground(at) => Centre::Ground(pairing.line.image(at)),
                Centre::Point { point, body } => {
                    Centre::Point { point: pairing.points[*point], body: body.map(|body| bodies[body].0) }
                }
            },
            radius: radius.clone(),
            reach: reach.clone(),
            inside: *inside,
        },
        OneSided::Edge { point, edge, side } => OneSided::Edge {
            point: pairing.points[*point],
            edge: Edge {
                body: bodies[edge.body].0,
                ends: edge.ends.map(|end| pairing.points[end]),
                ..edge.clone()
            },
            side: -side,
        },
        OneSided::Stop { point, body, is_last } => {
            let (image, reversed) = bodies[*body];
            OneSided::Stop { point: pairing.points[*point], body: image, is_last: *is_last != reversed }
        }
        // Refused where they are declared.
        OneSided::Drive(_) | OneSided::Limit { .. } => contact.clone(),
        OneSided::Hinge { point, body, from, radius } => OneSided::Hinge {
            point: pairing.points[*point],
            body: bodies[*body].0,
            from: from.map(|from| bodies[from].0),
            radius: radius.clone(),
        },
        OneSided::Thread { path, length } => {
            let path = path.iter().map(|&point| pairing.points[point]).collect();
            OneSided::Thread { path, length: length.clone() }
        }
    }
}

fn same(pairing: &Pairing, a: &OneSided, b: &OneSided) -> bool {
    let same_place = |a: &[Series; 2], b: &[Series; 2]| (0..2).all(|i| pairing.same(&a[i], &b[i]));
    let values = match (a, b) {
        (
            OneSided::Line { through: a, direction: d, .. },
            OneSided::Line { through: b, direction: e, .. },
        ) => d == e && pairing.same(&height(a, d), &height(b, e)),
        (OneSided::Corner { at: a, side: s, .. }, OneSided::Corner { at: b, side: t, .. }) => {
            s == t && same_place(a, b)
        }
        (OneSided::Circle { centre: a, reach: r, .. }, OneSided::Circle { centre: b, reach: s, .. }) => {
            let same = match (a, b) {
                (Centre::Ground(a), Centre::Ground(b)) => same_place(a, b),
                (Centre::Point { .. }, Centre::Point { .. }) => true,
                _ => false,
            };
            same && pairing.same(r, s)
        }
        (OneSided::Edge { edge: a, side: s, .. }, OneSided::Edge { edge: b, side: t, .. }) => {
            (a.ends == b.ends) == (s == t)
        }
        (OneSided::Stop { .. }, OneSided::Stop { .. }) => true,
        (OneSided::Thread { length: a, .. }, OneSided::Thread { length: b, .. }) => pairing.same(a, b),
        _ => false,
    };
    values && carries_the_same(a, b)
}

/// n · p with n = (−sin δ, cos δ): equal for the points of one line.
pub(super) fn height([x, y]: &[Series; 2], direction: &Angle) -> Series {
    &(&Series::cos(direction) * y) - &(&Series::sin(direction) * x)
}
