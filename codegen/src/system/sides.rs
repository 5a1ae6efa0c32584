//! On which side of a support the figure lies.

use proc_macro2::Span;

use super::bodies::Structure;
use super::figure::{Figure, Heading, NEAR, Verdict};
use super::scope::Scope;
use super::{Edge, Settles};
use crate::algebra::{Rational, Series};
use crate::syntax::{Facing, SupportDeclaration, plain};

/// The side of the point, or of the figure's centroid if the point touches the wall.
pub(super) fn free_side(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Figure,
    declared: &SupportDeclaration,
    (point, x): (usize, &Series),
) -> Option<Facing> {
    let distance = &figure.positions[point][0] - x;
    let all = figure.positions.iter().map(|place| &place[0] - x).sum::<Series>();
    let centroid = all.scale(Rational::new(1, figure.positions.len() as i128));
    let sides = |distance: &Series| [vec![distance.clone()], vec![-distance]];
    let mut lengths = sides(&distance);
    if matches!(figure.decide(scope, &lengths), Verdict::Several(_)) {
        lengths = sides(&centroid);
    }
    let text = match figure.decide(scope, &lengths) {
        Verdict::One(side) => {
            let name = plain(&declared.name);
            figure.settle(scope, structure, Settles::Side, &name, &lengths[side], &Series::one());
            return Some([Facing::Right, Facing::Left][side]);
        }
        Verdict::Several(_) => "the figure is on both sides of this wall equally",
        Verdict::None => "the side of this wall on which the figure lies depends on the parameters",
    };
    scope.report.add_message(declared.span, format!("{text}; say its free side: `facing = left` or `right`"));
    None
}

/// +1 where the bar's left normal points up from a corner under it.
pub(super) fn side(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Figure,
    declared: &SupportDeclaration,
    body: usize,
) -> Option<i8> {
    let why = format!("the side of corner `{}` depends on it", declared.name);
    let Heading { along: [up, _], factor } = figure.direction(scope, structure, body, &why)?;
    let lengths = [vec![up.clone()], vec![-&up]];
    let how = match figure.decide(scope, &lengths) {
        Verdict::One(side) => {
            let name = plain(&declared.name);
            figure.settle(scope, structure, Settles::Side, &name, &lengths[side], &factor);
            let upwards = [1, -1][side];
            return Some(if declared.over.is_some() { -upwards } else { upwards });
        }
        Verdict::Several(_) => "is upright in the figure",
        Verdict::None => "points left or right in the figure, depending on the parameters",
    };
    let (kind, bar) = (structure.bodies[body].kind(), &structure.bodies[body].name);
    let text = format!("{kind} `{bar}` {how}, so a corner is neither under nor over it; tilt the figure");
    scope.report.add_message(declared.span, text);
    None
}

/// +1 where a point stays to the left of an edge.
pub(super) fn edge_side(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Figure,
    declared: &SupportDeclaration,
    (point, edge): (usize, &Edge),
) -> Option<i8> {
    if let Some(facing) = declared.facing {
        return Some(if facing == Facing::Left { 1 } else { -1 });
    }
    let why = format!("the side of support `{}` depends on it", declared.name);
    let points = [edge.ends[0], edge.ends[1], point];
    let given = points.map(|point| figure.demand(scope, structure, point, &why));
    if given.contains(&false) {
        return None;
    }
    let [from, to, at] = points.map(|point| &figure.positions[point]);
    let from_first = |place: &[Series; 2]| [0, 1].map(|axis| &place[axis] - &from[axis]);
    let (along, reach) = (from_first(to), from_first(at));
    let times = |a: &Series, b: &Series| scope.constants.multiply(a, b);
    let area = &times(&along[0], &reach[1]) - &times(&along[1], &reach[0]);
    let lengths = [vec![area.clone()], vec![-area]];
    let how = match figure.decide(scope, &lengths) {
        Verdict::One(side) => {
            let name = plain(&declared.name);
            figure.settle(scope, structure, Settles::Side, &name, &lengths[side], &edge.length);
            return Some([1, -1][side]);
        }
        Verdict::Several(_) => "in line with it",
        Verdict::None => "on one side of it or the other, depending on the parameters",
    };
    let [from, to, at] = points.map(|point| &structure.points[point].name);
    let text = format!(
        "the figure shows `{at}` {how}; say on which side it stays, seen from `{from}` to `{to}`: `facing = left` or `right`"
    );
    scope.report.add_message(declared.span, text);
    None
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
        scope.report.add_message(span, text);
    }
}
