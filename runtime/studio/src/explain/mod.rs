//! The equations of a model for people, derived again from the declaration that it carries: as text, as LaTeX and, with
//! feature `report`, as a page.

pub mod conditions;
pub mod export;
pub(crate) mod html;
mod latex;

pub use html::{Drawings, page, phase_page};
pub use latex::{latex, latex_display, phase_latex};
use liftoff::model::Layout;
use liftoff_codegen::Analysis;
pub use liftoff_codegen::equations_as_html as part;
pub use liftoff_codegen::text::Equations;
pub use liftoff_codegen::{math, text};
use liftoff_interpreter::Interpreted;
use std::sync::Arc;

/// Names in print: Greek letters, indices, dots.
pub mod names {
    pub use liftoff_codegen::algebra::{lettered, printed};
}

/// What is made of the equations of a model.
fn derived<T>(layout: &Layout, make: impl Fn(&Analysis) -> syn::Result<T>) -> Result<T, String> {
    let tokens = layout.declaration.parse().map_err(|mistake| format!("{mistake}"))?;
    liftoff_codegen::analyse(tokens).and_then(|analysis| make(&analysis)).map_err(|error| error.to_string())
}

/// A compiled model once more, interpreted.
pub(crate) fn interpreted(layout: &Layout) -> Result<Arc<Interpreted>, String> {
    derived(layout, |analysis| Ok(Interpreted::of(analysis)))
}

/// The equations of motion of a model and of its phases in textbook notation: those of the whole system and those of each
/// phase in closed form. As text they are stable, fit for snapshots. In place of a declaration's equations stand its mistakes,
/// if it has any.
pub fn equations(layout: &Layout) -> Equations {
    let tokens = layout.declaration.parse().map_err(|mistake| format!("{mistake}"));
    let derived = tokens.and_then(|tokens| liftoff_codegen::equations(tokens).map_err(|e| e.to_string()));
    derived.unwrap_or_else(|mistakes| Equations::missing(&mistakes))
}
