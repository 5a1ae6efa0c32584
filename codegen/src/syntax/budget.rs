//! `#[budget(flops = 120)]`, `#[budget(flops = 40, on(P, Q))]`.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{Expr, Ident, Token, parenthesized};

use super::options::whole;

/// Most operations that can be allowed.
const MOST: usize = 1 << 30;

/// What right-hand sides may cost.
#[derive(Clone, Debug)]
pub struct Budget {
    /// The most operations.
    pub flops: usize,
    /// The closed supports of the contact set that it is for; for all where there is no list.
    pub on: Option<Vec<Ident>>,
    /// Where the number is written.
    pub span: Span,
}

/// Reads a budget.
pub(super) fn parse(input: ParseStream) -> syn::Result<Budget> {
    let name: Ident = input.parse()?;
    if name != "flops" {
        return Err(syn::Error::new(name.span(), "a budget is a number of operations: `flops = 120`"));
    }
    input.parse::<Token![=]>()?;
    let value: Expr = input.parse()?;
    let (flops, span) = (whole("flops", &value, 1..=MOST)?, value.span());
    let on = if input.parse::<Option<Token![,]>>()?.is_some() && !input.is_empty() {
        Some(supports(input)?)
    } else {
        None
    };
    Ok(Budget { flops, on, span })
}

fn supports(input: ParseStream) -> syn::Result<Vec<Ident>> {
    let name: Ident = input.parse()?;
    if name != "on" {
        return Err(syn::Error::new(
            name.span(),
            "expected the closed supports: `on(P, Q)`, or `on()` for none",
        ));
    }
    let list;
    parenthesized!(list in input);
    Ok(Punctuated::<Ident, Token![,]>::parse_terminated(&list)?.into_iter().collect())
}
