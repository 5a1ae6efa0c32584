//! `#[section(S = AB, at = s)]`: where internal forces are asked for.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::options::Options;

/// A section of a bar.
#[derive(Clone, Debug)]
pub struct SectionDeclaration {
    /// Its name.
    pub name: Ident,
    /// The bar.
    pub bar: Ident,
    /// Its distance from the bar's first point.
    pub at: Expr,
}

/// Reads a section.
pub(super) fn parse(input: ParseStream) -> syn::Result<SectionDeclaration> {
    let name = input.parse()?;
    input.parse::<Token![=]>()?;
    let bar = input.parse()?;
    let at = Options::parse(input, &["at"])?.require("at", &name)?;
    Ok(SectionDeclaration { name, bar, at })
}
