//! Declared coordinates. Of an undirected line the sign and the end are those for which the angle
//! is acute and positive in the figure; a bar along the line counts counter-clockwise.

use syn::Ident;

use super::bodies::Structure;
use super::figure::{Figure, Heading, Verdict};
use super::scope::Scope;
use super::{CoordinateKind, Declared, Reference, Settles};
use crate::algebra::{Angle, Series};
use crate::syntax::{CoordinateDeclaration, Origin, ReadingDeclaration, plain};

/// Resolves all declared coordinates.
pub(super) fn resolve(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
) -> Vec<Declared> {
    let description = scope.description;
    let mut resolved: Vec<Declared> = Vec::new();
    for declared in &description.coordinates {
        let Some(kind) = kind(scope, structure, figure, declared) else {
            continue;
        };
        if let Some(other) = resolved.iter().find(|other| measures_the_same(&other.kind, &kind)) {
            let text =
                format!("`{}` measures what `{}` measures already; remove one", declared.name, other.name);
            scope.report.add_message(declared.name.span(), text);
        }
        resolved.push(Declared { name: declared.name.clone(), kind });
    }
    resolved
}

fn kind(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
    declared: &CoordinateDeclaration,
) -> Option<CoordinateKind> {
    let sign = if declared.negative { -1 } else { 1 };
    match &declared.reading {
        ReadingDeclaration::Position { point, axis } => {
            let point = structure.point(scope, point)?;
            Some(CoordinateKind::Position { point, axis: *axis, sign })
        }
        ReadingDeclaration::Angle { bar, from } => {
            let body = structure.body(scope, bar);
            let (reference, sign) = match from {
                Origin::Direction(quarters) => (ground(*quarters), sign),
                Origin::Bar(other) => (relative(scope, structure, bar, other)?, sign),
                Origin::Line(line) => {
                    let why = format!("the sign of `{}` depends on it", declared.name);
                    let figure = figure.as_mut()?;
                    let drawn = figure.direction(scope, structure, body?, &why)?;
                    let (quarters, sign) = acute(scope, structure, figure, &drawn, (*line, declared))?;
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

fn relative(scope: &mut Scope, structure: &Structure, bar: &Ident, other: &Ident) -> Option<Reference> {
    if other == bar {
        let text = format!("`{other}` cannot be measured from itself");
        scope.report.add_message(other.span(), text);
        return None;
    }
    structure.body(scope, other).map(Reference::Body)
}

/// The end of the line, in quarter turns, and the sign with 0 ≤ sign·(direction − end) ≤ π/2: of a
/// bar along or across the line the counter-clockwise one.
fn acute(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Figure,
    drawn: &Heading,
    (line, declared): (i64, &CoordinateDeclaration),
) -> Option<(i64, i8)> {
    let ends = [(line, 1), (line + 2, 1), (line + 2, -1), (line, -1)];
    let lengths = ends.map(|(end, sign)| {
        let [cos, sin] = turned_back(&drawn.along, end);
        vec![cos, if sign < 0 { -&sin } else { sin }]
    });
    match figure.decide(scope, &lengths) {
        Verdict::One(i) | Verdict::Several(i) => {
            figure.settle(
                scope,
                structure,
                Settles::Sign,
                &plain(&declared.name),
                &lengths[i],
                &drawn.factor,
            );
            Some(ends[i])
        }
        Verdict::None => {
            let text = format!(
                "the sign of `{}` is another for other parameters; measure it from a direction: `from = right`, \
                 `up`, `left` or `down`",
                declared.name
            );
            scope.report.add_message(declared.name.span(), text);
            None
        }
    }
}

/// A vector as seen from one turned by quarter turns.
fn turned_back([x, y]: &[Series; 2], quarters: i64) -> [Series; 2] {
    match quarters.rem_euclid(4) {
        0 => [x.clone(), y.clone()],
        1 => [y.clone(), -x],
        2 => [-x, -y],
        _ => [-y, x.clone()],
    }
}

/// Whether two coordinates measure the direction of one bar from the ground, or the position of one
/// point along one axis.
pub(crate) fn measures_the_same(a: &CoordinateKind, b: &CoordinateKind) -> bool {
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
