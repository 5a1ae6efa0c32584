//! Checks across declarations.

use syn::Ident;

use super::bodies::Scene;
use super::scope::Scope;
use crate::syntax::{Description, Member, Origin, Reading};

/// Reports bars that nothing ties to anything, where there is something to be tied to.
pub(super) fn untied(scope: &mut Scope, scene: &Scene) {
    if scene.bodies.len() < 2 || !scope.joined {
        return;
    }
    let named = named(scope.description);
    for (i, body) in scene.bodies.iter().enumerate() {
        let points = scene.members(i).iter().map(|(point, _)| *point);
        let held = |p: usize| {
            scene.points[p].on.len() > 1
                || scene.pins.iter().any(|pin| pin.point == p)
                || named.iter().any(|name| **name == scene.points[p].name)
        };
        if !points.into_iter().any(held) && !named.iter().any(|name| **name == body.name) {
            let text = format!(
                "nothing ties bar `{}` to anything; let it share a point with another bar, or pin or support it",
                body.name
            );
            scope.report.at(body.span, text);
        }
    }
}

/// The points and bars that supports, constraints and coordinates name.
fn named(description: &Description) -> Vec<&Ident> {
    let supports = description
        .supports
        .iter()
        .flat_map(|support| [Some(&support.name), support.under.as_ref(), support.over.as_ref()]);
    let equal = description.equal.iter().flat_map(|equal| &equal.members);
    let constrained = equal.map(|member| match member {
        Member::Bar(name) | Member::Coordinate(name) => Some(name),
    });
    let measured = description.coordinates.iter().flat_map(|c| match &c.reading {
        Reading::Angle { bar, from: Origin::Bar(other) } => [Some(bar), Some(other)],
        Reading::Angle { bar, .. } => [Some(bar), None],
        Reading::Position { point, .. } => [Some(point), None],
    });
    supports.chain(constrained).chain(measured).flatten().collect()
}
