//! `#[mass(P, m)]`: a mass at a point.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::options;

/// A mass at a point.
#[derive(Clone, Debug)]
pub struct PointMass {
    /// The point.
    pub point: Ident,
    /// The mass.
    pub mass: Expr,
}

/// Reads a point mass.
pub(super) fn parse(input: ParseStream) -> syn::Result<PointMass> {
    let point = input.parse()?;
    input.parse::<Token![,]>()?;
    let mass = input.parse()?;
    options::refuse_contact_options(input)?;
    Ok(PointMass { point, mass })
}
