//! Contradictions in a mechanic's words.

use syn::Expr;

use super::Dimension;
use super::equation::{DimensionEquation, Reason};
use super::name::name;
use super::solution::{Conflict, EchelonForm};

/// So many places that an equation contradicts are told.
const TOLD: usize = 3;

/// What is wrong with an equation that contradicts others.
pub(super) fn contradiction(
    equations: &[DimensionEquation],
    equation: &DimensionEquation,
    conflict: &Conflict,
    solution: &EchelonForm,
) -> String {
    let subject = subject(equation.at);
    let places = places(equations, conflict);
    let is = |needed: Dimension| {
        let is: Dimension = core::array::from_fn(|b| needed[b] + conflict.rest[b]);
        name(is)
    };
    match &equation.reason {
        Reason::Needed(needed) => {
            format!("{subject} is {} here, but {}{places}", name(*needed), is(*needed))
        }
        Reason::Added(to) => match solution.value(to) {
            Some(to) => format!("{subject} is added to {} here, but is {}{places}", name(to), is(to)),
            None => format!("{subject} is added to what has another dimension{places}"),
        },
    }
}

/// `l`, or what the message stands at.
fn subject(expr: &Expr) -> String {
    match expr {
        Expr::Path(path) => {
            path.path.get_ident().map_or_else(|| "this".to_owned(), |name| format!("`{name}`"))
        }
        Expr::Paren(inner) => subject(&inner.expr),
        Expr::Group(inner) => subject(&inner.expr),
        _ => "this".to_owned(),
    }
}

/// ` by the mass of AB, gravity`; nothing where an equation contradicts itself.
fn places(equations: &[DimensionEquation], conflict: &Conflict) -> String {
    let mut places: Vec<String> = Vec::new();
    for equation in conflict.with.iter().filter_map(|&i| equations.get(i)) {
        let place = equation.place.to_string();
        if !places.contains(&place) {
            places.push(place);
        }
    }
    let more = if places.len() > TOLD { ", …" } else { "" };
    places.truncate(TOLD);
    match places.is_empty() {
        true => String::new(),
        false => format!(" by {}{more}", places.join(", ")),
    }
}
