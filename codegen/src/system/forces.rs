//! Applied forces and couples.

use super::bodies::Structure;
use super::formula::Readable;
use super::scope::Scope;
use super::{Load, LoadKind};
use crate::syntax::{Couple, Force, plain};

/// Resolves all forces, then all couples.
pub(super) fn resolve(scope: &mut Scope, readable: &Readable) -> Vec<Load> {
    let description = scope.description;
    let mut resolved: Vec<Load> = Vec::new();
    resolved.extend(description.forces.iter().filter_map(|force| applied(scope, readable, force)));
    resolved.extend(description.couples.iter().filter_map(|couple| turning(scope, readable, couple)));
    resolved
}

fn applied(scope: &mut Scope, readable: &Readable, declared: &Force) -> Option<Load> {
    let point = readable.structure.moving(scope, declared.at.as_ref().unwrap_or(&declared.name));
    let frame = declared.frame.as_ref().map(|bar| readable.structure.body(scope, bar));
    let [x, y] = declared.value.each_ref().map(|expr| readable.formula(scope, expr));
    let frame = match frame {
        Some(frame) => Some(frame?),
        None => None,
    };
    let kind = LoadKind::Force { point: point?, frame, value: [x?, y?] };
    let name = plain(&declared.name);
    let switch = scope.switch(&format!("force {name}"), declared.armed.as_ref());
    Some(Load { name, kind, switch, span: declared.name.span() })
}

fn turning(scope: &mut Scope, readable: &Readable, declared: &Couple) -> Option<Load> {
    let structure: &Structure = readable.structure;
    let body = structure.body(scope, declared.on.as_ref().unwrap_or(&declared.name));
    let from = declared.from.as_ref().map(|bar| (bar, structure.body(scope, bar)));
    let value = readable.formula(scope, &declared.value);
    let from = match from {
        Some((bar, from)) if from.is_some() && from == body => {
            scope
                .report
                .add_message(bar.span(), format!("couple `{}` acts on `{bar}` from itself", declared.name));
            return None;
        }
        Some((_, from)) => Some(from?),
        None => None,
    };
    let kind = LoadKind::Couple { body: body?, from, value: value? };
    let name = plain(&declared.name);
    let switch = scope.switch(&format!("couple {name}"), declared.armed.as_ref());
    Some(Load { name, kind, switch, span: declared.name.span() })
}
