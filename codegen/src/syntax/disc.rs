//! `#[disc(P, r)]`, `#[disc(P, r, on = AB)]`: what a body, or a particle, is about a point of it.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::options::Options;

/// A disc about a point.
#[derive(Clone, Debug)]
pub struct DiscDeclaration {
    /// Its centre.
    pub centre: Ident,
    /// Its radius.
    pub radius: Expr,
    /// The body that it turns with.
    pub on: Option<Ident>,
}

/// Reads a disc.
pub(super) fn read(input: ParseStream) -> syn::Result<DiscDeclaration> {
    let centre = input.parse()?;
    input.parse::<Token![,]>()?;
    let radius = input.parse()?;
    let on = Options::read(input, &["on"])?.take_name("on")?;
    Ok(DiscDeclaration { centre, radius, on })
}
