//! Checks across declarations.

use super::bodies::Scene;
use super::scope::Scope;
use super::{CoordinateKind, Declared, Direction, Equal, OneSided, Support};

/// Reports bars that nothing ties to anything, where there is something to be tied to.
pub(super) fn untied(
    scope: &mut Scope,
    scene: &Scene,
    supports: &[Support],
    coordinates: &[Declared],
    equal: &[Equal],
) {
    if scene.bodies.len() < 2 || !scope.sound {
        return;
    }
    for (i, body) in scene.bodies.iter().enumerate() {
        let held =
            |p: usize| scene.points[p].on.len() > 1 || scene.pins.iter().any(|pin| pin.point == p);
        let shared = scene.members(i).iter().any(|(point, _)| held(*point));
        let supported = supports.iter().any(|support| carries(scene, support, i));
        let constrained = equal
            .iter()
            .any(|e| [e.left, e.right].contains(&Direction::Body(i)));
        let measured = coordinates.iter().any(|c| measures(scene, &c.kind, i));
        if !(shared || supported || constrained || measured) {
            let text = format!(
                "nothing ties bar `{}` to anything; let it share a point with another bar, or pin or support it",
                body.name
            );
            scope.report.at(body.span, text);
        }
    }
}

fn carries(scene: &Scene, support: &Support, body: usize) -> bool {
    match &support.contact {
        OneSided::Line { point, .. } => is_on(scene, *point, body),
        OneSided::Corner { body: carried, .. } => *carried == body,
    }
}

fn measures(scene: &Scene, kind: &CoordinateKind, body: usize) -> bool {
    match kind {
        CoordinateKind::Angle { body: measured, .. } => *measured == body,
        CoordinateKind::Position { point, .. } => is_on(scene, *point, body),
    }
}

fn is_on(scene: &Scene, point: usize, body: usize) -> bool {
    scene.points[point].on.iter().any(|(b, _)| *b == body)
}
