//! Outputs with their names in print and their units.

use crate::explain::names::printed;
use liftoff::Trajectory;
use liftoff::expression::si_unit::{SiUnit, unit};
use liftoff::model::{self, Layout};

/// What parameters of a model are measured in, as far as its declaration tells.
pub(crate) struct Quantities {
    layout: &'static Layout,
    parameters: Vec<Option<SiUnit>>,
}

impl Quantities {
    pub fn of(record: &Trajectory) -> Self {
        let layout = record.layout();
        let parameters = layout.dimensions.iter().map(|dimension| dimension.and_then(whole));
        Self { layout, parameters: parameters.collect() }
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

/// None where a power is not whole.
fn whole(dimension: model::Dimension) -> Option<SiUnit> {
    let whole = |n: i8| (n % dimension.denominator == 0).then(|| n / dimension.denominator);
    let [length, time, mass] = dimension.numerators.map(whole);
    Some(SiUnit::new(mass?, length?, time?, 0))
}

/// The energies of a motion, with what it has lost if it may have.
pub(crate) fn energies(record: &Trajectory) -> &'static [&'static str] {
    if record.dissipates() { &["T", "V", "E", "D"] } else { &["T", "V", "E"] }
}

/// An output as it is printed: `phi'` as φ̇.
pub(crate) fn shown(output: &str) -> String {
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
