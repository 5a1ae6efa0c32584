//! `#[spring(AB, stiffness = k, length = l0, damping = c)]`, `#[spring(s = A -> B, …)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::options::Options;
use super::route;
use super::switch::SwitchDeclaration;

/// A spring, a damper or both between two points.
#[derive(Clone, Debug)]
pub struct SpringDeclaration {
    /// Its name.
    pub name: Ident,
    /// Its ends.
    pub ends: [Ident; 2],
    /// Its natural length; 0 if absent.
    pub length: Option<Expr>,
    /// What it resists with.
    pub law: Resistance,
    /// The condition that it acts on.
    pub armed: Option<SwitchDeclaration>,
}

/// Stiffness, damping or both.
#[derive(Clone, Debug)]
pub struct Resistance {
    /// Stiffness.
    pub stiffness: Option<Expr>,
    /// Damping.
    pub damping: Option<Expr>,
}

/// The options that [`Resistance::take`] takes.
pub(super) const RESISTANCE: [&str; 2] = ["stiffness", "damping"];

impl Resistance {
    /// Takes what a spring resists with from its options.
    pub(super) fn take(options: &mut Options, owner: &Ident) -> syn::Result<Self> {
        let [stiffness, damping] = RESISTANCE.map(|name| options.take(name));
        if stiffness.is_none() && damping.is_none() {
            let text =
                format!("spring `{owner}` resists nothing; add `stiffness = …`, `damping = …` or both");
            return Err(syn::Error::new(owner.span(), text));
        }
        Ok(Self { stiffness, damping })
    }
}

/// Reads a spring.
pub(super) fn parse(input: ParseStream) -> syn::Result<SpringDeclaration> {
    let (name, ends) = route::ends("spring", input)?;
    let mut options = Options::parse(input, &[&RESISTANCE[..], &["length", "while"]].concat())?;
    let law = Resistance::take(&mut options, &name)?;
    let armed = options.take_switch();
    Ok(SpringDeclaration { ends, length: options.take("length"), law, armed, name })
}
