//! Exports a model's equations as source text, derived again from its declaration.

use liftoff_codegen::export;
use liftoff_core::model::Layout;

pub use export::File;

use super::derived;

/// A module of Python with the equations of a model and of its contact sets for SymPy: symbols,
/// matrices and expressions with exact coefficients.
///
/// # Errors The mistakes in the declaration, or that writing out the equations of a long system
/// takes too much algebra.
pub fn sympy(layout: &Layout) -> Result<String, String> {
    derived(layout, export::sympy)
}

/// A library of C99 with the functions of a model and of its contact sets: a header, a source and a
/// makefile.
///
/// # Errors The mistakes in the declaration.
pub fn c(layout: &Layout) -> Result<Vec<File>, String> {
    derived(layout, |analysis| Ok(export::c(analysis)))
}
