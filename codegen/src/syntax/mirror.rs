//! `#[mirror(x = 0)]`, `#[mirror(y = h, swap(A, E), swap(B, D))]`.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

/// A line of mirror symmetry.
#[derive(Clone, Debug)]
pub struct MirrorLine {
    /// 0 for the line x = at, 1 for y = at.
    pub axis: usize,
    /// Where it lies.
    pub at: Expr,
    /// Points given as images of each other.
    pub swaps: Vec<[Ident; 2]>,
    /// Where it is declared.
    pub span: Span,
}

/// Reads the mirror, once.
pub(super) fn parse(input: ParseStream, mirror: &mut Option<MirrorLine>) -> syn::Result<()> {
    let name: Ident = input.parse()?;
    let axis = match name.to_string().as_str() {
        "x" => 0,
        "y" => 1,
        _ => {
            return Err(syn::Error::new(name.span(), "a mirror is the line `x = …` or `y = …`"));
        }
    };
    input.parse::<Token![=]>()?;
    let at = input.parse()?;
    let mut swaps = Vec::new();
    while !input.is_empty() {
        input.parse::<Token![,]>()?;
        if !input.is_empty() {
            swaps.push(swap(input)?);
        }
    }
    if mirror.is_some() {
        return Err(syn::Error::new(name.span(), "the mirror is declared twice; remove one"));
    }
    *mirror = Some(MirrorLine { axis, at, swaps, span: name.span() });
    Ok(())
}

fn swap(input: ParseStream) -> syn::Result<[Ident; 2]> {
    let word: Ident = input.parse()?;
    if word != "swap" {
        return Err(syn::Error::new(word.span(), "expected `swap(A, E)`: two points that exchange places"));
    }
    let content;
    syn::parenthesized!(content in input);
    let first = content.parse()?;
    content.parse::<Token![,]>()?;
    let second = content.parse()?;
    match content.is_empty() {
        true => Ok([first, second]),
        false => Err(content.error("expected two points")),
    }
}
