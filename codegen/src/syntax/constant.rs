//! `#[constant(h = l / 2)]`: a name for an expression.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

/// Reads a named constant.
pub(super) fn parse(input: ParseStream) -> syn::Result<(Ident, Expr)> {
    let name = input.parse()?;
    input.parse::<Token![=]>()?;
    Ok((name, input.parse()?))
}
