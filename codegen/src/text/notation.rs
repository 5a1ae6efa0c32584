//! Names of parameters, coordinates and reactions as they are printed.

use crate::Analysis;
use crate::algebra::{Angle, Names, Series, Symbol};
use crate::system::{CoordinateKind, ParameterNames, Reference};

/// Prints with the names of one model.
pub(super) struct Notation<'a> {
    pub analysis: &'a Analysis,
    pub parameters: ParameterNames,
}

impl Names for Notation<'_> {
    fn parameter(&self, index: u16) -> String {
        self.parameters.parameter(index)
    }

    fn coordinate(&self, index: u16) -> String {
        self.analysis.kinematics.coordinates[usize::from(index)].name.clone()
    }

    fn reaction(&self, index: u16) -> String {
        self.reaction_name(index.into())
    }

    fn atom(&self, index: u16) -> String {
        self.analysis.motion.atoms[usize::from(index)].name.clone()
    }
}

impl Notation<'_> {
    pub(super) fn coordinate_name(&self, i: usize) -> String {
        Series::symbol(Symbol::coordinate(i)).text(self)
    }

    pub(super) fn rate_name(&self, i: usize) -> String {
        Series::symbol(Symbol::rate(i)).text(self)
    }

    pub(super) fn acceleration_name(&self, i: usize) -> String {
        Series::symbol(Symbol::acceleration(i)).text(self)
    }

    /// `N(A, E)` of a contact, the joint's name of a joint.
    pub(super) fn reaction_name(&self, row: usize) -> String {
        let Analysis { system, kinematics, motion, .. } = self.analysis;
        let (contacts, slips) = (motion.contacts.len(), motion.rows.len() - motion.tangents.len());
        match row {
            _ if row < contacts => format!("N({})", motion.contacts[row].label(system)),
            _ if row < slips => format!("force of {}", kinematics.joints[row - contacts].name),
            _ => format!("R({})", motion.contacts[motion.tangents[row - slips]].label(system)),
        }
    }

    /// A constant direction in words.
    fn direction(&self, angle: &Angle) -> String {
        match (angle.terms(), angle.quarter_turns()) {
            ([], quarters) => format!(
                "the {}",
                ["right", "upward vertical", "left", "downward vertical"][usize::from(quarters)]
            ),
            _ => format!("direction {}", self.angle(angle)),
        }
    }

    /// What a coordinate measures.
    pub(super) fn meaning(&self, reading: &CoordinateKind) -> String {
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
