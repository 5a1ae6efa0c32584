//! Prescribed motions.

use syn::Ident;

use super::formula::Readable;
use super::scope::Scope;
use super::{Drive, Reading};
use crate::syntax::{DriveDeclaration, Target, plain};

/// Resolves all drives.
pub(super) fn resolve(scope: &mut Scope, readable: &Readable) -> Vec<Drive> {
    let description = scope.description;
    let mut resolved: Vec<Drive> = Vec::new();
    for declared in &description.drives {
        if let Some(drive) = drive(scope, readable, declared) {
            if resolved.iter().any(|other| other.reading == drive.reading) {
                let text = format!("`{}` is driven twice; remove one drive", drive.name);
                scope.report.at(drive.span, text);
            }
            resolved.push(drive);
        }
    }
    resolved
}

fn drive(scope: &mut Scope, readable: &Readable, declared: &DriveDeclaration) -> Option<Drive> {
    let why = "a drive prescribes motion as a function of time: its value may contain `t` and parameters, no motion";
    let value = readable.of_time(scope, &declared.value, why);
    let (name, reading) = match &declared.target {
        Target::Coordinate(name) => (plain(name), coordinate(scope, readable, name)),
        Target::Angle(bar) => {
            (format!("angle({bar})"), readable.structure.body(scope, bar).map(Reading::Direction))
        }
        Target::Position(point, axis) => {
            let name = format!("{}({point})", ["x", "y"][*axis]);
            let read = |point| Reading::Position(point, *axis);
            (name, readable.structure.moving(scope, point).map(read))
        }
    };
    Some(Drive { name, reading: reading?, value: value?, span: declared.target.ident().span() })
}

fn coordinate(scope: &mut Scope, readable: &Readable, name: &Ident) -> Option<Reading> {
    let structure = readable.structure;
    if structure.bodies.iter().any(|body| plain(name) == body.name) && readable.coordinate(name).is_none() {
        let text = format!("`{name}` is a bar; write `angle({name})` for its direction");
        scope.report.at(name.span(), text);
        return None;
    }
    readable.declared(scope, name).map(Reading::Coordinate)
}
