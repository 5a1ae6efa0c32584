//! The equations of a model as people read them.

mod expression;
mod left_out;
mod multipliers;
mod phase;
mod quotient;
mod show;
mod sum;
mod system;
mod writer;

use crate::Analysis;
use crate::math::{Equation, Math};
use crate::motion::{Dense, Scene};
use crate::phases::{Phase, closed_forms};
use crate::program::Cost;
pub use writer::TextWriter;

/// The equations of a model: those of the whole system, and those of each contact set in closed
/// form. Its text is stable, fit for snapshots.
#[derive(Clone, Debug, Default)]
pub struct Equations {
    /// The model's name.
    pub name: String,
    /// The first paragraph of its documentation.
    pub summary: String,
    /// Parameters in the order declared.
    pub parameters: Vec<Parameter>,
    /// Bars, rigid bodies and particles.
    pub bodies: Vec<BodyText>,
    /// Generalised coordinates.
    pub coordinates: Vec<CoordinateText>,
    /// T and V.
    pub energies: Vec<Equation>,
    /// Entries of M that do not vanish, below the diagonal and on it.
    pub mass: Vec<Equation>,
    /// Velocity terms h that do not vanish.
    pub velocity_terms: Vec<Equation>,
    /// Generalised forces Q that do not vanish.
    pub forces: Vec<Equation>,
    /// What stands in the equations by a name of its own: elongations, loads; what is 1 while a
    /// condition holds, else 0.
    pub definitions: Vec<Equation>,
    /// Gap of each contact, by its label.
    pub gaps: Vec<Equation>,
    /// Two-sided constraints kept as multipliers, by name; they vanish.
    pub joints: Vec<(String, Math)>,
    /// The contact sets in closed form, free motion first.
    pub phases: Vec<PhaseEquations>,
    /// The others, with multipliers; none where there are very many.
    pub others: Vec<PhaseEquations>,
    /// All of these at once, each with the multipliers of all contacts: those of open ones are
    /// zero.
    pub general: Option<PhaseEquations>,
    /// What this scene does not have, and its code hence does not contain; a sentence each.
    pub left_out: Vec<String>,
}

/// A parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// As it is written.
    pub symbol: Math,
    /// As it is declared.
    pub name: String,
    /// The first paragraph of the field's documentation.
    pub meaning: String,
}

/// What has mass.
#[derive(Clone, Debug)]
pub struct BodyText {
    /// Its name; a particle is called by its point.
    pub name: String,
    /// Bar, body or particle.
    pub kind: &'static str,
    /// Mass.
    pub mass: Math,
    /// Distance between its first and last point; none of a particle.
    pub length: Option<Math>,
    /// Moment of inertia about the centre of mass; none of a particle.
    pub inertia: Option<Math>,
    /// Its points.
    pub points: Vec<String>,
}

/// A generalised coordinate.
#[derive(Clone, Debug)]
pub struct CoordinateText {
    /// As it is written.
    pub symbol: Math,
    /// What it measures.
    pub meaning: String,
}

/// The equations of a contact set.
#[derive(Clone, Debug, Default)]
pub struct PhaseEquations {
    /// Labels of its closed contacts, of members joined by commas: `A, E`.
    pub closed: Vec<String>,
    /// What it is called where nothing is closed, if not `free`: a mechanism without contacts, or
    /// one that is driven.
    pub unclosed: Option<&'static str>,
    /// The sets without closed form that these are the equations of, with multipliers; none of one
    /// in closed form.
    pub multipliers: Vec<Vec<String>>,
    /// What the closed contacts and joints determine.
    pub eliminated: Vec<Equation>,
    /// T and V in what is left, where something was eliminated.
    pub energies: Vec<Equation>,
    /// The equations of motion.
    pub motion: Vec<Equation>,
    /// Reactions of the closed contacts, forces of joints.
    pub reactions: Vec<Equation>,
    /// Operations of a right-hand side; none where loops over equal bars compute it.
    pub cost: Option<Cost>,
}

impl PhaseEquations {
    /// `free`, or `on A, E`, or `with multipliers: AB | A, B, AB`.
    pub fn title(&self) -> String {
        let set = |labels: &[String]| match labels {
            [] => self.unclosed.unwrap_or("free").to_owned(),
            _ => labels.join(", "),
        };
        match self.multipliers.as_slice() {
            [] if self.closed.is_empty() => set(&[]),
            [] => format!("on {}", set(&self.closed)),
            sets => {
                let sets: Vec<String> = sets.iter().map(|labels| set(labels)).collect();
                format!("with multipliers: {}", sets.join(" | "))
            }
        }
    }
}

impl Equations {
    /// What is written of the contact sets: those in closed form one by one, the others together.
    pub fn sections(&self) -> impl Iterator<Item = &PhaseEquations> {
        self.phases.iter().chain(&self.general)
    }

    /// What stands in place of equations where there are none: why.
    pub fn missing(why: &str) -> Self {
        Self { name: why.to_owned(), ..Self::default() }
    }
}

/// The equations of `analysis`.
pub(crate) fn equations(analysis: &Analysis) -> syn::Result<Equations> {
    let writer = TextWriter::new(analysis);
    let (dense, phases) = written_out(analysis)?;
    let mut equations = writer.system(&dense);
    equations.phases = phases.iter().map(|phase| writer.phase(phase)).collect();
    (equations.others, equations.general) = writer.without_closed_form(&dense, &phases);
    equations.left_out = left_out::describe_omissions(analysis, &dense, &phases);
    Ok(equations)
}

/// M, h and Q entry by entry, and the closed forms; those of long trees are worked out here.
pub(crate) fn written_out(analysis: &Analysis) -> syn::Result<(Dense, Vec<Phase>)> {
    let Analysis { system, kinematics, motion, .. } = analysis;
    if let Some(dense) = &analysis.dense {
        return Ok((dense.clone(), analysis.phases.clone()));
    }
    let dense = Dense::derive(&Scene { system, kinematics }, motion)?;
    let phases = closed_forms(system, kinematics, motion, &dense);
    Ok((dense, phases))
}
