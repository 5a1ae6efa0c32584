//! The equations of the whole system.

use super::{BodyText, CoordinateText, Equations, Parameter, TextWriter};
use crate::algebra::{Series, Symbol};
use crate::kinematics::DependentAngle;
use crate::math::{Equation, Math};
use crate::motion::Dense;
use crate::syntax::plain;

impl TextWriter<'_> {
    /// All but the phases and what is left out.
    pub(super) fn system(&self, dense: &Dense) -> Equations {
        let (system, motion) = (&self.analysis.system, &self.analysis.motion);
        let energy = |name, series| Equation::new(Math::symbol(name), self.series(series));
        let opaque_terms = motion.opaque_terms.iter().enumerate();
        let gap = |contact: &crate::motion::Contact| {
            Equation::new(Math::named("gap", &contact.label(system)), self.series(&contact.row.gap))
        };
        let joints = self.analysis.kinematics.joints.iter();
        let switches = system.switches.iter().enumerate().map(|(i, switch)| {
            Equation::new(self.symbol(Symbol::Switch(i as u16)), Math::named("while", &switch.condition))
        });
        Equations {
            name: plain(&system.ident),
            summary: system.summary.clone(),
            parameters: self.parameters(),
            bodies: self.bodies(),
            coordinates: self.coordinates(),
            energies: vec![energy("T", &dense.kinetic()), energy("V", &motion.potential)],
            mass: self.mass(&dense.mass),
            velocity_terms: self.vector("h", &dense.velocity_terms),
            forces: self.vector("Q", &dense.forces),
            definitions: opaque_terms
                .map(|(i, opaque_term)| {
                    Equation::new(self.symbol(Symbol::opaque(i)), self.expression(&opaque_term.orders[0]))
                })
                .chain(switches)
                .collect(),
            gaps: motion.contacts.iter().map(gap).collect(),
            joints: joints.map(|joint| (joint.name.clone(), self.series(&joint.equation))).collect(),
            ..Equations::default()
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        let system = &self.analysis.system;
        let names = system.parameters.iter().map(plain);
        let parameter = |(name, meaning): (String, &String)| Parameter {
            symbol: Math::symbol(&name),
            name,
            meaning: meaning.clone(),
        };
        names.zip(&system.meanings).map(parameter).collect()
    }

    /// What coordinates and dependent angles measure.
    pub fn coordinates(&self) -> Vec<CoordinateText> {
        let coordinates = self.analysis.kinematics.coordinates.iter().enumerate();
        let meaning = |(i, coordinate): (usize, &crate::kinematics::Coordinate)| CoordinateText {
            symbol: self.symbol(Symbol::coordinate(i)),
            meaning: self.meaning(&coordinate.reading),
        };
        let dependent = self.analysis.kinematics.dependent.iter().map(|angle| CoordinateText {
            symbol: Math::symbol(&angle.declared.name),
            meaning: format!("{}; {}", self.meaning(&angle.declared.reading), self.follows(angle)),
        });
        coordinates.map(meaning).chain(dependent).collect()
    }

    /// What a dependent angle is a sum of, `-2 psi + pi`.
    fn follows(&self, angle: &DependentAngle) -> String {
        let scaled = |symbol, factor: i32| Series::symbol(symbol).scale(i64::from(factor).into());
        let parameters = angle.parameters.iter().map(|&(i, factor)| scaled(Symbol::parameter(i), factor));
        let coordinates = angle.coordinates.iter().map(|&(i, factor)| scaled(Symbol::coordinate(i), factor));
        let sum = self.series(&parameters.chain(coordinates).sum());
        match angle.quarters {
            0 => format!("= {sum}"),
            quarters => format!("= {sum} {} {}°", if quarters < 0 { '−' } else { '+' }, 90 * quarters.abs()),
        }
    }

    fn bodies(&self) -> Vec<BodyText> {
        let system = &self.analysis.system;
        let name = |&point: &usize| system.points[point].name.clone();
        let bodies = system.bodies.iter().map(|body| BodyText {
            name: body.name.clone(),
            kind: body.kind(),
            mass: self.series(&body.mass),
            length: Some(self.series(&body.length)),
            inertia: Some(self.series(&body.inertia)),
            points: body.outline.iter().map(name).collect(),
        });
        let particles = system.particles.iter().map(|particle| BodyText {
            name: name(&particle.point),
            kind: "particle",
            mass: self.series(&particle.mass),
            length: None,
            inertia: None,
            points: vec![name(&particle.point)],
        });
        bodies.chain(particles).collect()
    }

    fn mass(&self, mass: &[Vec<Series>]) -> Vec<Equation> {
        let coordinate = |i| self.symbol(Symbol::coordinate(i));
        let entries = (0..mass.len()).flat_map(|i| (0..=i).map(move |j| (i, j)));
        let entries = entries.filter(|&(i, j)| !mass[i][j].is_zero());
        let entry = |(i, j): (usize, usize)| {
            let left = Math::Entry("M", vec![coordinate(i), coordinate(j)]);
            Equation::new(left, self.series(&mass[i][j]))
        };
        entries.map(entry).collect()
    }

    fn vector(&self, name: &'static str, entries: &[Series]) -> Vec<Equation> {
        let entries = entries.iter().enumerate().filter(|(_, entry)| !entry.is_zero());
        let entry = |(i, entry): (usize, &Series)| {
            let left = Math::Entry(name, vec![self.symbol(Symbol::coordinate(i))]);
            Equation::new(left, self.series(entry))
        };
        entries.map(entry).collect()
    }
}
