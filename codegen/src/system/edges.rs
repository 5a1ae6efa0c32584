//! Straight sides of bodies that carry: a bar along its length, or what lies between two points of
//! a body.

use syn::Ident;

use super::bodies::Structure;
use super::figure::Figure;
use super::scope::Scope;
use super::sides::edge_side;
use super::{Edge, OneSided, Point, Support};
use crate::algebra::Series;
use crate::syntax::{ShapeDeclaration, SupportDeclaration};

/// The support by a bar or an edge; none if it is not understood.
pub(super) fn support(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
    declared: &SupportDeclaration,
) -> Option<OneSided> {
    let name = declared.under.as_ref().unwrap_or(&declared.name);
    let point = structure.point(scope, name);
    let edge = edge(scope, structure, &declared.shape);
    let (point, edge) = (point?, edge?);
    if structure.members(edge.body).iter().any(|(member, _)| *member == point) {
        let text = format!(
            "`{name}` is a point of `{}`; a body does not meet itself",
            structure.bodies[edge.body].name
        );
        scope.report.add_message(name.span(), text);
        return None;
    }
    let side = edge_side(scope, structure, figure.as_mut()?, declared, (point, &edge))?;
    Some(OneSided::Edge { point, edge, side })
}

/// Reports a point that is to stay on both sides of one line of a body.
pub(super) fn both_sides(scope: &mut Scope, structure: &Structure, supports: &[Support]) {
    let sided = |support: &Support| match &support.contact {
        OneSided::Edge { point, edge, side } if support.armed.is_none() => {
            let [from, to] = edge.ends;
            let side = if from < to { *side } else { -side };
            Some((*point, [from.min(to), from.max(to)], side, edge.body))
        }
        _ => None,
    };
    for (i, support) in supports.iter().enumerate() {
        let Some((point, ends, side, body)) = sided(support) else { continue };
        let opposite = |other: &&Support| sided(other).is_some_and(|it| it == (point, ends, -side, body));
        let Some(other) = supports[..i].iter().find(opposite) else { continue };
        let (point, [from, to]) =
            (&structure.points[point].name, ends.map(|end| &structure.points[end].name));
        let text = format!(
            "`{point}` cannot stay on both sides of the line from `{from}` to `{to}`, which has no thickness: it is behind \
             `{}` or `{}`; declare one of them, give each a condition `while(\"…\")`, or give the body two sides",
            other.name, support.name
        );
        scope.report.add_message(support.span, text);
    }
}

/// The side that a shape names.
fn edge(scope: &mut Scope, structure: &Structure, shape: &ShapeDeclaration) -> Option<Edge> {
    match shape {
        ShapeDeclaration::Bar(bar) => {
            let body = structure.bar(scope, bar)?;
            let bar = &structure.bodies[body];
            let (ends, length) = ([bar.from, bar.to], bar.length.clone());
            Some(Edge { body, ends, along: [Series::one(), Series::zero()], length })
        }
        ShapeDeclaration::Edge(ends) => between(scope, structure, ends),
        _ => None,
    }
}

fn between(scope: &mut Scope, structure: &Structure, names: &[Ident; 2]) -> Option<Edge> {
    let [from, to] = names.each_ref().map(|name| structure.point(scope, name));
    let ends = [from?, to?];
    let wrong = |scope: &mut Scope, text: String| {
        scope.report.add_message(names[1].span(), text);
        None
    };
    if ends[0] == ends[1] {
        return wrong(scope, "the ends of an edge must be different points".to_owned());
    }
    let [first, last] = ends.map(|end| &structure.points[end]);
    let Some((body, [from, to])) = shared(first, last) else {
        let text = format!(
            "`{}` and `{}` are not on one body; an edge lies between two points of one body",
            first.name, last.name
        );
        return wrong(scope, text);
    };
    let step = [&to[0] - &from[0], &to[1] - &from[1]];
    let length = scope.norm(&step);
    let [x, y] = step.map(|part| scope.constants.divide(&part, &length));
    match x.zip(y) {
        Some((x, y)) => Some(Edge { body, ends, along: [x, y], length }),
        None => wrong(scope, "an edge has a length; these points are at one place".to_owned()),
    }
}

/// The first body of both, and where they are on it.
fn shared(first: &Point, last: &Point) -> Option<(usize, [[Series; 2]; 2])> {
    first.on.iter().find_map(|(body, from)| {
        let (_, to) = last.on.iter().find(|(other, _)| other == body)?;
        Some((*body, [from.clone(), to.clone()]))
    })
}
