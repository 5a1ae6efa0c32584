//! `#[force(P = (fx, fy))]`, `#[force(drag = (fx, fy), at = P)]`, `frame = AB`.

use syn::Ident;
use syn::parse::ParseStream;

use super::Pair;
use super::options::{self, Options};
use super::switch::SwitchDeclaration;

/// A force at a point.
#[derive(Clone, Debug)]
pub struct Force {
    /// Its name.
    pub name: Ident,
    /// The point, if it is not the name.
    pub at: Option<Ident>,
    /// Its components.
    pub value: Pair,
    /// The bar along and across which they are.
    pub frame: Option<Ident>,
    /// The condition that it acts on.
    pub armed: Option<SwitchDeclaration>,
}

/// Reads a force.
pub(super) fn parse(input: ParseStream) -> syn::Result<Force> {
    let name = input.parse()?;
    let value = options::pair(options::assigned(input)?)?;
    let mut options = Options::parse(input, &["at", "frame", "while"])?;
    let armed = options.take_switch();
    Ok(Force { name, at: options.take_name("at")?, value, frame: options.take_name("frame")?, armed })
}
