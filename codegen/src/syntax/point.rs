//! `#[point(G = AD, at = l / 2)]`, `#[point(G = AD, at = (l / 2, h))]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::options::{self, Options};

/// A named point fixed to a bar.
#[derive(Clone, Debug)]
pub struct PointOnBar {
    /// Its name.
    pub name: Ident,
    /// The bar.
    pub bar: Ident,
    /// Along the bar from its first point, and across it to the left.
    pub at: Vec<Expr>,
}

/// Reads a point.
pub(super) fn parse(input: ParseStream) -> syn::Result<PointOnBar> {
    let name: Ident = input.parse()?;
    input.parse::<Token![=]>()?;
    let bar = input.parse()?;
    let at = Options::parse(input, &["at"])?.require("at", &name)?;
    Ok(PointOnBar { name, bar, at: options::one_or_two(at)? })
}
