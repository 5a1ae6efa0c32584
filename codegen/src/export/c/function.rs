//! A function of constants and a state.

use std::collections::BTreeSet;

use super::Library;
use super::statements::{CInputs, Statements, statements};
use super::text::unused;
use crate::algebra::Symbol;
use crate::emit::Entries;
use crate::program::Id;

/// What a function of a state reads and writes.
pub(super) struct CFunction<'a> {
    /// Its type and name.
    pub head: String,
    /// What the state has.
    pub entries: Entries<'a>,
    /// What it takes beside constants and state.
    pub takes: &'a str,
    /// What is computed.
    pub outputs: Vec<Id>,
    /// Where each of it goes.
    pub places: Vec<String>,
    /// The function of the derivative of the state, where accelerations are read of that.
    pub derivative: Option<String>,
    /// Statements before and behind.
    pub around: [String; 2],
}

/// The name in a declaration, `double *out`.
fn last_word(declaration: &str) -> &str {
    declaration.rsplit([' ', '*']).next().unwrap_or_default()
}

/// Places `out[0]`, `out[1]`, …
pub(super) fn places(count: usize) -> Vec<String> {
    (0..count).map(|i| format!("out[{i}]")).collect()
}

impl CInputs for Library<'_> {
    fn input(&self, symbol: Symbol) -> String {
        self.names.inputs[&symbol].clone()
    }

    fn constant(&self, id: Id) -> Option<String> {
        self.constants.get(&id).map(|name| format!("k->{name}"))
    }
}

impl Library<'_> {
    /// The definition of a function.
    pub(super) fn function(&self, function: &CFunction<'_>) -> String {
        let p = &self.names.prefix;
        let program = &self.analysis.functions.program;
        let Statements { text, results, reads } =
            statements(program, &function.outputs, self, self.names.identifiers());
        let bound = self.bound(function, &reads);
        let assigned = function.places.iter().zip(results);
        let assigned: String = assigned.map(|(place, value)| format!("    {place} = {value};\n")).collect();
        let [before, behind] = &function.around;
        let body = format!("{before}{bound}{text}{assigned}{behind}");
        let is_read = |name: &str| {
            [" ", "(", "-", "!"].iter().any(|before| {
                [")", "[", "->", ","].iter().any(|behind| body.contains(&format!("{before}{name}{behind}")))
            })
        };
        let taken = ["k", "state"].into_iter().chain(function.takes.split(", ").map(last_word));
        let unread = unused(taken.filter(|name| !is_read(name)));
        let (head, takes) = (&function.head, function.takes);
        format!("{head}(const {p}_constants *k, const double *state, {takes})\n{{\n{body}{unread}}}\n\n")
    }

    /// Variables for the entries of a state that are read, and for its accelerations.
    fn bound(&self, function: &CFunction<'_>, reads: &BTreeSet<Symbol>) -> String {
        let line = |(i, symbol): (usize, Symbol), from: &str| {
            let name = self.names.inputs.get(&symbol).filter(|_| reads.contains(&symbol));
            name.map_or(String::new(), |name| format!("    const double {name} = {from}[{i}];\n"))
        };
        let is_acceleration = |symbol: &Symbol| matches!(symbol, Symbol::Coordinate { order: 2, .. });
        let entries = function.entries;
        let state: String = entries.symbols(1).enumerate().map(|entry| line(entry, "state")).collect();
        let slopes = entries.symbols(2).enumerate().filter(|(_, symbol)| is_acceleration(symbol));
        let Some(derivative) = &function.derivative else {
            let given = slopes.map(|(i, symbol)| line((i - entries.kept.len(), symbol), "acceleration"));
            return state + &given.collect::<String>();
        };
        let slopes: String = slopes.map(|entry| line(entry, "rates")).collect();
        match slopes.is_empty() {
            true => state,
            false => {
                let size = entries.len();
                // Declarations may follow statements in C99.
                format!("    double rates[{size}];\n{state}    {derivative}(k, state, rates);\n{slopes}")
            }
        }
    }
}
