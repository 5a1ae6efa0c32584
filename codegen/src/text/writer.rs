//! Names of parameters, coordinates and reactions as they are written.

use crate::Analysis;
use crate::algebra::{Angle, Series, Symbol, SymbolNames};
use crate::math::{Equation, Math};
use crate::system::{CoordinateKind, ParameterNames, Reference};

/// Writes with the names of one model.
pub struct TextWriter<'a> {
    pub(crate) analysis: &'a Analysis,
    parameters: ParameterNames,
    places: Vec<u8>,
}

impl<'a> TextWriter<'a> {
    /// With the names of this model.
    pub fn new(analysis: &'a Analysis) -> Self {
        let places = (0..analysis.system.parameters.len()).map(|i| rank_parameter(analysis, i)).collect();
        Self { analysis, parameters: analysis.system.names(), places }
    }
}

/// Numbers, masses and what has mass in it, `g` and what else has time in it, lengths.
fn rank_parameter(analysis: &Analysis, parameter: usize) -> u8 {
    let symbol = Symbol::parameter(parameter);
    let weighs = || analysis.system.gravity.iter().flatten().any(|g| g.depends_on(symbol));
    match analysis.dimensions.parameters[parameter] {
        Some([length, time, mass]) if [length, time, mass].iter().all(|power| power.is_zero()) => NUMBER,
        Some([.., mass]) if !mass.is_zero() => MASS,
        Some([_, time, _]) if !time.is_zero() => TIME,
        None if weighs() => TIME,
        _ => LENGTH,
    }
}

const NUMBER: u8 = 0;
pub(super) const MASS: u8 = 1;
const TIME: u8 = 2;
const LENGTH: u8 = 3;

impl SymbolNames for TextWriter<'_> {
    fn parameter(&self, index: u16) -> Math {
        self.parameters.parameter(index)
    }

    fn rank_parameter(&self, index: u16) -> u8 {
        self.places.get(usize::from(index)).copied().unwrap_or(NUMBER)
    }

    fn coordinate(&self, index: u16) -> String {
        self.analysis.kinematics.coordinates[usize::from(index)].name.clone()
    }

    fn reaction(&self, index: u16) -> Math {
        self.row(index.into())
    }

    fn opaque_term(&self, index: u16) -> String {
        self.analysis.motion.opaque_terms[usize::from(index)].name.clone()
    }
}

impl TextWriter<'_> {
    pub(super) fn symbol(&self, symbol: Symbol) -> Math {
        Series::symbol(symbol).math(self)
    }

    /// `N(A, E)` of a contact, the joint's name of a joint.
    pub fn row(&self, row: usize) -> Math {
        let Analysis { system, kinematics, motion, .. } = self.analysis;
        let (contacts, slips) = (motion.contacts.len(), motion.slips());
        match row {
            _ if row < contacts && motion.contacts[row].driven => {
                Math::Words(format!("force of {}", motion.contacts[row].label(system)))
            }
            _ if row < contacts => Math::named("N", &motion.contacts[row].label(system)),
            _ if row < slips => Math::Words(format!("force of {}", kinematics.joints[row - contacts].name)),
            _ => Math::named("R", &motion.contacts[motion.tangents[row - slips]].label(system)),
        }
    }

    /// `N(A, E) = N(A) + N(E)` of a contact with several supports.
    pub fn total(&self, row: usize) -> Option<Equation> {
        let Analysis { system, motion, .. } = self.analysis;
        let contact = motion.contacts.get(row).filter(|contact| contact.supports.len() > 1)?;
        let each = contact.supports.iter().map(|&support| Math::named("N", &system.supports[support].name));
        Some(Equation::new(self.row(row), Math::sum(each)))
    }

    /// A constant direction in words.
    fn direction(&self, angle: &Angle) -> String {
        match (angle.terms(), angle.quarter_turns()) {
            ([], quarters) => format!(
                "the {}",
                ["right", "upward vertical", "left", "downward vertical"][usize::from(quarters)]
            ),
            _ => format!("direction {}", angle.math(self)),
        }
    }

    /// What a coordinate measures.
    pub(crate) fn meaning(&self, reading: &CoordinateKind) -> String {
        let system = &self.analysis.system;
        match reading {
            CoordinateKind::Position { point, axis, sign } => {
                let sign = if *sign < 0 { "−" } else { "" };
                format!("{sign}{} of {}", ["x", "y"][*axis], system.points[*point].name)
            }
            CoordinateKind::Angle { body, reference, sign } => {
                let turn = if *sign < 0 { "clockwise" } else { "counter-clockwise" };
                let from = match reference {
                    Reference::Ground(angle) => self.direction(angle),
                    Reference::Body(other) => system.bodies[*other].name.clone(),
                };
                format!("angle of {} from {from}, {turn}", system.bodies[*body].name)
            }
        }
    }
}
