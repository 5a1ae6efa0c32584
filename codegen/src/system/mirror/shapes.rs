//! Supports against their mirror images. A line of direction δ with its normal at δ + π/2 is reflected in x = a to
//! the direction −δ, in y = a to π − δ, so that the free side stays the normal's.

use super::Pairing;
use crate::algebra::{Angle, Series};
use crate::system::scope::Scope;
use crate::system::{OneSided, Support};

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
            scope.report.at(supports[i].span, text);
        }
    }
    images.into_iter().collect()
}

fn missing(pairing: &Pairing, support: &Support, image: &OneSided, counterpart: Option<&Support>) -> String {
    let name = &support.name;
    match counterpart {
        Some(other) if other.name == *name => {
            format!("support `{name}` is not symmetric to the mirror")
        }
        Some(other) => {
            format!(
                "supports `{name}` and `{}` are not mirror images: their places or free sides differ",
                other.name
            )
        }
        None => {
            let carried = match *image {
                OneSided::Line { point, .. } | OneSided::Circle { point, .. } => {
                    format!("point `{}`", pairing.name(point))
                }
                OneSided::Thread { ref path, .. } => {
                    let names: Vec<_> = path.iter().map(|&point| pairing.name(point)).collect();
                    format!("thread `{}`", names.join(" -> "))
                }
                OneSided::Corner { body, .. } => {
                    format!("bar `{}`", pairing.scene.bodies[body].name)
                }
            };
            format!("support `{name}` has no mirror image; declare one for {carried} too")
        }
    }
}

fn carries_the_same(a: &OneSided, b: &OneSided) -> bool {
    match (a, b) {
        (OneSided::Line { point: a, .. }, OneSided::Line { point: b, .. }) => a == b,
        (OneSided::Corner { body: a, .. }, OneSided::Corner { body: b, .. }) => a == b,
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
        OneSided::Circle { point, centre, radius, inside } => OneSided::Circle {
            point: pairing.points[*point],
            centre: pairing.line.image(centre),
            radius: radius.clone(),
            inside: *inside,
        },
        OneSided::Thread { path, length } => {
            let path = path.iter().map(|&point| pairing.points[point]).collect();
            OneSided::Thread { path, length: length.clone() }
        }
    }
}

fn same(pairing: &Pairing, a: &OneSided, b: &OneSided) -> bool {
    match (a, b) {
        (
            OneSided::Line { point: p, through: a, direction: d },
            OneSided::Line { point: q, through: b, direction: e },
        ) => p == q && d == e && pairing.same(&height(a, d), &height(b, e)),
        (OneSided::Corner { body: p, at: a, side: s }, OneSided::Corner { body: q, at: b, side: t }) => {
            p == q && s == t && pairing.same(&a[0], &b[0]) && pairing.same(&a[1], &b[1])
        }
        (
            OneSided::Circle { point: p, centre: a, radius: r, inside: i },
            OneSided::Circle { point: q, centre: b, radius: s, inside: j },
        ) => {
            let places = pairing.same(&a[0], &b[0]) && pairing.same(&a[1], &b[1]);
            p == q && i == j && places && pairing.same(r, s)
        }
        (OneSided::Thread { path: p, length: a }, OneSided::Thread { path: q, length: b }) => {
            let along = p == q || p.iter().eq(q.iter().rev());
            along && pairing.same(a, b)
        }
        _ => false,
    }
}

/// n · p with n = (−sin δ, cos δ): equal for the points of one line.
fn height([x, y]: &[Series; 2], direction: &Angle) -> Series {
    &(&Series::cos(direction) * y) - &(&Series::sin(direction) * x)
}
