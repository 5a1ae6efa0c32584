//! Springs and dampers between points, and between directions.

use syn::{Expr, Ident};

use super::formula::Readable;
use super::mass_properties::not_negative;
use super::scope::Scope;
use super::threads::nothing_moves;
use super::{Formula, Spring, Torsion};
use crate::algebra::Series;
use crate::syntax::{Resistance, SpringDeclaration, TorsionDeclaration, plain};

const WHY: &str = "what a spring is may change with time: it may contain `t` and parameters, no motion; what follows the motion is a \
                   `force` or a `couple`";

/// Resolves all springs between points.
pub(super) fn springs(scope: &mut Scope, readable: &Readable) -> Vec<Spring> {
    let description = scope.description;
    description.springs.iter().filter_map(|declared| spring(scope, readable, declared)).collect()
}

fn spring(scope: &mut Scope, readable: &Readable, declared: &SpringDeclaration) -> Option<Spring> {
    let (structure, name) = (readable.structure, &declared.name);
    let [stiffness, damping] = resistance(scope, readable, name, &declared.law);
    let length = match &declared.length {
        Some(expr) => not_below_zero(scope, readable, "the natural length", name, expr),
        None => Some(Formula::Constant(Series::zero())),
    };
    let [a, b] = declared.ends.each_ref().map(|end| structure.point(scope, end));
    let (a, b) = (a?, b?);
    if a == b || structure.rigid(a, b) {
        let [from, to] = &declared.ends;
        scope.report.add_message(name.span(), nothing_moves("spring", name, [from, to]));
        return None;
    }
    let (name, span) = (plain(name), name.span());
    let switch = scope.switch(&format!("spring {name}"), declared.armed.as_ref());
    Some(Spring { name, ends: [a, b], stiffness, length: length?, damping, switch, span })
}

/// Resolves all springs between directions.
pub(super) fn torsions(scope: &mut Scope, readable: &Readable) -> Vec<Torsion> {
    let description = scope.description;
    let mut resolved: Vec<Torsion> = Vec::new();
    for declared in &description.torsions {
        if let Some(torsion) = torsion(scope, readable, declared) {
            if resolved.iter().any(|other| other.name == torsion.name) {
                let text = format!("torsion `{}` is declared twice; remove one", torsion.name);
                scope.report.add_message(torsion.span, text);
            }
            resolved.push(torsion);
        }
    }
    resolved
}

fn torsion(scope: &mut Scope, readable: &Readable, declared: &TorsionDeclaration) -> Option<Torsion> {
    let (structure, span) = (readable.structure, declared.first.span());
    let [stiffness, damping] = resistance(scope, readable, &declared.first, &declared.law);
    let angle = match &declared.angle {
        Some(angle) => readable.of_time(scope, angle, WHY),
        None => Some(Formula::Constant(Series::zero())),
    };
    let first = structure.body(scope, &declared.first);
    let second = declared.second.as_ref().map(|second| structure.body(scope, second));
    let (name, body, from) = match (&declared.second, second) {
        (Some(second), Some(body)) => (format!("{}, {second}", declared.first), body?, Some(first?)),
        _ => (plain(&declared.first), first?, None),
    };
    if from == Some(body) {
        scope.report.add_message(span, format!("`{}` cannot be turned against itself", declared.first));
        return None;
    }
    let switch = scope.switch(&format!("torsion {name}"), declared.armed.as_ref());
    Some(Torsion { name, body, from, stiffness, angle: angle?, damping, switch, span })
}

fn resistance(
    scope: &mut Scope,
    readable: &Readable,
    owner: &Ident,
    law: &Resistance,
) -> [Option<Formula>; 2] {
    let mut value = |what: &str, expr: &Option<Expr>| {
        expr.as_ref().and_then(|expr| not_below_zero(scope, readable, what, owner, expr))
    };
    [value("the stiffness", &law.stiffness), value("the damping", &law.damping)]
}

fn not_below_zero(
    scope: &mut Scope,
    readable: &Readable,
    what: &str,
    owner: &Ident,
    expr: &Expr,
) -> Option<Formula> {
    let value = readable.of_time(scope, expr, WHY);
    not_negative(scope, what, owner, expr, value.as_ref().and_then(Formula::as_series));
    value
}
