//! What parameters alone determine: measures, restitution, the nominal figure and the numbers of a
//! drawing. Each is a list of values of a program of its own, and what is made of them.

mod measure;
mod measures;
mod nominal;
mod settled;

use crate::Analysis;
use crate::algebra::{Series, Symbol};
use crate::geometry::{self, Geometry};
use crate::program::{Id, Lowering, Program};
use crate::system::System;

pub use measure::{Measure, MeasureKind, MeasureValue, Turned};
pub use measures::Measures;
pub use nominal::{Nominal, NominalDirection, NominalReading, NominalReference};

/// Values that parameters determine.
#[derive(Clone, Debug)]
pub struct ParameterProgram {
    /// Their arithmetic.
    pub program: Program,
    /// The values.
    pub ids: Vec<Id>,
}

impl ParameterProgram {
    fn lower(system: &System, lower: impl FnOnce(&mut Lowering) -> Vec<Id>) -> Self {
        let mut program = Program::default();
        let ids = lower(&mut Lowering::new(&mut program, system, &[], []));
        Self { program, ids }
    }

    /// The values with these parameters.
    pub fn evaluate(&self, parameters: &[f64]) -> Vec<f64> {
        self.program.evaluate(&self.ids, &|symbol| match symbol {
            Symbol::Parameter(i) => parameters.get(usize::from(i)).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        })
    }
}

/// Restitution of each contact, then the tangential one of each with friction; none where all are
/// plastic.
pub fn restitution(analysis: &Analysis) -> Option<ParameterProgram> {
    let supports = analysis.motion.contacts.iter().map(|contact| contact.support(&analysis.system));
    let frictions = analysis.motion.frictions().map(|(contact, _)| {
        let support = analysis.motion.contacts[contact].support(&analysis.system);
        support.friction.as_ref()?.tangential.clone()
    });
    let restitution = supports.map(|support| support.restitution.clone()).chain(frictions);
    let restitution: Vec<Option<Series>> = restitution.collect();
    if restitution.iter().all(Option::is_none) {
        return None;
    }
    let zero = Series::zero();
    Some(ParameterProgram::lower(&analysis.system, |lowering| {
        restitution.iter().map(|e| lowering.series(e.as_ref().unwrap_or(&zero))).collect()
    }))
}

/// Masses, lengths, inertias, stiffnesses, gravity, and what the figure settled.
pub fn measures(analysis: &Analysis) -> Measures {
    Measures::lower(analysis)
}

/// The coordinates of the nominal figure.
pub fn nominal(analysis: &Analysis) -> Nominal {
    Nominal::lower(analysis)
}

/// Lengths, angles and places that a drawing refers to.
pub fn drawn(analysis: &Analysis, geometry: &Geometry) -> ParameterProgram {
    ParameterProgram::lower(&analysis.system, |lowering| {
        let value = |value: &geometry::Value| match value {
            geometry::Value::Length(length) => lowering.series(length),
            geometry::Value::Angle(angle) => lowering.angle(angle),
        };
        geometry.numbers.0.iter().map(value).collect()
    })
}
