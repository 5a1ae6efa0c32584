//! The equations as a library of C99: a header, a source and a makefile, which need nothing but the
//! mathematical functions of C.
//!
//! ```text
//! [ M  −Jᵀ ] [ a ]   [  f ]
//! [ J   0  ] [ λ ] = [ −b ]        f = Q − h, over the rows that hold
//! ```
//!
//! - `statements`: operations as statements, a fold over the program; `names`: identifiers of
//!   parameters, states and constants.
//! - `source`: all of the source: `constants`, what parameters alone determine; `function`: a
//!   function of a state; `full`: the equations of the full state; `phases`: functions for each
//!   contact set in closed form.
//! - `header`: what the library has, with units; `text`: comments, strings and lists.
//! - `solve.c`: the equations of any contact set by elimination, whatever the model; `hinges.c`:
//!   with friction in hinges.

mod constants;
mod full;
mod function;
mod header;
mod names;
mod phases;
mod source;
mod statements;
mod text;

use std::collections::BTreeMap;

use super::File;
use crate::Analysis;
use crate::functions::{constant_names, phase_names};
use crate::program::Id;
use names::CNames;

/// A model with the names of its library.
struct Library<'a> {
    analysis: &'a Analysis,
    names: CNames,
    /// The fields of what parameters alone determine.
    constants: BTreeMap<Id, String>,
    /// What the functions of each closed form begin with.
    phases: Vec<String>,
}

/// The files of the library.
pub(super) fn project(analysis: &Analysis) -> Vec<File> {
    let names = CNames::from_analysis(analysis);
    let constants = constant_names(&analysis.system, &analysis.functions.program, &outputs(analysis));
    let mut fields = CNames::fields();
    let constants = constants.into_iter().map(|(id, name)| (id, fields.make_unique(&name))).collect();
    let mut identifiers = CNames::fields();
    let phases = phase_names(analysis).into_iter();
    let phases = phases
        .map(|name| identifiers.make_unique(&name.replacen("On_", "on_", 1).replacen("Free", "free", 1)));
    let phases = phases.map(|name| format!("{}_{name}", names.prefix)).collect();
    let library = Library { analysis, names, constants, phases };
    let prefix = &library.names.prefix;
    let file = |name: String, text: String| File { name, text };
    vec![
        file(format!("{prefix}.h"), library.header()),
        file(format!("{prefix}.c"), library.source()),
        file("Makefile".to_owned(), makefile(prefix)),
    ]
}

fn makefile(prefix: &str) -> String {
    format!(
        "CFLAGS = -std=c99 -O2 -Wall -Wextra -pedantic\n\n\
         lib{prefix}.a: {prefix}.o\n\t$(AR) rcs $@ $^\n\n\
         {prefix}.o: {prefix}.c {prefix}.h\n\n\
         clean:\n\trm -f lib{prefix}.a {prefix}.o\n"
    )
}

/// Everything that the functions of the library compute.
fn outputs(analysis: &Analysis) -> Vec<Id> {
    let functions = &analysis.functions;
    let phases = functions.phases.iter().flat_map(|phase| {
        let motion = phase.rates.iter().chain(&phase.accelerations).chain(&phase.reactions);
        motion.chain(&phase.embedding)
    });
    let full = functions.energy.iter().chain(&functions.points).chain(phases).copied();
    functions.kernel.outputs().into_iter().chain(full).chain(full::hinge_forces(analysis)).collect()
}
