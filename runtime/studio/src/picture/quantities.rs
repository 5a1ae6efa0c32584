//! Outputs with their names in print and their units.

use super::geometry::Geometry;
use crate::registry::Configuration;
use liftoff::Trajectory;
use liftoff::expression::si_unit::{METRE, SiUnit, unit};
use liftoff::model::Layout;
use liftoff_codegen::algebra::{Series, Symbol, printed};

/// What parameters of a model are measured in, as far as its declaration tells.
pub(super) struct Quantities {
    layout: &'static Layout,
    parameters: Vec<Option<SiUnit>>,
}

const MASS: SiUnit = SiUnit::new(1, 0, 0, 0);
const ACCELERATION: SiUnit = SiUnit::new(0, 1, -2, 0);
const STIFFNESS: SiUnit = SiUnit::new(1, 0, -2, 0);
const DAMPING: SiUnit = SiUnit::new(1, 0, -1, 0);
const TORSION: [SiUnit; 2] = [SiUnit::new(1, 2, -2, -2), SiUnit::new(1, 2, -1, -2)];
const INERTIA: SiUnit = SiUnit::new(1, 2, 0, 0);

impl Quantities {
    pub fn of(record: &Trajectory) -> Self {
        let layout = record.layout();
        let configuration: Configuration = Configuration::of(record, record.interval()[0]);
        let known = Geometry::of(&configuration).map(|geometry| units(&geometry));
        let unknown = || vec![None; layout.parameters.len()];
        Self { layout, parameters: known.unwrap_or_else(|_| unknown()) }
    }

    /// The unit of an output; none if it is not known, empty for a number.
    pub fn unit(&self, output: &str) -> Option<String> {
        unit(output, self.layout, &self.parameters)
    }

    /// The name of an axis: the outputs in print, with their unit.
    pub fn axis(&self, names: &str, unit: Option<&str>) -> String {
        match unit {
            Some(unit) if !unit.is_empty() => format!("{names}, {unit}"),
            _ => names.to_owned(),
        }
    }
}

/// Of parameters that a mass, a length or the like is a multiple of.
fn units(geometry: &Geometry) -> Vec<Option<SiUnit>> {
    let system = &geometry.system;
    let bodies = system.bodies.iter();
    let bodies = bodies.flat_map(|b| [(&b.mass, MASS), (&b.length, METRE), (&b.inertia, INERTIA)]);
    let locals = system.points.iter().flat_map(|p| &p.on).flat_map(|(_, at)| at).map(|x| (x, METRE));
    let particles = system.particles.iter().map(|particle| (&particle.mass, MASS));
    let gravity = system.gravity.iter().flatten().map(|g| (g, ACCELERATION));
    let places = system.figure.iter().flatten().map(|x| (x, METRE));
    let springs = system.springs.iter().flat_map(|spring| {
        let values = [(&spring.stiffness, STIFFNESS), (&spring.damping, DAMPING)];
        values
            .into_iter()
            .filter_map(|(value, d)| Some((value.as_ref()?, d)))
            .chain([(&spring.length, METRE)])
    });
    let torsions = system.torsions.iter().flat_map(|torsion| {
        let values = [(&torsion.stiffness, TORSION[0]), (&torsion.damping, TORSION[1])];
        values.into_iter().filter_map(|(value, d)| Some((value.as_ref()?, d)))
    });
    let sections = system.sections.iter().map(|section| (&section.at, METRE));
    let all: Vec<(&Series, SiUnit)> = bodies
        .chain(locals)
        .chain(particles)
        .chain(gravity)
        .chain(springs)
        .chain(torsions)
        .chain(sections)
        .chain(places)
        .collect();
    (0..geometry.configuration.layout.parameters.len())
        .map(|i| all.iter().find(|(series, _)| is_multiple(series, Symbol::parameter(i))).map(|(_, d)| *d))
        .collect()
}

/// Whether a series is a number times this symbol.
fn is_multiple(series: &Series, symbol: Symbol) -> bool {
    let mut terms = series.terms();
    let only = terms.next().filter(|(term, _)| term.wave.is_one());
    terms.next().is_none() && only.is_some_and(|(term, _)| term.monomial.factors() == [(symbol, 1)])
}

/// An output as it is printed: `phi'` as φ̇.
pub(super) fn shown(output: &str) -> String {
    let mut text = String::new();
    let mut rest = output.trim();
    while let Some(first) = rest.chars().next() {
        let is_name = first.is_alphabetic() || first == '_';
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        if is_name {
            let (name, after) = rest.split_at(end);
            let primes = after.bytes().take_while(|byte| *byte == b'\'').count();
            text.push_str(&printed(name, u8::try_from(primes).unwrap_or(u8::MAX)));
            rest = &after[primes..];
        } else {
            let number = first.is_ascii_digit();
            let (part, after) = rest.split_at(if number { end.max(1) } else { first.len_utf8() });
            text.push_str(&part.replace('-', "−").replace('*', "·"));
            rest = after;
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outputs_are_printed_with_their_letters() {
        for (output, text) in [
            ("phi'", "φ\u{307}"),
            ("phi_inner", "φ_inner"),
            ("N(A, E) / (m1 * g)", "N(A, E) / (m₁ · g)"),
            ("-2.5*omega", "−2.5·ω"),
            ("t", "t"),
        ] {
            assert_eq!(shown(output), text);
        }
    }
}
