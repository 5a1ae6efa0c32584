//! Equal angles: consecutive pairs of the angles named.

use proc_macro2::Span;
use syn::Ident;

use super::bodies::Structure;
use super::scope::Scope;
use super::{ConstrainedAngle, CoordinateKind, Declared, Equal};
use crate::syntax::{EqualAngles, Member, Multiple, plain, unknown};

/// Resolves all equal-angle constraints.
pub(super) fn resolve(scope: &mut Scope, structure: &Structure, coordinates: &[Declared]) -> Vec<Equal> {
    let description = scope.description;
    description.equal.iter().flat_map(|declared| pairs(scope, structure, coordinates, declared)).collect()
}

fn pairs(
    scope: &mut Scope,
    structure: &Structure,
    coordinates: &[Declared],
    declared: &EqualAngles,
) -> Vec<Equal> {
    let directions: Option<Vec<_>> = declared
        .members
        .iter()
        .map(|Multiple { factor, member }| {
            Some((*factor, direction(scope, structure, coordinates, member)?, member.span()))
        })
        .collect();
    let directions = directions.unwrap_or_default();
    let equal = |pair: &[(i32, ConstrainedAngle, Span)]| {
        let [(a, left, _), (b, right, span)] = *pair else { return None };
        Some(Equal { factors: [a, b], left, right, span })
    };
    directions.windows(2).filter_map(equal).collect()
}

fn direction(
    scope: &mut Scope,
    structure: &Structure,
    coordinates: &[Declared],
    member: &Member,
) -> Option<ConstrainedAngle> {
    match member {
        Member::Bar(bar) => structure.body(scope, bar).map(ConstrainedAngle::Body),
        Member::Coordinate(name) => {
            angle(scope, structure, coordinates, name).map(ConstrainedAngle::Coordinate)
        }
    }
}

fn angle(scope: &mut Scope, structure: &Structure, coordinates: &[Declared], name: &Ident) -> Option<usize> {
    let found = coordinates.iter().position(|c| c.name == *name);
    let text = match found.map(|i| &coordinates[i].kind) {
        Some(CoordinateKind::Angle { .. }) => return found,
        Some(CoordinateKind::Position { .. }) => {
            format!("`{name}` is not an angle; only angles can be kept equal here")
        }
        None if structure.bodies.iter().any(|body| plain(name) == body.name) => {
            format!("`{name}` is a bar; write `angle({name})` for its direction")
        }
        None => {
            let declared: Vec<String> =
                scope.description.coordinates.iter().map(|c| plain(&c.name)).collect();
            if declared.iter().any(|other| plain(name) == *other)
                || scope.description.malformed.contains(&plain(name))
            {
                return None;
            }
            unknown("coordinate", name, declared.iter().map(String::as_str))
        }
    };
    scope.report.add_message(name.span(), text);
    None
}
