//! The names of a model, as derived code has them. They last as long as the program, once for each
//! declaration.

mod contacts;
mod geometry;

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use liftoff_codegen::functions::Kink;
use liftoff_codegen::geometry::Geometry;
use liftoff_codegen::motion::{ClosedSet, QuantityKind};
use liftoff_codegen::system::System;
use liftoff_codegen::{Analysis, in_bytes, plain};
use liftoff_core::model::{
    self, Bar, ContactSet, Coordinate, Defaults, DependentAngle, Dimension, Friction, Joint, Layout,
    Quantity, Term,
};

/// The layout of each declaration that there has been.
static KNOWN: Mutex<Option<HashMap<String, &'static Layout>>> = Mutex::new(None);

/// The layout of an analysed model.
pub(crate) fn build_layout(analysis: &Analysis) -> &'static Layout {
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let known = known.get_or_insert_default();
    let layout = || Box::leak(Box::new(layout(analysis)));
    known.entry(analysis.system.declaration.clone()).or_insert_with(|| layout())
}

/// A name that lasts.
pub(crate) fn text(text: &str) -> &'static str {
    Box::leak(text.into())
}

/// Entries that last.
fn list<T>(entries: impl IntoIterator<Item = T>) -> &'static [T] {
    Vec::leak(entries.into_iter().collect())
}

fn terms(terms: &[(usize, i32)]) -> &'static [Term] {
    list(terms.iter().map(|&(index, factor)| Term { index, factor }))
}

fn layout(analysis: &Analysis) -> Layout {
    let Analysis { system, dimensions, kinematics, motion, functions, .. } = analysis;
    let coordinates = kinematics.coordinates.iter();
    let bars = system.bodies.iter();
    let quantities = functions.quantities.iter();
    let drawn = Geometry::from_system(system, &kinematics.coordinates);
    Layout::new(text(&plain(&system.ident)))
        .declaration(text(&system.declaration))
        .summary(text(&system.summary))
        .parameters(list(system.parameters.iter().map(|name| text(&plain(name)))))
        .dimensions(list(dimensions.parameters.iter().map(|powers| {
            let (numerators, denominator) = in_bytes((*powers)?)?;
            Some(Dimension::new(numerators, denominator))
        })))
        .defaults(Box::leak(Box::new(defaults(system))))
        .covariant(dimensions.covariant)
        .coordinates(list(coordinates.map(|c| Coordinate { name: text(&c.name), is_angle: c.is_angle() })))
        .dependent(list(kinematics.dependent.iter().map(|angle| DependentAngle {
            name: text(&angle.declared.name),
            quarters: angle.quarters,
            parameters: terms(&angle.parameters),
            coordinates: terms(&angle.coordinates),
        })))
        .contacts(contacts::contacts(analysis))
        .joints(list(
            kinematics
                .joints
                .iter()
                .map(|joint| Joint { name: text(&joint.name), is_angle: joint.is_angle(system) }),
        ))
        .tangents(list(motion.tangents.iter().copied()))
        .frictions(list(motion.frictions().map(|(contact, row)| Friction {
            contact,
            row,
            follows_slip: motion.follows_slip(system, contact),
        })))
        .timed(motion.is_timed())
        .switches(list(
            system.switches.iter().map(|switch| model::Switch {
                label: text(&switch.label),
                condition: text(&switch.condition),
            }),
        ))
        .signals(list(
            system
                .signals
                .iter()
                .map(|signal| model::Signal { expression: text(&signal.expression), drives: signal.drives }),
        ))
        .compliant(system.is_compliant())
        .kinks(list(functions.kinks.iter().map(|kink| match kink {
            Kink::Sign(_) => model::Kink::Sign,
            Kink::Radicand(_) => model::Kink::Radicand,
        })))
        .loaded(system.is_loaded())
        .quantities(list(quantities.map(|q| Quantity { name: text(&q.name), kind: kind(q.kind) })))
        .points(list(system.points.iter().map(|point| text(&point.name))))
        .bars(list(bars.map(|bar| Bar { name: text(&bar.name), from: bar.from, to: bar.to })))
        .closed_forms(list(functions.phases.iter().map(|phase| set(phase.set))))
        .geometry(Box::leak(Box::new(geometry::geometry(&drawn))))
}

fn defaults(system: &System) -> Defaults {
    let (values, run) = (&system.values, &system.run);
    if system.is_without_defaults() {
        return Defaults::NONE;
    }
    Defaults {
        values: list(values.iter().map(|known| known.value)),
        units: list(values.iter().map(|known| text(&known.unit))),
        start: list(run.start.iter().map(|start| (text(&start.name), start.value))),
        until: list(run.until.iter().map(|condition| text(condition))),
        limit: run.limit,
    }
}

fn set(ClosedSet { closed, stick }: ClosedSet) -> ContactSet {
    ContactSet::from_bits_and_stick(closed, stick)
}

fn kind(kind: QuantityKind) -> model::QuantityKind {
    match kind {
        QuantityKind::JointForce => model::QuantityKind::JointForce,
        QuantityKind::JointCouple => model::QuantityKind::JointCouple,
        QuantityKind::DriveForce => model::QuantityKind::DriveForce,
        QuantityKind::DriveTorque => model::QuantityKind::DriveTorque,
        QuantityKind::DrivenDistance => model::QuantityKind::DrivenDistance,
        QuantityKind::SpringForce => model::QuantityKind::SpringForce,
        QuantityKind::SpringTorque => model::QuantityKind::SpringTorque,
        QuantityKind::SectionForce => model::QuantityKind::SectionForce,
        QuantityKind::BendingMoment => model::QuantityKind::BendingMoment,
        QuantityKind::Momentum => model::QuantityKind::Momentum,
        QuantityKind::AngularMomentum => model::QuantityKind::AngularMomentum,
    }
}
