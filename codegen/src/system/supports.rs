//! One-sided supports. The normal of a line is a quarter turn counter-clockwise from its direction.

use proc_macro2::Span;

use super::bodies::Scene;
use super::figure::Figure;
use super::scope::Scope;
use super::{Law, OneSided, Support};
use crate::algebra::{Angle, Series};
use crate::syntax::{Facing, Shape, SupportDeclaration};

/// Distances below this are taken for zero: far above the rounding of a figure's numbers.
const NEAR: f64 = 1e-9;

/// Resolves all supports.
pub(super) fn resolve(scope: &mut Scope, scene: &Scene, figure: &mut Option<Figure>) -> Vec<Support> {
    let description = scope.description;
    let mut resolved: Vec<Support> = Vec::new();
    for declared in &description.supports {
        let span = declared.name.span();
        if resolved.iter().any(|other| declared.name == other.name) {
            let text = format!(
                "support `{0}` is declared twice; give one another name: `other = …, under = {0}`",
                declared.name
            );
            scope.report.at(span, text);
        }
        if let Some(contact) = contact(scope, scene, figure, declared) {
            resolved.push(Support {
                name: declared.name.to_string(),
                span,
                contact,
                rough: false,
                restitution: None,
                law: Law::Newton,
                stop: false,
            });
        }
    }
    resolved
}

fn contact(
    scope: &mut Scope,
    scene: &Scene,
    figure: &mut Option<Figure>,
    declared: &SupportDeclaration,
) -> Option<OneSided> {
    if let Shape::Corner(at) = &declared.shape {
        let at = scope.position(at);
        let at = scope.report.keep(at);
        let body = scene.body(scope, declared.under.as_ref().or(declared.over.as_ref())?);
        let side = side(scope, scene, figure.as_mut()?, declared, body?)?;
        return Some(OneSided::Corner { body: body?, at: at?, side });
    }
    let point = scene.point(scope, declared.under.as_ref().unwrap_or(&declared.name));
    let why = format!("support `{}` is under it", declared.name);
    let given =
        figure.as_mut().zip(point).is_some_and(|(figure, point)| figure.demand(scope, scene, point, &why));
    let known = figure.as_ref().zip(point).filter(|_| given);
    let (through, direction) = line(scope, known, declared)?;
    Some(OneSided::Line { point: point?, through, direction })
}

fn line(
    scope: &mut Scope,
    known: Option<(&Figure, usize)>,
    declared: &SupportDeclaration,
) -> Option<([Series; 2], Angle)> {
    match &declared.shape {
        Shape::Corner(_) => None,
        Shape::Floor(height) => {
            let height = height.as_ref().map_or_else(|| Some(Series::zero()), |h| scope.number(h))?;
            Some(([Series::zero(), height], Angle::zero()))
        }
        Shape::Wall(x) => {
            let x = scope.number(x)?;
            let facing = match (declared.facing, known) {
                (Some(facing), _) => facing,
                (None, Some((figure, point))) => free_side(scope, figure, point, &x, declared.span)?,
                (None, None) => return None,
            };
            let quarters = if facing == Facing::Right { 3 } else { 1 };
            Some(([x, Series::zero()], Angle::quarters(quarters)))
        }
        Shape::Slope(angle, through) => {
            let angle = scope.angle(angle);
            let through =
                through.as_ref().map_or_else(|| Ok([Series::zero(), Series::zero()]), |p| scope.position(p));
            let (angle, through) = (scope.report.keep(angle), scope.report.keep(through));
            Some((through?, angle?))
        }
    }
}

/// The side of the point, or of the figure's centroid if the point touches the wall.
fn free_side(scope: &mut Scope, figure: &Figure, point: usize, x: &Series, span: Span) -> Option<Facing> {
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
fn side(
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
