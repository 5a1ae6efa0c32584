//! The equations of a model as sources of other programs, derived again from the declaration that
//! it carries.

use liftoff_codegen::export;
use liftoff_core::model::Layout;

pub use export::File;

use super::derived;

/// A module of Python with the equations of a model and of its contact sets for SymPy: symbols,
/// matrices and expressions with exact coefficients.
///
/// # Errors
/// The mistakes of a declaration that has any; that the equations of a long system take too much
/// algebra to be written out.
pub fn sympy(layout: &Layout) -> Result<String, String> {
    derived(layout, export::sympy)
}

/// A library of C99 with the functions of a model and of its contact sets: a header, a source and a
/// makefile.
///
/// # Errors
/// The mistakes of a declaration that has any.
pub fn c(layout: &Layout) -> Result<Vec<File>, String> {
    derived(layout, |analysis| Ok(export::c(analysis)))
}
