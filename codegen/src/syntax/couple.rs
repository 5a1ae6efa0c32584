//! `#[couple(AB = c)]`, `#[couple(motor = c, on = AB, from = CD)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::options::{self, Options};
use super::switch::SwitchDeclaration;

/// A couple on a bar.
#[derive(Clone, Debug)]
pub struct Couple {
    /// Its name.
    pub name: Ident,
    /// The bar, if it is not the name.
    pub on: Option<Ident>,
    /// The bar that bears the opposite; the ground if absent.
    pub from: Option<Ident>,
    /// Its value, counter-clockwise.
    pub value: Expr,
    /// The condition that it acts on.
    pub armed: Option<SwitchDeclaration>,
}

/// Reads a couple.
pub(super) fn parse(input: ParseStream) -> syn::Result<Couple> {
    let name = input.parse()?;
    let value = options::assigned(input)?;
    let mut options = Options::parse(input, &["on", "from", "while"])?;
    let armed = options.take_switch();
    Ok(Couple { name, on: options.take_name("on")?, from: options.take_name("from")?, value, armed })
}
