//! Names of what depends on parameters alone, and is computed once.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::{Rational, Symbol};
use crate::program::{Id, Operation, Program};
use crate::syntax::plain;
use crate::system::System;

/// What `outputs` use of the parameter-only part of `program`, each with a name of its own; numbers are none of it.
pub(crate) fn constant_names(system: &System, program: &Program, outputs: &[Id]) -> BTreeMap<Id, String> {
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let mut names = BTreeMap::new();
    for id in program.used_constants(outputs).into_iter().filter(|&id| !is_number(program, id)) {
        let readable = readable(system, program, id);
        let numbered = (names.len()..).map(|k| format!("k{k}"));
        let name = readable.into_iter().chain(numbered).find(|name| !taken.contains(name));
        let Some(name) = name else { continue };
        names.insert(id, name.clone());
        taken.insert(name);
    }
    names
}

fn is_number(program: &Program, id: Id) -> bool {
    match program.operation(id) {
        Operation::Ratio(_) | Operation::Pi => true,
        Operation::Input(_) => false,
        operation => operation.operands().all(|a| is_number(program, a)),
    }
}

/// `half_m_l_l` for ½ m l l; nothing for sums and longer products.
fn readable(system: &System, program: &Program, id: Id) -> Option<String> {
    let name = match program.operation(id) {
        Operation::Input(Symbol::Parameter(i)) => plain(system.parameters.get(usize::from(i))?),
        Operation::Mul(a, b) => {
            let (a, b) = if is_number(program, b) { (b, a) } else { (a, b) };
            format!("{}_{}", readable(system, program, a)?, readable(system, program, b)?)
        }
        Operation::Neg(a) => format!("minus_{}", readable(system, program, a)?),
        Operation::Ratio(value) if value.signum() < 0 => format!("minus_{}", number(-value)?),
        Operation::Ratio(value) => number(value)?.to_owned(),
        _ => return None,
    };
    (name.len() <= 24).then_some(name)
}

fn number(value: Rational) -> Option<&'static str> {
    let names = [
        (1, 1, "one"),
        (1, 2, "half"),
        (1, 3, "third"),
        (1, 4, "quarter"),
        (1, 6, "sixth"),
        (1, 12, "twelfth"),
        (2, 3, "two_thirds"),
        (4, 3, "four_thirds"),
        (3, 2, "three_halves"),
        (2, 1, "two"),
        (3, 1, "three"),
        (4, 1, "four"),
    ];
    names.iter().find(|(p, q, _)| value == Rational::new(*p, *q)).map(|(_, _, name)| *name)
}
