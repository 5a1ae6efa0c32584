//! Contact sets in closed form.

use super::Exported;
use super::python::{column, dictionary, matrix, string, tuple};
use crate::algebra::{Quotient, Symbol};
use crate::motion::contains;
use crate::phases::{CoordinateValue, Phase};
use std::collections::BTreeSet;

impl Exported<'_> {
    /// A function for each, and the list of what they return.
    pub(super) fn phases(&self, phases: &[Phase]) -> String {
        let functions = phases.iter().enumerate().map(|(i, phase)| {
            let definitions = self.definitions(&phase.opaque_terms, symbols(phase), "    ");
            format!("\n\ndef _contact_set_{i}():\n{definitions}    return {}\n", self.phase(phase))
        });
        let functions: String = functions.collect();
        let calls: Vec<String> = (0..phases.len()).map(|i| format!("_contact_set_{i}()")).collect();
        format!("{functions}\n\ncontact_sets = [{}]\n", calls.join(", "))
    }

    fn phase(&self, phase: &Phase) -> String {
        let Self { analysis, formulas } = self;
        let contacts = analysis.motion.contacts.iter().enumerate();
        let closed = contacts.filter(|(i, _)| contains(phase.set.closed, *i));
        let label = |i: usize| string(&analysis.motion.contacts[i].label(&analysis.system));
        let sliding = phase.sliding.iter().map(|sliding| label(sliding.contact));
        let quotient = |q: &Quotient| formulas.quotient(q);
        let list = |all: &[Quotient]| column(all.iter().map(quotient));
        let symbols = |of: fn(usize) -> Symbol, which: &[usize]| {
            let symbols: Vec<&str> = which.iter().map(|&i| formulas.symbol(of(i))).collect();
            format!("[{}]", symbols.join(", "))
        };
        let coordinates = phase.coordinates.iter().map(|value| match value {
            CoordinateValue::Length(value) | CoordinateValue::Rate(value) => quotient(value),
            CoordinateValue::Angle(angle) => formulas.angle(angle),
        });
        let mass: Vec<Vec<String>> =
            phase.mass.iter().map(|row| row.iter().map(quotient).collect()).collect();
        let reactions = phase
            .reactions
            .iter()
            .map(|(row, reaction)| (formulas.symbol(Symbol::reaction(*row)).to_owned(), quotient(reaction)));
        let laws = phase.sliding.iter().map(|sliding| {
            let [force, normal, sense] = [
                Symbol::reaction(sliding.row),
                Symbol::reaction(sliding.contact),
                Symbol::Sense(sliding.contact as u16),
            ]
            .map(|symbol| formulas.symbol(symbol).to_owned());
            (force, format!("-{sense}*({})*{normal}", quotient(&sliding.kinetic)))
        });
        let fields = [
            ("closed", tuple(closed.map(|(i, _)| label(i)))),
            ("sliding", tuple(sliding)),
            ("kept", symbols(Symbol::coordinate, &phase.kept)),
            ("moving", symbols(Symbol::acceleration, &phase.moving)),
            ("coordinates", column(coordinates)),
            ("rates", list(&phase.rates)),
            ("accelerations", list(&phase.accelerations)),
            ("kinetic", quotient(&phase.kinetic)),
            ("potential", quotient(&phase.potential)),
            ("mass_matrix", matrix(&mass, phase.moving.len())),
            ("velocity_terms", list(&phase.velocity_terms)),
            ("forces", list(&phase.forces)),
            ("reactions", dictionary(reactions, "        ")),
            ("friction", dictionary(laws, "        ")),
        ];
        let fields: String = fields.map(|(name, value)| format!("        {name}={value},\n")).concat();
        format!("ContactSet(\n{fields}    )")
    }
}

/// Every symbol that the equations of a closed form read.
fn symbols(phase: &Phase) -> BTreeSet<Symbol> {
    let coordinates = phase.coordinates.iter().filter_map(|value| match value {
        CoordinateValue::Length(value) | CoordinateValue::Rate(value) => Some(value),
        CoordinateValue::Angle(_) => None,
    });
    let matrices = phase.mass.iter().flatten().chain(&phase.velocity_terms).chain(&phase.forces);
    let reactions = phase.reactions.iter().map(|(_, reaction)| reaction);
    let laws = phase.sliding.iter().map(|sliding| &sliding.kinetic);
    let quotients = coordinates.chain(matrices).chain(reactions).chain(laws);
    let quotients = quotients.chain(&phase.rates).chain(&phase.accelerations);
    let angles = phase.coordinates.iter().filter_map(|value| match value {
        CoordinateValue::Angle(angle) => Some(angle.terms().iter().map(|(symbol, _)| *symbol)),
        _ => None,
    });
    let angles: BTreeSet<Symbol> = angles.flatten().collect();
    let quotients = quotients.chain([&phase.kinetic, &phase.potential]);
    let factors =
        |q: &Quotient| q.factors().iter().flat_map(|(factor, _)| factor.symbols()).collect::<Vec<_>>();
    quotients.flat_map(|q| q.numerator().symbols().into_iter().chain(factors(q))).chain(angles).collect()
}
