//! `#[disc(P, radius = r)]`, `#[disc(P, radius = r, on = AB)]`: what a body, or a particle, is
//! about a point of it.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

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
pub(super) fn parse(input: ParseStream) -> syn::Result<DiscDeclaration> {
    let centre: Ident = input.parse()?;
    let mut options = Options::parse(input, &["radius", "on"])?;
    Ok(DiscDeclaration { radius: options.require("radius", &centre)?, on: options.take_name("on")?, centre })
}
