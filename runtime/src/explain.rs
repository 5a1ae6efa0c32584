//! Equations as text, derived again from the declaration that the model carries.

use crate::model::{BarSystem, Layout};
use liftoff_codegen::Equations;

/// The equations of motion of `M` and of its phases in textbook notation; a stable text, fit for snapshots.
pub fn equations<M: BarSystem>() -> String {
    M::LAYOUT.explain().to_string()
}

impl Layout {
    /// The equations of the whole system and those of each phase in closed form, in textbook notation; a phase is
    /// named by its closed supports joined by commas (`A, E`; empty when free). In place of a declaration's equations
    /// stand its mistakes, if it has any.
    pub fn explain(&self) -> Equations {
        let tokens = self.declaration.parse().map_err(|mistake| format!("{mistake}"));
        let derived = tokens.and_then(|tokens| liftoff_codegen::equations(tokens).map_err(|e| e.to_string()));
        derived.unwrap_or_else(|mistakes| Equations { system: mistakes, phases: Vec::new() })
    }
}
