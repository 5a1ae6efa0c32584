//! Bodies against their mirror images: points, mass, length, inertia, centre of mass. The frame of
//! an image is the reflection of the body's, or that turned by half a turn, as for a bar that is
//! named from its other end.

use std::collections::BTreeSet;

use super::Pairing;
use crate::algebra::Series;
use crate::system::Body;
use crate::system::scope::Scope;

/// The image of each body and whether its frame is turned; `None` if one has no image.
pub(super) fn bodies(scope: &mut Scope, pairing: &Pairing) -> Option<Vec<(usize, bool)>> {
    let images: Vec<Option<(usize, bool)>> =
        (0..pairing.structure.bodies.len()).map(|body| image(scope, pairing, body)).collect();
    for (body, &image) in images.iter().enumerate() {
        if let Some((image, turned)) = image.filter(|(image, _)| body <= *image) {
            compare(scope, pairing, body, image, turned);
        }
    }
    images.into_iter().collect()
}

/// The body through the images of its points; of parallel bars the one with the same rank.
fn image(scope: &mut Scope, pairing: &Pairing, body: usize) -> Option<(usize, bool)> {
    let bodies = &pairing.structure.bodies;
    let original = &bodies[body];
    let images: Vec<usize> = original.outline.iter().map(|&point| pairing.points[point]).collect();
    let through = |points: &[usize]| {
        let set: BTreeSet<usize> = points.iter().copied().collect();
        (0..bodies.len()).filter(move |&b| bodies[b].outline.iter().copied().collect::<BTreeSet<_>>() == set)
    };
    let rank = through(&original.outline).position(|b| b == body)?;
    let Some(image) = through(&images).nth(rank) else {
        let names: Vec<String> = images.iter().map(|&point| format!("`{}`", pairing.name(point))).collect();
        let text = match &names[..] {
            [from, to] => {
                format!("bar `{}` has no mirror image: no bar joins {from} and {to}", original.name)
            }
            _ => format!(
                "body `{}` has no mirror image: no body has the points {}",
                original.name,
                names.join(", ")
            ),
        };
        scope.report.add_message(original.span, text);
        return None;
    };
    let turned = turned(pairing, body, image);
    if turned.is_none() {
        let text = format!(
            "bodies `{}` and `{}` have the points of mirror images, but their frames are none: one must be the \
             other's reflection along or across its first axis",
            original.name, bodies[image].name
        );
        scope.report.add_message(original.span, text);
    }
    turned.map(|turned| (image, turned))
}

/// Whether the frame of the image is turned; of bars, whether their ends are exchanged.
fn turned(pairing: &Pairing, body: usize, image: usize) -> Option<bool> {
    let bodies = &pairing.structure.bodies;
    let [from, to] = [bodies[body].from, bodies[body].to];
    if pairing.structure.is_bar(body) && pairing.structure.is_bar(image) {
        return Some(bodies[image].from == pairing.points[to]);
    }
    let (a, b) = (local(pairing, body, from)?, local(pairing, body, to)?);
    let (c, d) = (local(pairing, image, pairing.points[from])?, local(pairing, image, pairing.points[to])?);
    let [x, y] = [&b[0] - &a[0], &b[1] - &a[1]];
    let [u, v] = [&d[0] - &c[0], &d[1] - &c[1]];
    let fits = |turned: &bool| {
        let expected = if *turned { [-&x, y.clone()] } else { [x.clone(), -&y] };
        same_local(pairing, &expected, &[u.clone(), v.clone()])
    };
    [false, true].into_iter().find(fits)
}

/// Where a point is on a body.
fn local<'a>(pairing: &'a Pairing, body: usize, point: usize) -> Option<&'a [Series; 2]> {
    pairing.structure.members(body).iter().find(|(p, _)| *p == point).map(|(_, local)| local)
}

fn compare(scope: &mut Scope, pairing: &Pairing, body: usize, image: usize, turned: bool) {
    let bodies = &pairing.structure.bodies;
    let [a, b] = [&bodies[body], &bodies[image]];
    let bar = pairing.structure.is_bar(body) && pairing.structure.is_bar(image);
    let (one, two) = if bar { ("bar", "bars") } else { ("body", "bodies") };
    let reflected = |place: &[Series; 2]| reflected(pairing, [body, image], turned, place);
    let values = |bar: &Body| [bar.mass.clone(), bar.length.clone(), bar.inertia.clone()];
    let (of_a, of_b) = (values(a), values(b));
    let mut differ: Vec<&str> = Vec::new();
    for (what, (x, y)) in ["mass", "length", "inertia"].into_iter().zip(of_a.iter().zip(&of_b)) {
        // A uniform bar's inertia follows from the other two: one difference is told once. Of other
        // bodies the length is no more than the distance of two of the points compared below.
        let follows = what == "inertia" && !differ.is_empty() || what == "length" && !bar;
        if !follows && !pairing.same(x, y) {
            differ.push(what);
        }
    }
    if differ.is_empty()
        && !reflected(&a.centre).is_some_and(|centre| same_local(pairing, &centre, &b.centre))
    {
        differ.push("centre of mass");
    }
    for what in differ {
        let text = match body == image {
            true => format!("{one} `{}` is its own mirror image, but its {what} is not symmetric", a.name),
            false => format!("{two} `{}` and `{}` are mirror images but differ in {what}", a.name, b.name),
        };
        scope.report.add_message(b.span, text);
    }
    for (point, place) in pairing.structure.members(body).iter().filter(|(p, _)| *p != a.from && *p != a.to) {
        let counterpart = pairing.points[*point];
        let there = local(pairing, image, counterpart).zip(reflected(place));
        if there.is_none_or(|(there, expected)| !same_local(pairing, &expected, there)) {
            let [p, q] = [*point, counterpart].map(|point| pairing.name(point));
            let text = format!(
                "points `{p}` and `{q}` are mirror images but lie differently on {two} `{}` and `{}`",
                a.name, b.name
            );
            scope.report.add_message(pairing.structure.points[counterpart].span, text);
        }
    }
}

/// Where on the image what is here on the body must be: by its distance from the body's first
/// point.
fn reflected(
    pairing: &Pairing,
    [body, image]: [usize; 2],
    turned: bool,
    [x, y]: &[Series; 2],
) -> Option<[Series; 2]> {
    let first = pairing.structure.bodies[body].from;
    let (a, c) = (local(pairing, body, first)?, local(pairing, image, pairing.points[first])?);
    let [x, y] = [x - &a[0], y - &a[1]];
    Some(if turned { [&c[0] - &x, &c[1] + &y] } else { [&c[0] + &x, &c[1] - &y] })
}

fn same_local(pairing: &Pairing, a: &[Series; 2], b: &[Series; 2]) -> bool {
    pairing.same(&a[0], &b[0]) && pairing.same(&a[1], &b[1])
}
