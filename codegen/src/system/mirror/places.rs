//! Places, pins, point masses and gravity against their mirror images.

use super::{Pairing, agree, sampled};
use crate::algebra::Series;
use crate::system::scope::Scope;

/// Reports what differs from its image.
pub(super) fn check(scope: &mut Scope, pairing: &Pairing) {
    for (p, q) in pairing.pairs() {
        let span = pairing.structure.points[q].span;
        let [a, b] = [p, q].map(|point| pairing.name(point));
        for what in differences(pairing, p, q) {
            let text = match p == q {
                true => format!("point `{a}` is its own mirror image, but {what}"),
                false => format!("points `{a}` and `{b}` are mirror images, but {what}"),
            };
            scope.report.add_message(span, text);
        }
    }
    gravity(scope, pairing);
}

fn differences(pairing: &Pairing, p: usize, q: usize) -> Vec<String> {
    let image = pairing.line.image(&pairing.figure.positions[p]);
    let [expected, placed] =
        [&image, &pairing.figure.positions[q]].map(|place| sampled(&pairing.samples, place));
    let pinned = |point: usize| pairing.structure.fixed(point).is_some();
    let text =
        |p: usize, q: usize| format!("`{}` is pinned and `{}` is not", pairing.name(p), pairing.name(q));
    let [mass_p, mass_q] = [p, q].map(|point| mass(pairing, point));
    let mut found = Vec::new();
    if !agree(&expected, &placed) {
        found.push(if p == q {
            "does not lie on the mirror".into()
        } else {
            "the figure has them elsewhere".into()
        });
    }
    match (pinned(p), pinned(q)) {
        (true, false) => found.push(text(p, q)),
        (false, true) => found.push(text(q, p)),
        _ => {}
    }
    if !pairing.same(&mass_p, &mass_q) {
        found.push("carry different point masses".into());
    }
    found
}

fn mass(pairing: &Pairing, point: usize) -> Series {
    let here = pairing.structure.particles.iter().filter(|particle| particle.point == point);
    here.map(|particle| particle.mass.clone()).sum()
}

fn gravity(scope: &mut Scope, pairing: &Pairing) {
    let Some(gravity) = &pairing.structure.gravity else {
        return;
    };
    if !pairing.same(&gravity[pairing.line.axis], &Series::zero()) {
        let span = scope.description.gravity.as_ref().map_or(pairing.line.span, |gravity| gravity.span);
        scope.report.add_message(
            span,
            "gravity must pull along the mirror; remove the mirror or this component of gravity",
        );
    }
}
