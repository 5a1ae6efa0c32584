//! Limits of joints: bounds of angles, positions and distances, each a one-sided constraint.

use super::OneSided;
use super::contact_law::{Contacts, restitution};
use super::drives;
use super::figure::Figure;
use super::formula::Readable;
use super::mass_properties::positive;
use super::scope::Scope;
use crate::algebra::Series;
use crate::syntax::{Bound, LimitDeclaration, Target};

/// Resolves all limits.
pub(super) fn resolve(
    scope: &mut Scope,
    readable: &Readable,
    figure: Option<&Figure>,
    contacts: &mut Contacts,
) {
    let description = scope.description;
    for declared in &description.limits {
        let name = &declared.name;
        if description.mirror.is_some() {
            let text = format!(
                "in a mirrored model `{name}` and its image would have to strike as one; leave `mirror` out, or write a `support`"
            );
            scope.report.add_message(name.span(), text);
            declared.bounds().for_each(|bound| _ = scope.number(bound.value));
            continue;
        }
        let (_, driven) = drives::driven(scope, readable, figure, ("limit", &declared.target));
        let restitution = restitution(scope, name, &declared.contact_law);
        let values: Vec<_> = declared.bounds().map(|bound| number(scope, declared, bound.value)).collect();
        let [low, high] = match &values[..] {
            [low, high] => [low.as_ref(), high.as_ref()],
            _ => [None; 2],
        };
        if let Some(bounds) = low.zip(high) {
            refuse_reversed(scope, declared, bounds.into());
        }
        for (Bound { name: label, is_upper, .. }, value) in declared.bounds().zip(&values) {
            contacts.claim(scope, "limit", name, label.clone(), "give one another name: `other = …`");
            let (Some(driven), Some(bound)) = (driven.clone(), value.clone()) else { continue };
            let extent = match (low, &declared.target) {
                (Some(low), _) if is_upper => Some(&bound - low),
                (_, Target::Distance(_)) => Some(bound.clone()),
                _ => None,
            };
            let contact = OneSided::Limit { driven, bound, is_upper, extent };
            let law = (&declared.contact_law, restitution.clone());
            contacts.push(name, label, (contact, None), law, (None, None));
        }
    }
}

fn number(scope: &mut Scope, declared: &LimitDeclaration, bound: &syn::Expr) -> Option<Series> {
    match declared.target {
        Target::Distance(_) => positive(scope, "the limit", &declared.name, bound),
        _ => scope.number(bound),
    }
}

/// Reports bounds that leave nothing between them.
fn refuse_reversed(scope: &mut Scope, declared: &LimitDeclaration, bounds: [&Series; 2]) {
    let [Some(low), Some(high)] = bounds.map(|bound| scope.literal(bound)) else { return };
    if let Some(expr) = declared.high.as_ref().filter(|_| low >= high) {
        let text = format!("limit `{}` leaves no motion: its bounds are {low} and {high}", declared.name);
        scope.report.over(expr, text);
    }
}
