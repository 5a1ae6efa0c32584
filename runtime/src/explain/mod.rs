//! The equations of a model for people, derived again from the declaration that it carries: as text, as LaTeX and, with
//! feature `report`, as a page.

#[cfg(feature = "report")]
pub(crate) mod html;
mod latex;
#[cfg(feature = "cli")]
pub(crate) mod source;

use crate::model::{BarSystem, Layout};
use liftoff_codegen::text::Equations;

#[cfg(feature = "report")]
pub use html::{Drawings, page, phase_page};
pub use latex::{latex, phase_latex};
pub use liftoff_codegen::{math, text};

/// The equations of motion of `M` and of its phases in textbook notation; a stable text, fit for snapshots.
pub fn equations<M: BarSystem>() -> String {
    M::LAYOUT.explain().to_string()
}

impl Layout {
    /// The equations of the whole system and those of each phase in closed form. In place of a declaration's equations
    /// stand its mistakes, if it has any.
    pub fn explain(&self) -> Equations {
        let tokens = self.declaration.parse().map_err(|mistake| format!("{mistake}"));
        let derived = tokens.and_then(|tokens| liftoff_codegen::equations(tokens).map_err(|e| e.to_string()));
        derived.unwrap_or_else(|mistakes| Equations::missing(&mistakes))
    }
}
