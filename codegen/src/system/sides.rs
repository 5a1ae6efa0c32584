//! On which side of a support the figure lies.

use proc_macro2::Span;

use super::bodies::Scene;
use super::figure::{Figure, NEAR};
use super::scope::Scope;
use crate::algebra::Series;
use crate::syntax::{Facing, SupportDeclaration};

/// The side of the point, or of the figure's centroid if the point touches the wall.
pub(super) fn free_side(
    scope: &mut Scope,
    figure: &Figure,
    point: usize,
    x: &Series,
    span: Span,
) -> Option<Facing> {
    let wall = scope.nominal().of(x);
    let all = figure.numbers.iter().map(|p| p[0] - wall);
    let centroid = all.sum::<f64>() / figure.numbers.len() as f64;
    let distance = [figure.numbers[point][0] - wall, centroid].into_iter().find(|d| d.abs() > NEAR);
    if distance.is_none() {
        scope.report.at(
            span,
            "the figure lies evenly about this wall; say its free side: `facing = left` or `right`",
        );
    }
    distance.map(|d| if d > 0.0 { Facing::Right } else { Facing::Left })
}

/// +1 where the bar's left normal points up from a corner under it.
pub(super) fn side(
    scope: &mut Scope,
    scene: &Scene,
    figure: &mut Figure,
    declared: &SupportDeclaration,
    body: usize,
) -> Option<i8> {
    let why = format!("the side of corner `{}` depends on it", declared.name);
    let up = figure.direction(scope, scene, body, &why)?.cos();
    if up.abs() < NEAR {
        let text = format!(
            "bar `{}` is upright in the figure, so a corner is neither under nor over it; tilt the figure",
            scene.bodies[body].name
        );
        scope.report.at(declared.span, text);
    }
    let upwards = if up > 0.0 { 1 } else { -1 };
    Some(if declared.over.is_some() { -upwards } else { upwards })
}

/// Reports a point on the wrong side of a circle, where no parameter could help.
pub(super) fn on_its_side(
    scope: &mut Scope,
    place: &[Series; 2],
    (centre, radius): (&[Series; 2], &Series),
    inside: bool,
    span: Span,
) {
    let known = (scope.literal_pair(place), scope.literal_pair(centre), scope.literal(radius));
    let (Some([x, y]), Some([u, v]), Some(radius)) = known else {
        return;
    };
    let distance = (x - u).hypot(y - v);
    let gap = if inside { radius - distance } else { distance - radius };
    if gap < -NEAR * radius {
        let must = if inside { "at most" } else { "at least" };
        let text = format!(
            "the figure's point is {distance} from the centre of this circle; it must be {must} {radius}"
        );
        scope.report.at(span, text);
    }
}
