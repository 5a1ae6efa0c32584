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
pub(crate) use liftoff_codegen::Unfolded as Halves;
pub use liftoff_codegen::equations_as_html as part;
pub use liftoff_codegen::text::Equations;
pub use liftoff_codegen::{math, text};
use liftoff_interpreter::Interpreted;
use proc_macro2::TokenStream;
use std::sync::Arc;

/// Names in print: Greek letters, indices, dots.
pub mod names {
    pub use liftoff_codegen::algebra::{lettered, printed};
}

/// What is made of the equations of a model.
fn derived<T>(layout: &Layout, make: impl Fn(&Analysis) -> syn::Result<T>) -> Result<T, String> {
    declared(layout, |tokens| make(&liftoff_codegen::analyse(tokens)?))
}

/// What is made of the declaration of a model.
fn declared<T>(layout: &Layout, make: impl Fn(TokenStream) -> syn::Result<T>) -> Result<T, String> {
    let tokens = layout.declaration.parse().map_err(|mistake| format!("{mistake}"))?;
    make(tokens).map_err(|error| error.to_string())
}

/// Both halves of a mirrored model.
pub(crate) fn halves(layout: &Layout) -> Result<Halves, String> {
    declared(layout, Halves::of)
}

/// A compiled model once more, interpreted.
pub(crate) fn interpreted(layout: &Layout) -> Result<Arc<Interpreted>, String> {
    derived(layout, |analysis| Ok(Interpreted::of(analysis)))
}

/// The equations of motion of a model and of its phases in textbook notation: those of the whole system and those of each
/// phase in closed form. As text they are stable, fit for snapshots. In place of a declaration's equations stand its mistakes,
/// if it has any.
pub fn equations(layout: &Layout) -> Equations {
    declared(layout, liftoff_codegen::equations).unwrap_or_else(|mistakes| Equations::missing(&mistakes))
}
