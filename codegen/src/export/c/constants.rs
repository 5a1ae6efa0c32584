//! The function of what parameters alone determine.

use super::Library;
use super::statements::{CInputs, statements};
use super::text::unused;
use crate::algebra::Symbol;
use crate::program::Id;

/// Parameters and senses of sliding.
struct Parameters<'a>(&'a Library<'a>);

impl CInputs for Parameters<'_> {
    fn input(&self, symbol: Symbol) -> String {
        match symbol {
            Symbol::Parameter(i) => format!("p->{}", self.0.names.parameters[usize::from(i)]),
            Symbol::Sense(contact) => format!("senses[{contact}]"),
            other => unreachable!("{other:?} is no parameter"),
        }
    }

    fn constant(&self, _: Id) -> Option<String> {
        None
    }
}

impl Library<'_> {
    pub(super) fn constants_of(&self) -> String {
        let p = &self.names.prefix;
        let ids: Vec<Id> = self.constants.keys().copied().collect();
        let names = self.names.identifiers();
        let written = statements(&self.analysis.functions.program, &ids, &Parameters(self), names);
        let fields = self.constants.values().zip(&written.results);
        let results: String = fields.map(|(field, value)| format!("    k->{field} = {value};\n")).collect();
        let read = [
            ("p", written.reads.iter().any(|symbol| matches!(symbol, Symbol::Parameter(_)))),
            ("senses", written.reads.iter().any(|symbol| matches!(symbol, Symbol::Sense(_)))),
            ("k", !ids.is_empty()),
        ];
        let unread = unused(read.into_iter().filter(|(_, is_read)| !is_read).map(|(name, _)| name));
        format!(
            "void {p}_constants_of(const {p}_parameters *p, const double *senses, {p}_constants *k)\n{{\n{}{results}{unread}}}\n\n",
            written.text
        )
    }
}
