//! Names of what depends on parameters alone, and is computed once.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::{Rational, Symbol};
use crate::program::{Id, Operation, Program};
use crate::syntax::plain;
use crate::system::System;

/// A longer name says less than a number.
const LONGEST: usize = 56;

/// What `outputs` use of the parameter-only part of `program`, each with a name of its own; numbers
/// are none of it, and signs are formed where they are used.
pub(crate) fn constant_names(system: &System, program: &Program, outputs: &[Id]) -> BTreeMap<Id, String> {
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let mut names = BTreeMap::new();
    let unsigned = |id: Id| match program.operation(id) {
        Operation::Neg(positive) => positive,
        _ => id,
    };
    let used: BTreeSet<Id> = program.used_constants(outputs).into_iter().map(unsigned).collect();
    for id in used.into_iter().filter(|&id| !is_number(program, id)) {
        let name = compose_name(system, program, id).filter(|name| name.len() <= LONGEST);
        let numbered = (names.len()..).map(|k| format!("k{k}"));
        let name = name.into_iter().chain(numbered).find(|name| !taken.contains(name));
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

/// `half_m_l_l` for ½ m l l, `m1_plus_two_m2` for m₁ + 2 m₂, `g_over_l` for g / l; a sum in a
/// product or a quotient is the last factor of its side.
fn compose_name(system: &System, program: &Program, id: Id) -> Option<String> {
    let name = |id: Id| compose_name(system, program, id);
    let is_sum = |id: Id| matches!(program.operation(id), Operation::Add(..) | Operation::Sub(..));
    let joined = |a: Id, word: &str, b: Id| Some(format!("{}_{word}_{}", name(a)?, name(b)?));
    match program.operation(id) {
        Operation::Input(Symbol::Parameter(i)) => Some(plain(system.parameters.get(usize::from(i))?)),
        Operation::Mul(a, b) if is_number(program, b) && !is_number(program, a) => {
            product(name(b)?, name(a)?, is_sum(a))
        }
        Operation::Mul(a, b) => match (is_sum(a), is_sum(b)) {
            (true, false) => product(name(b)?, name(a)?, true),
            (_, sum) => product(name(a)?, name(b)?, sum),
        },
        Operation::Add(a, b) if is_negative(program, a) && !is_negative(program, b) => {
            Some(format!("{}_{}", name(b)?, name(a)?))
        }
        Operation::Add(_, b) | Operation::Sub(_, b) if is_sum(b) => None,
        Operation::Add(a, b) if is_negative(program, b) => Some(format!("{}_{}", name(a)?, name(b)?)),
        Operation::Add(a, b) => joined(a, "plus", b),
        Operation::Sub(a, b) => joined(a, "minus", b),
        Operation::Div(a, b) => joined(a, "over", b),
        Operation::Neg(a) => Some(format!("minus_{}", name(a)?)),
        Operation::Ratio(value) => number(value),
        Operation::Sqrt(a) => Some(format!("root_of_{}", name(a)?)),
        Operation::Elementary(function, a) => Some(format!("{}_of_{}", function.name(), name(a)?)),
        _ => None,
    }
}

fn product(a: String, b: String, sum: bool) -> Option<String> {
    Some(if sum { format!("{a}_times_{b}") } else { format!("{a}_{b}") })
}

/// Whether the name begins with `minus`.
fn is_negative(program: &Program, id: Id) -> bool {
    match program.operation(id) {
        Operation::Ratio(value) => value.signum() < 0,
        Operation::Neg(_) => true,
        Operation::Mul(a, b) => is_negative(program, a) || is_negative(program, b),
        _ => false,
    }
}

/// A number in words: `minus_five_thirds`.
fn number(value: Rational) -> Option<String> {
    const WORDS: [&str; 21] = [
        "",
        "one",
        "two",
        "three",
        "four",
        "five",
        "six",
        "seven",
        "eight",
        "nine",
        "ten",
        "eleven",
        "twelve",
        "thirteen",
        "fourteen",
        "fifteen",
        "sixteen",
        "seventeen",
        "eighteen",
        "nineteen",
        "twenty",
    ];
    const PARTS: [(i128, &str); 12] = [
        (3, "third"),
        (4, "quarter"),
        (5, "fifth"),
        (6, "sixth"),
        (7, "seventh"),
        (8, "eighth"),
        (9, "ninth"),
        (10, "tenth"),
        (12, "twelfth"),
        (15, "fifteenth"),
        (16, "sixteenth"),
        (24, "twenty_fourth"),
    ];
    let sign = if value.signum() < 0 { "minus_" } else { "" };
    let above = WORDS.get(usize::try_from(value.numerator().abs()).ok()?).filter(|word| !word.is_empty())?;
    let part = || PARTS.iter().find(|(k, _)| *k == value.denominator()).map(|(_, word)| word);
    Some(match (*above, value.denominator()) {
        (_, 1) => format!("{sign}{above}"),
        ("one", 2) => format!("{sign}half"),
        (_, 2) => format!("{sign}{above}_halves"),
        ("one", _) => format!("{sign}{}", part()?),
        _ => format!("{sign}{above}_{}s", part()?),
    })
}
