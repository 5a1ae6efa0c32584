//! Symbols by their names.

use super::super::Symbol;
use crate::math::{Math, Name};

/// The order of derivative that no opaque term has: it marks products of waves.
pub(super) const PRODUCT: u8 = u8::MAX;

/// The names under which symbols are written; Greek letters are given spelled out.
pub trait SymbolNames {
    /// Parameter `index`, as it is written.
    fn parameter(&self, index: u16) -> Math;
    /// Where parameter `index` stands among the parameters of a product: numbers, masses, `g` and
    /// what else has time in it, lengths.
    fn rank_parameter(&self, _index: u16) -> u8 {
        0
    }
    /// The name of coordinate `index`.
    fn coordinate(&self, index: u16) -> String;
    /// Reaction `index`, as it is written.
    fn reaction(&self, index: u16) -> Math;
    /// The name of opaque term `index`.
    fn opaque_term(&self, index: u16) -> String {
        format!("a{index}")
    }
    /// Product of waves `index`, as [`Shorthand`](super::Shorthand) has it.
    fn product(&self, _index: u16) -> Math {
        Math::ONE
    }
}

/// A name as its letter or word, and what stands lowered beside it: `phi_inner` as φ and inner,
/// `m1` as m and 1.
pub fn lettered(name: &str) -> [String; 2] {
    Name::new(name).lettered()
}

/// The name of a coordinate in print, or of its derivative of this order: `phi` as φ, φ̇, φ̈.
pub fn printed(name: &str, order: u8) -> String {
    Math::Symbol(Name::new(name), order).to_string()
}

/// A symbol as it is written.
pub(super) fn symbol(symbol: Symbol, names: &dyn SymbolNames) -> Math {
    match symbol {
        Symbol::Parameter(i) => names.parameter(i),
        Symbol::Reaction(i) => names.reaction(i),
        Symbol::Coordinate { index, order } => Math::Symbol(Name::new(&names.coordinate(index)), order),
        Symbol::Opaque { index, order: PRODUCT } => names.product(index),
        Symbol::Opaque { index, order } => Math::Symbol(Name::new(&names.opaque_term(index)), order),
        Symbol::Time => Math::symbol("t"),
        Symbol::Sense(_) => Math::symbol("σ"),
        Symbol::Switch(i) => Math::Symbol(Name::new(&format!("s_{}", i + 1)), 0),
    }
}
