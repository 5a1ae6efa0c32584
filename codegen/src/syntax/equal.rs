//! `#[equal(angle(AB), angle(BC))]`, `#[equal(phi_inner, phi_outer)]`.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Ident, Token};

use super::coordinate::measured;

/// Angles kept equal.
#[derive(Clone, Debug)]
pub struct EqualAngles {
    /// At least two.
    pub members: Vec<Member>,
}

/// One of them.
#[derive(Clone, Debug)]
pub enum Member {
    /// The direction of a bar.
    Bar(Ident),
    /// A declared coordinate.
    Coordinate(Ident),
}

impl Member {
    /// Where it is written.
    pub fn span(&self) -> Span {
        match self {
            Self::Bar(name) | Self::Coordinate(name) => name.span(),
        }
    }
}

/// Reads a constraint.
pub(super) fn read(input: ParseStream) -> syn::Result<EqualAngles> {
    let span = input.span();
    let members: Vec<Member> =
        Punctuated::<_, Token![,]>::parse_terminated_with(input, member)?.into_iter().collect();
    match members.len() {
        0 | 1 => Err(syn::Error::new(span, "expected two angles or more")),
        _ => Ok(EqualAngles { members }),
    }
}

fn member(input: ParseStream) -> syn::Result<Member> {
    if !input.peek2(syn::token::Paren) {
        return Ok(Member::Coordinate(input.parse()?));
    }
    let (kind, bar) = measured(input)?;
    match kind == "angle" {
        true => Ok(Member::Bar(bar)),
        false => Err(syn::Error::new(kind.span(), "expected `angle(BAR)` or the name of a coordinate")),
    }
}
