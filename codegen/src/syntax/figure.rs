//! Positions of points: `#[figure(D = (0, 0), A = (-l, 0))]`, `#[pin(O = (0, 0))]`.

use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Ident, Token};

use super::{Pair, options};

/// Reads `point = (x, y)`, separated by commas.
pub(super) fn positions(input: ParseStream) -> syn::Result<Vec<(Ident, Pair)>> {
    if input.is_empty() {
        return Err(input.error("expected a point and its position"));
    }
    Ok(Punctuated::<_, Token![,]>::parse_terminated_with(input, position)?.into_iter().collect())
}

/// Reads one of them.
pub(super) fn position(input: ParseStream) -> syn::Result<(Ident, Pair)> {
    let name = input.parse()?;
    input.parse::<Token![=]>()?;
    Ok((name, options::pair(input.parse()?)?))
}
