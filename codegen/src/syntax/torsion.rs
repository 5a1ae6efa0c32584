//! `#[torsion(AB, CD, stiffness = k, angle = a, damping = c)]`, `#[torsion(AB, …)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::options::{self, Options};
use super::spring::{RESISTANCE, Resistance};
use super::switch::SwitchDeclaration;

/// A spring, a damper or both between two directions, or one and the ground's.
#[derive(Clone, Debug)]
pub struct TorsionDeclaration {
    /// The bar that the other is turned from, or the only one.
    pub first: Ident,
    /// The bar that is turned.
    pub second: Option<Ident>,
    /// The angle without torque; 0 if absent.
    pub angle: Option<Expr>,
    /// What it resists with.
    pub law: Resistance,
    /// The condition that it acts on.
    pub armed: Option<SwitchDeclaration>,
}

/// Reads a torsion spring.
pub(super) fn parse(input: ParseStream) -> syn::Result<TorsionDeclaration> {
    let (first, second) = options::one_or_two_names(input)?;
    let mut options = Options::parse(input, &[&RESISTANCE[..], &["angle", "while"]].concat())?;
    let law = Resistance::take(&mut options, &first)?;
    let armed = options.take_switch();
    Ok(TorsionDeclaration { first, second, angle: options.take("angle"), law, armed })
}
