//! The equations of a model as sources of other programs, derived again from the declaration that it carries.

use liftoff::model::Layout;
use liftoff_codegen::Analysis;

/// A module of Python with the equations of a model and of its contact sets for SymPy: symbols, matrices and expressions with
/// exact coefficients.
///
/// # Errors
/// The mistakes of a declaration that has any; that the equations of a long system take too much algebra to be written out.
pub fn sympy(layout: &Layout) -> Result<String, String> {
    exported(layout, liftoff_codegen::export::sympy)
}

fn exported<T>(layout: &Layout, export: impl Fn(&Analysis) -> syn::Result<T>) -> Result<T, String> {
    let tokens = layout.declaration.parse().map_err(|mistake| format!("{mistake}"))?;
    liftoff_codegen::analyse(tokens).and_then(|analysis| export(&analysis)).map_err(|error| error.to_string())
}
