//! What a name stands for, in a line of documentation.

use crate::kinematics::Coordinate;
use crate::syntax::DIRECTIONS;
use crate::system::{Body, CoordinateKind, Point, Reference, Section, System, listed};

/// A generalised coordinate with its origin, sense and unit.
pub(super) fn coordinate(system: &System, coordinate: &Coordinate) -> String {
    let name = &coordinate.name;
    let text = match &coordinate.reading {
        CoordinateKind::Position { point, axis, sign } => {
            let minus = if *sign < 0 { "−" } else { "" };
            format!("{minus}{} of `{}`, a length", ["x", "y"][*axis], system.points[*point].name)
        }
        CoordinateKind::Angle { body, reference, sign } => {
            let sense = if *sign < 0 { "clockwise" } else { "counter-clockwise" };
            format!("angle of `{}`{}, {sense}, rad", system.bodies[*body].name, from(system, reference))
        }
    };
    format!("Coordinate `{name}`: {text}.")
}

fn from(system: &System, reference: &Reference) -> String {
    match reference {
        Reference::Body(body) => format!(" from `{}`", system.bodies[*body].name),
        Reference::Ground(angle) if angle.terms().is_empty() => {
            let towards = DIRECTIONS[usize::from(angle.quarter_turns())];
            format!(" from {towards}")
        }
        Reference::Ground(_) => String::new(),
    }
}

/// A point with the bodies that it belongs to.
pub(super) fn point(system: &System, point: &Point) -> String {
    let name = &point.name;
    match (&point.ground, &point.on[..]) {
        (Some(_), _) => format!("Fixed point `{name}`."),
        (None, []) => format!("Point `{name}`."),
        (None, on) => {
            format!("Point `{name}` of {}.", listed(on.iter().map(|(body, _)| &system.bodies[*body].name)))
        }
    }
}

/// A bar, or a body of more than two points.
pub(super) fn body(system: &System, body: &Body) -> String {
    let name = &body.name;
    match &body.outline[..] {
        [from, to] => {
            format!("Bar `{name}` from `{}` to `{}`.", system.points[*from].name, system.points[*to].name)
        }
        _ => format!("Body `{name}`."),
    }
}

/// A section of a bar.
pub(super) fn section(system: &System, section: &Section) -> String {
    format!("Section `{}` of `{}`.", section.name, system.bodies[section.body].name)
}
