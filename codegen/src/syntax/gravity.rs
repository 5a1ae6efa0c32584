//! `#[gravity(g)]`: downwards; `#[gravity(gx, gy)]`: a vector.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Expr, Token};

use super::options;

/// The acceleration of free fall.
#[derive(Clone, Debug)]
pub struct Gravity {
    /// Its strength downwards, or its two components.
    pub components: Vec<Expr>,
    /// Where it is declared.
    pub span: Span,
}

/// Reads gravity, once.
pub(super) fn parse(input: ParseStream, gravity: &mut Option<Gravity>) -> syn::Result<()> {
    let span = input.span();
    let ahead = input.fork();
    if ahead.parse::<Expr>().is_ok() {
        options::refuse_contact_options(&ahead)?;
    }
    let components: Vec<Expr> = Punctuated::<Expr, Token![,]>::parse_terminated(input)?.into_iter().collect();
    if !(1..=2).contains(&components.len()) {
        return Err(syn::Error::new(span, "gravity is one strength downwards or two components"));
    }
    if gravity.is_some() {
        return Err(syn::Error::new(span, "gravity is declared twice; remove one"));
    }
    *gravity = Some(Gravity { components, span });
    Ok(())
}
