//! The equations as sources of other programs: SymPy's expressions.

mod formula;
mod identifiers;
mod sympy;

use crate::Analysis;
use crate::limits;

/// A module of Python with the equations of `analysis` as SymPy's symbols, matrices and expressions, all coefficients exact.
///
/// # Errors
/// Of a long system that its equations take too much algebra to be written out, or that their coefficients overflow.
pub fn sympy(analysis: &Analysis) -> syn::Result<String> {
    limits::within_work(limits::WORK_OF_TEXT, analysis.system.ident.span(), || sympy::module(analysis))
}

#[cfg(test)]
mod tests;
