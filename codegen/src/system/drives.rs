//! Prescribed motions.

use syn::{Expr, Ident};

use super::bodies::Structure;
use super::contact_law::Contacts;
use super::figure::{Figure, NEAR};
use super::formula::Readable;
use super::scope::Scope;
use super::threads::nothing_moves;
use super::{Drive, Driven, Formula, Reading};
use crate::algebra::Series;
use crate::syntax::{DriveDeclaration, Target, plain};

/// Resolves all drives; those on a condition are contacts too.
pub(super) fn resolve(
    scope: &mut Scope,
    readable: &Readable,
    figure: Option<&Figure>,
    contacts: &mut Contacts,
) -> Vec<Drive> {
    let description = scope.description;
    let mut resolved: Vec<Drive> = Vec::new();
    for declared in &description.drives {
        if let Some(drive) = drive(scope, readable, figure, declared) {
            if resolved.iter().any(|other| other.driven == drive.driven) {
                let text = format!("`{}` is driven twice; remove one drive", drive.name);
                scope.report.add_message(drive.span, text);
            }
            if drive.switched {
                one_motion(scope, &drive);
                let conditions = declared.armed.iter().chain(&declared.breaks);
                conditions.for_each(|switch| scope.use_words(&switch.condition));
                contacts.drive(&drive, resolved.len(), declared);
            }
            resolved.push(drive);
        }
    }
    resolved
}

fn drive(
    scope: &mut Scope,
    readable: &Readable,
    figure: Option<&Figure>,
    declared: &DriveDeclaration,
) -> Option<Drive> {
    let why = "a drive prescribes motion as a function of time: its value may contain `t` and parameters, no motion";
    let value = readable.prescribed(scope, &declared.value, why);
    if let Target::Distance(ends) = &declared.target {
        distant(scope, &ends[0], &declared.value, value.as_ref());
    }
    let (name, driven) = driven(scope, readable, figure, ("drive", &declared.target));
    let switched = declared.armed.is_some() || declared.breaks.is_some();
    let span = declared.target.ident().span();
    Some(Drive { name, driven: driven?, value: value?, switched, span })
}

/// What a drive prescribes, or a limit bounds, with its name.
pub(super) fn driven(
    scope: &mut Scope,
    readable: &Readable,
    figure: Option<&Figure>,
    (kind, target): (&str, &Target),
) -> (String, Option<Driven>) {
    let structure = readable.structure;
    let read = |reading: Option<Reading>| reading.map(Driven::Reading);
    match target {
        Target::Coordinate(name) => (plain(name), read(coordinate(scope, readable, name))),
        Target::Angle(bar) => {
            (format!("angle({bar})"), read(structure.body(scope, bar).map(Reading::Direction)))
        }
        Target::Position(point, axis) => {
            let position = structure.moving(scope, point).map(|point| Reading::Position(point, *axis));
            (format!("{}({point})", ["x", "y"][*axis]), read(position))
        }
        Target::Distance(ends) => (
            format!("distance({}, {})", ends[0], ends[1]),
            distance(scope, (structure, figure), (kind, ends)),
        ),
        Target::Turn(bars) => (format!("angle({}, {})", bars[0], bars[1]), turn(scope, structure, bars)),
        Target::Along(point, bar) => (format!("along({point}, {bar})"), along(scope, structure, point, bar)),
    }
}

/// Reports a drive on a condition in a mirrored model: it and its image would have to take hold as
/// one.
fn one_motion(scope: &mut Scope, drive: &Drive) {
    if scope.description.mirror.is_some() {
        let text = format!(
            "in a mirrored model drives are always there: `{}` has a condition; leave `mirror` out, or write a `couple`, a \
             `force` or a stiff `spring` with `while(\"…\")`",
            drive.name
        );
        scope.report.add_message(drive.span, text);
    }
}

fn coordinate(scope: &mut Scope, readable: &Readable, name: &Ident) -> Option<Reading> {
    let structure = readable.structure;
    if structure.bodies.iter().any(|body| plain(name) == body.name) && readable.coordinate(name).is_none() {
        let text = format!("`{name}` is a bar; write `angle({name})` for its direction");
        scope.report.add_message(name.span(), text);
        return None;
    }
    readable.declared(scope, name).map(Reading::Coordinate)
}

/// Reports a literal that is no distance.
fn distant(scope: &mut Scope, owner: &Ident, expr: &Expr, value: Option<&Formula>) {
    let Some(Formula::Constant(series)) = value else { return };
    if let Some(wrong) = series.as_constant().filter(|constant| constant.signum() <= 0) {
        let text = format!("the distance driven from `{owner}` is {wrong}; it must be positive");
        scope.report.over(expr, text);
    }
}

fn distance(
    scope: &mut Scope,
    (structure, figure): (&Structure, Option<&Figure>),
    (kind, ends): (&str, &[Ident; 2]),
) -> Option<Driven> {
    let [a, b] = ends.each_ref().map(|end| structure.point(scope, end));
    let (a, b) = (a?, b?);
    if a == b || structure.rigid(a, b) {
        let name = format!("distance({}, {})", ends[0], ends[1]);
        scope.report.add_message(ends[0].span(), nothing_moves(kind, &name, ends.each_ref()));
        return None;
    }
    let figure = figure?;
    let step = [0, 1].map(|axis| &figure.positions[b][axis] - &figure.positions[a][axis]);
    let near = |sample: &super::figure::Sample| {
        let [x, y] = step.each_ref().map(|part| sample.numbers.evaluate(part));
        x.hypot(y) <= NEAR
    };
    let nominal = scope.norm(&step);
    let inverse = scope.constants.divide(&Series::one(), &nominal);
    if inverse.is_none() || figure.samples.iter().any(near) {
        let text = format!(
            "the figure shows `{}` and `{}` at one place, so the {kind} of their distance has no direction; draw them apart",
            ends[0], ends[1]
        );
        scope.report.add_message(ends[0].span(), text);
        return None;
    }
    Some(Driven::Distance { ends: [a.min(b), a.max(b)], inverse: inverse? })
}

fn turn(scope: &mut Scope, structure: &Structure, bars: &[Ident; 2]) -> Option<Driven> {
    let [from, body] = bars.each_ref().map(|bar| structure.body(scope, bar));
    let (from, body) = (from?, body?);
    if from == body {
        scope.report.add_message(bars[1].span(), format!("`{}` does not turn against itself", bars[1]));
        return None;
    }
    Some(Driven::Turn { from, body })
}

fn along(scope: &mut Scope, structure: &Structure, point: &Ident, bar: &Ident) -> Option<Driven> {
    let (at, body) = (structure.point(scope, point), structure.bar(scope, bar));
    let (at, body) = (at?, body?);
    if structure.members(body).iter().any(|(member, _)| *member == at) {
        scope
            .report
            .add_message(point.span(), format!("`{point}` is a point of `{bar}`; it does not move along it"));
        return None;
    }
    Some(Driven::Along { point: at, body })
}
