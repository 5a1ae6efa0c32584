//! Identifiers of all symbols, and the lines that declare them.

use super::python::{RESERVED, bracketed, string};
use crate::Analysis;
use crate::algebra::Symbol;
use crate::export::formula::Formulas;
use crate::export::identifiers::Identifiers;
use crate::syntax::plain;
use crate::system::Definition;
use crate::text::TextWriter;

/// The names, and the lines.
pub(super) fn names(analysis: &Analysis) -> (Formulas, String) {
    let mut naming = Naming {
        analysis,
        identifiers: Identifiers::new(RESERVED),
        formulas: Formulas::default(),
        text: String::new(),
    };
    naming.parameters();
    naming.coordinates();
    naming.multipliers();
    naming.switches();
    naming.constants();
    naming.opaque_terms();
    (naming.formulas, naming.text)
}

struct Naming<'a> {
    analysis: &'a Analysis,
    identifiers: Identifiers,
    formulas: Formulas,
    text: String,
}

impl Naming<'_> {
    fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    /// A line that declares a real symbol.
    fn symbol(&mut self, symbol: Symbol, name: &str, meaning: &str) -> String {
        let identifier = self.identifiers.make_unique(name);
        let comment = if meaning.is_empty() { String::new() } else { format!("  # {}", one_line(meaning)) };
        self.line(&format!("{identifier} = Symbol({}, real=True){comment}", string(&identifier)));
        self.formulas.name(symbol, identifier.clone());
        identifier
    }

    fn parameters(&mut self) {
        let system = &self.analysis.system;
        self.line("# Parameters.");
        let all: Vec<String> = system
            .parameters
            .iter()
            .zip(&system.meanings)
            .enumerate()
            .map(|(i, (name, meaning))| self.symbol(Symbol::parameter(i), &plain(name), meaning))
            .collect();
        self.line(&format!("parameters = [{}]\n", all.join(", ")));
    }

    fn coordinates(&mut self) {
        let writer = TextWriter::new(self.analysis);
        self.line("# Time, coordinates, their first and second derivatives.");
        self.symbol(Symbol::Time, "t", "");
        for (order, list, suffix) in [(0, "coordinates", ""), (1, "rates", "_d"), (2, "accelerations", "_dd")]
        {
            let coordinates = self.analysis.kinematics.coordinates.iter().enumerate();
            let all: Vec<String> = coordinates
                .map(|(i, coordinate)| {
                    let meaning =
                        if order == 0 { writer.meaning(&coordinate.reading) } else { String::new() };
                    let symbol = Symbol::Coordinate { index: i as u16, order };
                    self.symbol(symbol, &format!("{}{suffix}", coordinate.name), &meaning)
                })
                .collect();
            self.line(&format!("{list} = [{}]\n", all.join(", ")));
        }
    }

    fn multipliers(&mut self) {
        let Analysis { system, kinematics, motion, .. } = self.analysis;
        if motion.rows.is_empty() {
            return;
        }
        self.line("# Reactions N and R of contacts, forces of joints; senses of sliding.");
        for (i, contact) in motion.contacts.iter().enumerate() {
            self.symbol(Symbol::reaction(i), &format!("N_{}", contact.label(system)), "");
        }
        for (i, joint) in kinematics.joints.iter().enumerate() {
            let row = motion.contacts.len() + i;
            self.symbol(Symbol::reaction(row), &format!("force_{}", joint.name), "");
        }
        for (i, &contact) in motion.tangents.iter().enumerate() {
            let label = motion.contacts[contact].label(system);
            self.symbol(Symbol::reaction(motion.slips() + i), &format!("R_{label}"), "");
        }
        for (contact, _) in motion.frictions() {
            let label = motion.contacts[contact].label(system);
            let meaning = "1 where it slides along its tangent, -1 where against it";
            self.symbol(Symbol::Sense(contact as u16), &format!("sigma_{label}"), meaning);
        }
        self.line("");
    }

    fn switches(&mut self) {
        let system = &self.analysis.system;
        for (i, switch) in system.switches.iter().enumerate() {
            let meaning = format!("1 while {}, else 0", switch.condition);
            self.symbol(Symbol::Switch(i as u16), &format!("switch_{}", i + 1), &meaning);
        }
    }

    /// What is derived of parameters alone.
    fn constants(&mut self) {
        let system = &self.analysis.system;
        for (i, definition) in system.constants.iter().enumerate() {
            let identifier = self.identifiers.make_unique(&format!("constant_{}", i + 1));
            let value = match definition {
                _ if definition.is_pi() => "pi".to_owned(),
                Definition::Sqrt(square) => format!("sqrt({})", self.formulas.series(square)),
                Definition::Ratio(a, b) => {
                    format!("({})/({})", self.formulas.series(a), self.formulas.series(b))
                }
            };
            self.line(&format!("{identifier} = {}", bracketed(&value)));
            self.formulas.name(Symbol::parameter(system.parameters.len() + i), identifier);
        }
    }

    fn opaque_terms(&mut self) {
        for (i, term) in self.analysis.motion.opaque_terms.iter().enumerate() {
            for order in 0..term.orders.len() {
                let name = format!("{}_{}", term.name, "d".repeat(order));
                let identifier = self.identifiers.make_unique(&name);
                self.formulas.name(Symbol::Opaque { index: i as u16, order: order as u8 }, identifier);
            }
        }
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
