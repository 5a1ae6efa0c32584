//! The equations of a model in textbook notation.

mod expression;
mod notation;
mod quotient;
mod sum;

use core::fmt;

use crate::Analysis;
use crate::algebra::{Angle, Series, Symbol};
use crate::motion::{Dense, Scene};
use crate::phases::{Phase, Value, closed_forms};
use notation::Notation;

/// The equations of a model: those of the whole system, and those of each contact set.
#[derive(Clone, Debug)]
pub struct Equations {
    /// Coordinates, energies, mass matrix, forces, gaps.
    pub system: String,
    /// For each closed form: the closed supports joined by commas (empty when free), and its equations.
    pub phases: Vec<(String, String)>,
}

impl fmt::Display for Equations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.system)?;
        self.phases.iter().try_for_each(|(_, text)| write!(f, "\n{text}"))
    }
}

/// Prints `analysis`.
pub(crate) fn equations(analysis: &Analysis) -> syn::Result<Equations> {
    let Analysis { system, kinematics, motion, .. } = analysis;
    let notation = Notation { analysis, parameters: system.names() };
    let (dense, phases) = match &analysis.dense {
        Some(dense) => (dense.clone(), analysis.phases.clone()),
        None => {
            let dense = Dense::of(&Scene { system, kinematics }, motion)?;
            let phases = closed_forms(system, kinematics, motion, &dense);
            (dense, phases)
        }
    };
    let phases = phases.iter().map(|phase| (label(analysis, phase), notation.phase(phase)));
    Ok(Equations { system: notation.system(&dense), phases: phases.collect() })
}

fn label(analysis: &Analysis, phase: &Phase) -> String {
    let contacts = analysis.motion.contacts.iter().enumerate();
    let closed = contacts.filter(|(i, _)| phase.set >> i & 1 == 1);
    let labels: Vec<String> = closed.map(|(_, c)| c.label(&analysis.system)).collect();
    labels.join(", ")
}

impl Notation<'_> {
    fn system(&self, dense: &Dense) -> String {
        let (system, motion) = (&self.analysis.system, &self.analysis.motion);
        let mut lines = vec![format!("{}", system.ident)];
        let mut line = |text: String| lines.push(format!("  {text}"));
        for (i, coordinate) in self.analysis.kinematics.coordinates.iter().enumerate() {
            line(format!("{}: {}", self.coordinate_name(i), self.meaning(&coordinate.reading)));
        }
        line(format!("T = {}", self.series(&dense.kinetic())));
        line(format!("V = {}", self.series(&motion.potential)));
        for i in 0..motion.n {
            for j in (0..=i).filter(|&j| !dense.mass[i][j].is_zero()) {
                let entry = self.series(&dense.mass[i][j]);
                line(format!("M[{}, {}] = {entry}", self.coordinate_name(i), self.coordinate_name(j)));
            }
        }
        for i in (0..motion.n).filter(|&i| !dense.velocity_terms[i].is_zero()) {
            line(format!("h[{}] = {}", self.coordinate_name(i), self.series(&dense.velocity_terms[i])));
        }
        for i in (0..motion.n).filter(|&i| !dense.forces[i].is_zero()) {
            line(format!("Q[{}] = {}", self.coordinate_name(i), self.series(&dense.forces[i])));
        }
        for (i, atom) in motion.atoms.iter().enumerate() {
            let name = self.series(&Series::symbol(Symbol::atom(i)));
            line(format!("{name} = {}", self.expression(&atom.orders[0], false)));
        }
        for contact in &motion.contacts {
            line(format!("gap({}) = {}", contact.label(system), self.series(&contact.row.gap)));
        }
        for joint in &self.analysis.kinematics.joints {
            line(format!("{}: 0 = {}", joint.name, self.series(&joint.equation)));
        }
        lines.push(String::new());
        lines.join("\n")
    }

    fn phase(&self, phase: &Phase) -> String {
        let label = label(self.analysis, phase);
        let title = if label.is_empty() { "free".to_owned() } else { format!("on {label}") };
        let mut lines = vec![title];
        let mut line = |text: String| lines.push(format!("  {text}"));
        for elimination in &phase.eliminated {
            let value = self.value(&elimination.value);
            let name = match elimination.value {
                Value::Rate(_) => self.rate_name(elimination.coordinate),
                Value::Length(_) | Value::Angle(_) => self.coordinate_name(elimination.coordinate),
            };
            line(format!("{name} = {value}"));
        }
        if !phase.eliminated.is_empty() {
            line(format!("T = {}", self.quotient(&phase.kinetic)));
            line(format!("V = {}", self.quotient(&phase.potential)));
        }
        for k in 0..phase.moving.len() {
            line(format!("{} = {}", self.left(phase, k), self.quotient(&phase.forces[k])));
        }
        for (row, reaction) in &phase.reactions {
            line(format!("{} = {}", self.reaction_name(*row), self.quotient(reaction)));
        }
        line(format!("cost: {}", self.cost(phase)));
        lines.push(String::new());
        lines.join("\n")
    }

    /// `(M₁₁) q̈₁ + (M₁₂) q̈₂ + h₁`.
    fn left(&self, phase: &Phase, k: usize) -> String {
        let terms = phase.moving.iter().enumerate().filter(|(l, _)| !phase.mass[k][*l].is_zero());
        let terms = terms.map(|(l, &i)| {
            let entry = self.quotient(&phase.mass[k][l]);
            let sum = entry.contains(" + ") || entry.contains(" − ");
            let entry = if sum { format!("({entry})") } else { entry };
            format!("{entry} {}", self.acceleration_name(i))
        });
        let velocity = &phase.velocity_terms[k];
        let velocity = (!velocity.is_zero()).then(|| self.quotient(velocity));
        let sum = quotient::joined(terms.chain(velocity));
        if sum.is_empty() { "0".to_owned() } else { sum }
    }

    fn value(&self, value: &Value) -> String {
        match value {
            Value::Length(quotient) | Value::Rate(quotient) => self.quotient(quotient),
            Value::Angle(angle) => self.angle(angle),
        }
    }

    fn cost(&self, phase: &Phase) -> String {
        let functions = &self.analysis.functions;
        match functions.phases.iter().find(|p| p.set == phase.set) {
            Some(p) => functions.program.cost(&p.accelerations).to_string(),
            None => "solved by loops".to_owned(),
        }
    }

    /// Integer multiples of symbols and of ½π.
    fn angle(&self, angle: &Angle) -> String {
        let mut text = String::new();
        let quarters = angle.quarter_turns();
        let turns = ["", "½π", "π", "−½π"][usize::from(quarters)];
        for &(symbol, k) in angle.terms() {
            let sign = match (text.is_empty(), k < 0) {
                (true, false) => "",
                (true, true) => "−",
                (false, false) => " + ",
                (false, true) => " − ",
            };
            let factor = if k.abs() == 1 { String::new() } else { k.abs().to_string() };
            text = format!("{text}{sign}{factor}{}", self.series(&Series::symbol(symbol)));
        }
        match (text.is_empty(), turns.is_empty()) {
            (true, true) => "0".to_owned(),
            (true, false) => turns.to_owned(),
            (false, true) => text,
            (false, false) => format!("{text} + {turns}"),
        }
    }
}
