//! Directions that keep their difference: of two bars welded where they meet, or of a bar and the
//! ground.

use super::bodies::Structure;
use super::figure::{Figure, unturned};
use super::scope::Scope;
use super::{Settles, Weld};
use crate::algebra::Angle;
use crate::syntax::WeldDeclaration;

/// Resolves all welds.
pub(super) fn resolve(scope: &mut Scope, structure: &Structure, figure: &mut Option<Figure>) -> Vec<Weld> {
    let description = scope.description;
    let mut resolved: Vec<Weld> = Vec::new();
    for declared in &description.welds {
        if let Some(weld) = weld(scope, structure, figure, declared) {
            let repeated = resolved.iter().any(|other| held(other) == held(&weld));
            if repeated {
                scope.report.add_message(weld.span, "this weld is declared twice; remove one");
            }
            resolved.push(weld);
        }
    }
    resolved
}

/// What a weld joins, in either order.
fn held(weld: &Weld) -> (Option<usize>, Option<usize>) {
    let pair = [Some(weld.body), weld.to];
    (pair[0].min(pair[1]), pair[0].max(pair[1]))
}

fn weld(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
    declared: &WeldDeclaration,
) -> Option<Weld> {
    let span = declared.first.span();
    let first = structure.body(scope, &declared.first);
    let angle = declared.angle.as_ref().map(|angle| {
        let angle = scope.angle(angle);
        scope.report.keep(angle)
    });
    let Some(second) = &declared.second else {
        return Some(Weld { body: first?, to: None, angle: angle??, span });
    };
    let (body, to) = (structure.body(scope, second)?, first?);
    let meet = structure.members(body).iter().any(|(p, _)| structure.members(to).iter().any(|(q, _)| p == q));
    if body == to || !meet {
        let text = match body == to {
            true => format!("`{second}` is welded to itself"),
            false => format!("`{}` and `{second}` share no point at which they are welded", declared.first),
        };
        scope.report.add_message(second.span(), text);
        return None;
    }
    let angle = match angle {
        Some(angle) => angle?,
        None => drawn(scope, structure, figure.as_mut()?, declared, [to, body])?,
    };
    Some(Weld { body, to: Some(to), angle, span })
}

/// The quarter turns from one body to the other, the same for all parameters.
fn drawn(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Figure,
    declared: &WeldDeclaration,
    [to, body]: [usize; 2],
) -> Option<Angle> {
    let why = format!("the angle of the weld of `{}` depends on it", declared.first);
    let given = [to, body].map(|body| figure.direction(scope, structure, body, &why));
    let [Some(from), Some(towards)] = given else { return None };
    let [cos, sin] = unturned(scope, &towards.along, &from.along);
    let quarters = [[&cos, &sin], [&sin, &-&cos], [&-&cos, &-&sin], [&-&sin, &cos]]
        .map(|[along, across]| vec![along.clone(), across.clone(), -across]);
    if let [quarter] = figure.everywhere(scope, &quarters)[..] {
        let factor = scope.constants.multiply(&from.factor, &towards.factor);
        let factor = scope.constants.multiply(&factor, &structure.bodies[to].length);
        let name = format!("{} and {}", structure.bodies[to].name, structure.bodies[body].name);
        figure.settle(scope, structure, Settles::Direction, &name, &quarters[quarter][..1], &factor);
        return Some(Angle::quarters(quarter as i64));
    }
    let text = "the figure shows no multiple of a quarter turn between these bars for all parameters; \
                give the angle from the first to the second: `angle = …`";
    scope.report.add_message(declared.first.span(), text);
    None
}
