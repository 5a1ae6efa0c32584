//! Bars against their mirror images: ends, mass, length, inertia, centre of mass, points on them.

use std::collections::BTreeSet;

use super::Pairing;
use crate::algebra::Series;
use crate::system::Body;
use crate::system::scope::Scope;

/// The image of each bar and whether its ends are exchanged; `None` if one has no image.
pub(super) fn bodies(scope: &mut Scope, pairing: &Pairing) -> Option<Vec<(usize, bool)>> {
    let images: Vec<Option<(usize, bool)>> =
        (0..pairing.scene.bodies.len()).map(|body| image(scope, pairing, body)).collect();
    for (body, &image) in images.iter().enumerate() {
        if let Some((image, reversed)) = image.filter(|(image, _)| body <= *image) {
            compare(scope, pairing, body, image, reversed);
        }
    }
    images.into_iter().collect()
}

/// The bar that joins the images of its ends; of parallel bars the one with the same rank.
fn image(scope: &mut Scope, pairing: &Pairing, body: usize) -> Option<(usize, bool)> {
    let bodies = &pairing.scene.bodies;
    let bar = &bodies[body];
    let [from, to] = [bar.from, bar.to].map(|point| pairing.points[point]);
    let joining = |ends: [usize; 2]| {
        let set = BTreeSet::from(ends);
        (0..bodies.len()).filter(move |&b| BTreeSet::from([bodies[b].from, bodies[b].to]) == set)
    };
    let rank = joining([bar.from, bar.to]).position(|b| b == body)?;
    match joining([from, to]).nth(rank) {
        Some(image) => Some((image, bodies[image].from == to)),
        None => {
            let [from, to] = [from, to].map(|point| pairing.name(point));
            let text = format!("bar `{}` has no mirror image: no bar joins `{from}` and `{to}`", bar.name);
            scope.report.at(bar.span, text);
            None
        }
    }
}

fn compare(scope: &mut Scope, pairing: &Pairing, body: usize, image: usize, reversed: bool) {
    let bodies = &pairing.scene.bodies;
    let [a, b] = [&bodies[body], &bodies[image]];
    let values = |bar: &Body| [bar.mass.clone(), bar.length.clone(), bar.inertia.clone()];
    let (of_a, of_b) = (values(a), values(b));
    let mut differ: Vec<&str> = Vec::new();
    for (what, (x, y)) in ["mass", "length", "inertia"].into_iter().zip(of_a.iter().zip(&of_b)) {
        // A uniform bar's inertia follows from the other two: one difference is told once.
        let follows = what == "inertia" && !differ.is_empty();
        if !follows && !pairing.same(x, y) {
            differ.push(what);
        }
    }
    if differ.is_empty() && !same_local(pairing, &reflected(a, &a.centre, reversed), &b.centre) {
        differ.push("centre of mass");
    }
    for what in differ {
        let text = match body == image {
            true => format!("bar `{}` is its own mirror image, but its {what} is not symmetric", a.name),
            false => format!("bars `{}` and `{}` are mirror images but differ in {what}", a.name, b.name),
        };
        scope.report.at(b.span, text);
    }
    points(scope, pairing, body, image, reversed);
}

fn points(scope: &mut Scope, pairing: &Pairing, body: usize, image: usize, reversed: bool) {
    let [a, b] = [&pairing.scene.bodies[body], &pairing.scene.bodies[image]];
    for (point, local) in pairing.scene.members(body).iter().filter(|(p, _)| *p != a.from && *p != a.to) {
        let counterpart = pairing.points[*point];
        let there = pairing.scene.members(image).iter().find(|(p, _)| *p == counterpart);
        if there.is_none_or(|(_, other)| !same_local(pairing, &reflected(a, local, reversed), other)) {
            let [p, q] = [*point, counterpart].map(|point| pairing.name(point));
            let text = format!(
                "points `{p}` and `{q}` are mirror images but lie differently on bars `{}` and `{}`",
                a.name, b.name
            );
            scope.report.at(pairing.scene.points[counterpart].span, text);
        }
    }
}

/// Where on the image what is here on the bar must be.
fn reflected(bar: &Body, [along, across]: &[Series; 2], reversed: bool) -> [Series; 2] {
    match reversed {
        true => [&bar.length - along, across.clone()],
        false => [along.clone(), -across],
    }
}

fn same_local(pairing: &Pairing, a: &[Series; 2], b: &[Series; 2]) -> bool {
    pairing.same(&a[0], &b[0]) && pairing.same(&a[1], &b[1])
}
