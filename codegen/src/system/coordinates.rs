//! Declared coordinates. Of an undirected line the sign and the end are those for which the angle is acute
//! and positive in the figure; a bar along the line counts counter-clockwise.

use core::f64::consts::FRAC_PI_2;

use syn::Ident;

use super::bodies::Scene;
use super::figure::Figure;
use super::scope::Scope;
use super::{CoordinateKind, Declared, Reference};
use crate::algebra::Angle;
use crate::syntax::{Coordinate, Origin, Reading};

/// Angles nearer than this to a multiple of a quarter turn are that multiple: far above the rounding of a
/// figure's numbers, far below what is drawn.
const NEAR: f64 = 1e-9;

/// Resolves all declared coordinates.
pub(super) fn resolve(scope: &mut Scope, scene: &Scene, figure: &mut Option<Figure>) -> Vec<Declared> {
    let description = scope.description;
    let mut resolved: Vec<Declared> = Vec::new();
    for declared in &description.coordinates {
        let Some(kind) = kind(scope, scene, figure, declared) else {
            continue;
        };
        if let Some(other) = resolved.iter().find(|other| measures_the_same(&other.kind, &kind)) {
            let text =
                format!("`{}` measures what `{}` measures already; remove one", declared.name, other.name);
            scope.report.at(declared.name.span(), text);
        }
        resolved.push(Declared { name: declared.name.clone(), kind });
    }
    resolved
}

fn kind(
    scope: &mut Scope,
    scene: &Scene,
    figure: &mut Option<Figure>,
    declared: &Coordinate,
) -> Option<CoordinateKind> {
    let sign = if declared.negative { -1 } else { 1 };
    match &declared.reading {
        Reading::Position { point, axis } => {
            let point = scene.point(scope, point)?;
            Some(CoordinateKind::Position { point, axis: *axis, sign })
        }
        Reading::Angle { bar, from } => {
            let body = scene.body(scope, bar);
            let (reference, sign) = match from {
                Origin::Direction(quarters) => (ground(*quarters), sign),
                Origin::Bar(other) => (relative(scope, scene, bar, other)?, sign),
                Origin::Line(line) => {
                    let why = format!("the sign of `{}` depends on it", declared.name);
                    let drawn = figure.as_mut()?.direction(scope, scene, body?, &why)?;
                    let (quarters, sign) = acute(drawn, *line);
                    (ground(quarters), sign)
                }
            };
            Some(CoordinateKind::Angle { body: body?, reference, sign })
        }
    }
}

fn ground(quarters: i64) -> Reference {
    Reference::Ground(Angle::quarters(quarters))
}

fn relative(scope: &mut Scope, scene: &Scene, bar: &Ident, other: &Ident) -> Option<Reference> {
    if other == bar {
        let text = format!("`{other}` cannot be measured from itself");
        scope.report.at(other.span(), text);
        return None;
    }
    scene.body(scope, other).map(Reference::Body)
}

/// The end of the line, in quarter turns, and the sign with 0 ≤ sign·(direction − end) ≤ π/2.
fn acute(direction: f64, line: i64) -> (i64, i8) {
    let halves = (direction - line as f64 * FRAC_PI_2) / (2.0 * FRAC_PI_2);
    let whole = halves.floor();
    let rest = (halves - whole) * 2.0 * FRAC_PI_2;
    let half = whole as i64;
    if rest <= FRAC_PI_2 + NEAR {
        (line + 2 * half, 1)
    } else if rest >= 2.0 * FRAC_PI_2 - NEAR {
        (line + 2 * half + 2, 1)
    } else {
        (line + 2 * half + 2, -1)
    }
}

fn measures_the_same(a: &CoordinateKind, b: &CoordinateKind) -> bool {
    use CoordinateKind::{Angle, Position};
    match (a, b) {
        (
            Angle { body: a, reference: Reference::Ground(_), .. },
            Angle { body: b, reference: Reference::Ground(_), .. },
        ) => a == b,
        (Position { point: a, axis: i, .. }, Position { point: b, axis: j, .. }) => (a, i) == (b, j),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::acute;

    #[test]
    fn acute_and_positive_in_every_quadrant() {
        for step in -35..36 {
            let direction = f64::from(step) * 0.0898;
            for line in 0..2 {
                let (end, sign) = acute(direction, line);
                let q = f64::from(sign) * (direction - end as f64 * core::f64::consts::FRAC_PI_2);
                assert!((-1e-9..=core::f64::consts::FRAC_PI_2 + 1e-9).contains(&q), "{direction}: {q}");
                assert_eq!((end - line).rem_euclid(2), 0);
            }
        }
    }

    #[test]
    fn along_the_line_counts_counter_clockwise() {
        assert_eq!(acute(0.0, 0), (0, 1));
        assert_eq!(acute(-1e-17, 0), (0, 1));
        assert_eq!(acute(core::f64::consts::PI, 0), (2, 1));
        assert_eq!(acute(-core::f64::consts::FRAC_PI_2, 1).1, 1);
    }
}
