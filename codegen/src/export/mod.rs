//! The equations as sources of other programs: SymPy's expressions, a library of C.

mod c;
mod formula;
mod identifiers;
mod sympy;

use crate::Analysis;
use crate::limits;

/// A module of Python with the equations of `analysis` as SymPy's symbols, matrices and
/// expressions, all coefficients exact.
///
/// # Errors
/// Of a long system that its equations take too much algebra to be written out, or that their
/// coefficients overflow.
pub fn sympy(analysis: &Analysis) -> syn::Result<String> {
    limits::within_work(limits::WORK_OF_TEXT, analysis.system.ident.span(), || sympy::module(analysis))
}

/// A file of a library.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// Its name, without a folder.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// A library of C99 with the equations of `analysis`: a header, a source and a makefile.
pub fn c(analysis: &Analysis) -> Vec<File> {
    c::project(analysis)
}

#[cfg(test)]
mod tests;
