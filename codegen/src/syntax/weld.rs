//! `#[weld(AB, CD)]`, `#[weld(AB, CD, angle = a)]`, `#[weld(AB, angle = a)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::options::{self, Options};

/// Directions that keep their difference.
#[derive(Clone, Debug)]
pub struct WeldDeclaration {
    /// The bar that the other is held by, or that keeps its direction.
    pub first: Ident,
    /// The bar that is held.
    pub second: Option<Ident>,
    /// From the first to the second; the figure's if absent.
    pub angle: Option<Expr>,
}

/// Reads a weld.
pub(super) fn parse(input: ParseStream) -> syn::Result<WeldDeclaration> {
    let (first, second) = options::one_or_two_names(input)?;
    let angle = Options::parse(input, &["angle"])?.take("angle");
    if second.is_none() && angle.is_none() {
        let text = format!(
            "what is `{first}` welded to? Name another bar, or the direction it keeps: `{first}, angle = a`"
        );
        return Err(syn::Error::new(first.span(), text));
    }
    Ok(WeldDeclaration { first, second, angle })
}
