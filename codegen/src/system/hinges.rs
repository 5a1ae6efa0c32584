//! Hinges and pins with friction, as contacts that are closed always.

use super::bodies::Structure;
use super::contact_law::{Contacts, friction};
use super::mass_properties::positive;
use super::scope::Scope;
use super::{Law, OneSided};
use crate::syntax::{HingeDeclaration, plain};

/// Resolves all hinges with friction, after the supports.
pub(super) fn resolve(scope: &mut Scope, structure: &Structure, contacts: &mut Contacts) {
    let description = scope.description;
    for declared in &description.hinges {
        let name = &declared.point;
        contacts.claim(scope, "support", name, plain(name), "a hinge has its point's name: rename the other");
        let law = friction(scope, structure, name, Some(&declared.friction));
        let radius = positive(scope, "the radius", name, &declared.radius);
        let turning = turning(scope, structure, declared);
        if description.mirror.is_some() {
            let text = format!(
                "in a mirrored model hinges turn without friction: how that of `{name}` and of its image act on the motion is not \
                 known; leave `mirror` out"
            );
            scope.report.add_message(name.span(), text);
            continue;
        }
        if let Some(struck) = contacts.resolved.iter().find(|contact| contact.law != Law::Newton) {
            let text = format!(
                "beside the friction of hinge `{name}` impacts are those of `law = newton` alone; `{}` has another law",
                struck.name
            );
            scope.report.add_message(name.span(), text);
        }
        let (Some(law), Some(radius), Some((point, body, from))) = (law, radius, turning) else { continue };
        contacts.guide(name, OneSided::Hinge { point, body, from, radius }, law);
    }
}

/// The point, the body that turns there, and against which other one; against the ground where it
/// is pinned.
fn turning(
    scope: &mut Scope,
    structure: &Structure,
    declared: &HingeDeclaration,
) -> Option<(usize, usize, Option<usize>)> {
    let name = &declared.point;
    let point = structure.point(scope, name)?;
    let bodies: Vec<usize> = structure.points[point].on.iter().map(|(body, _)| *body).collect();
    let text = match (&bodies[..], structure.fixed(point).is_some()) {
        (&[body], true) => return Some((point, body, None)),
        (&[from, body], false) => return Some((point, body, Some(from))),
        ([] | [_], _) => format!(
            "nothing is hinged at `{name}`; hinge friction needs a point that two bodies share, or at which one is pinned"
        ),
        _ => format!(
            "more than two turn against each other at `{name}`, with the ground where it is pinned: which of them a journal joins is not \
             known; friction is that of a point which two bodies share, or by which one is pinned"
        ),
    };
    scope.report.add_message(name.span(), text);
    None
}
