//! The quantities that a page draws over time: coordinates, reactions, energies and requested
//! outputs.

use crate::picture::{energies, shown};
use crate::registry::{MotionError, Units};
use liftoff::Trajectory;
use liftoff_core::model::ContactKind;
use serde::Serialize;

/// A quantity of the motion, by the expression that gives it.
#[derive(Serialize, Clone, PartialEq, Debug)]
pub(super) struct AnimatedQuantity {
    pub name: String,
    /// The typeset expression: `phi'` as φ̇.
    label: String,
    /// The unit, if it is known; empty for a pure number.
    unit: Option<String>,
    pub group: Group,
}

/// Quantities that share a graph.
#[derive(Serialize, Clone, Copy, PartialEq, Eq, Debug)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Group {
    Position,
    Angle,
    Length,
    AngularRate,
    Rate,
    Reaction,
    Tension,
    Friction,
    Slip,
    Coefficient,
    Gap,
    Energy,
    Output,
}

/// A quantity as a function of time.
pub(super) type Function<'a> = Box<dyn Fn(f64) -> f64 + 'a>;

/// Positions of the points, x then y of each; the standard quantities; the requested outputs.
pub(super) fn quantities(record: &Trajectory, outputs: &[String]) -> Vec<AnimatedQuantity> {
    let (layout, units) = (record.layout(), Units::from_layout(record.layout()));
    let mut all = Vec::new();
    let mut add = |group, name: String| {
        let (label, unit) = (shown(&name), units.unit(&name));
        all.push(AnimatedQuantity { name, label, unit, group });
    };
    for point in layout.points {
        for axis in ["x", "y"] {
            add(Group::Position, format!("{axis}({point})"));
        }
    }
    for coordinate in layout.names_of_positions() {
        let (value, rate) = match layout.is_angle(coordinate) {
            true => (Group::Angle, Group::AngularRate),
            false => (Group::Length, Group::Rate),
        };
        add(value, coordinate.to_owned());
        add(rate, format!("{coordinate}'"));
    }
    for contact in layout.contacts {
        let group = if contact.kind == ContactKind::Thread { Group::Tension } else { Group::Reaction };
        add(group, format!("N({})", contact.label));
        if contact.has_friction_force() {
            add(Group::Friction, format!("R({})", contact.label));
        }
        if contact.friction.is_some() {
            add(Group::Slip, format!("v({})", contact.supports[0]));
            add(Group::Coefficient, format!("mu({})", contact.supports[0]));
        }
        add(Group::Gap, format!("gap({})", contact.supports[0]));
    }
    for energy in energies(record) {
        add(Group::Energy, (*energy).to_owned());
    }
    for output in outputs {
        add(Group::Output, output.clone());
    }
    all
}

/// The quantities of a record as functions of time.
pub(super) fn functions<'a>(
    record: &'a Trajectory,
    quantities: &[AnimatedQuantity],
) -> Result<Vec<Function<'a>>, MotionError> {
    let function =
        |quantity: &AnimatedQuantity| Ok(Box::new(record.function(&quantity.name)?) as Function<'a>);
    quantities.iter().map(function).collect()
}
