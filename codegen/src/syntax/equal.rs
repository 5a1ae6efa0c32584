//! `#[equal(angle(AB), angle(BC))]`, `#[equal(phi_inner, phi_outer)]`; gears,
//! `#[equal(phi, -2 * psi)]`.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Ident, Lit, Token};

use super::coordinate::measured;

/// Angles kept equal.
#[derive(Clone, Debug)]
pub struct EqualAngles {
    /// At least two.
    pub members: Vec<Multiple>,
}

/// One of them, so many times.
#[derive(Clone, Debug)]
pub struct Multiple {
    /// How many times; not 0.
    pub factor: i32,
    /// The angle.
    pub member: Member,
}

/// An angle.
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
pub(super) fn parse(input: ParseStream) -> syn::Result<EqualAngles> {
    let span = input.span();
    let members: Vec<Multiple> =
        Punctuated::<_, Token![,]>::parse_terminated_with(input, multiple)?.into_iter().collect();
    match members.len() {
        0 | 1 => Err(syn::Error::new(span, "expected two angles or more")),
        _ => Ok(EqualAngles { members }),
    }
}

/// The largest multiple.
const MOST: i32 = 64;

fn multiple(input: ParseStream) -> syn::Result<Multiple> {
    let sign = if input.parse::<Option<Token![-]>>()?.is_some() { -1 } else { 1 };
    if !input.peek(Lit) {
        return Ok(Multiple { factor: sign, member: member(input)? });
    }
    let literal: Lit = input.parse()?;
    let text = format!("the multiple of an angle is a whole number from 1 to {MOST}");
    let wrong = || syn::Error::new(literal.span(), text);
    let whole = if let Lit::Int(whole) = &literal { whole.base10_parse::<i32>().ok() } else { None };
    let factor = whole.filter(|k| (1..=MOST).contains(k)).ok_or_else(wrong)?;
    input.parse::<Token![*]>()?;
    Ok(Multiple { factor: sign * factor, member: member(input)? })
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
