//! `#[bar(AD, mass = m, length = l)]`,
//! `#[bar(shin = knee -> foot, mass = m, length = l, inertia = i, centre = c)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::options::{self, Options};
use super::route;

/// A bar between two points.
#[derive(Clone, Debug)]
pub struct Bar {
    /// Its name.
    pub name: Ident,
    /// Its first point.
    pub from: Ident,
    /// Its last point.
    pub to: Ident,
    /// What it is made of.
    pub mass_properties: MassProperties,
}

/// Mass and its distribution.
#[derive(Clone, Debug)]
pub struct MassProperties {
    /// Mass.
    pub mass: Expr,
    /// Distance between the ends.
    pub length: Expr,
    /// Moment of inertia about the centre of mass; m l²/12 if absent.
    pub inertia: Option<Expr>,
    /// The centre of mass: along the bar from its first point, and across it to the left; the
    /// middle if absent.
    pub centre: Option<Vec<Expr>>,
}

/// The options that [`MassProperties::take`] takes.
pub(super) const MASS_PROPERTIES: [&str; 4] = ["mass", "length", "inertia", "centre"];

impl MassProperties {
    /// Takes the mass properties of `owner` from its options.
    pub(super) fn take(options: &mut Options, owner: &Ident) -> syn::Result<Self> {
        Ok(Self {
            mass: options.require("mass", owner)?,
            length: options.require("length", owner)?,
            inertia: options.take("inertia"),
            centre: options.take("centre").map(options::one_or_two).transpose()?,
        })
    }
}

/// Reads a bar.
pub(super) fn parse(input: ParseStream) -> syn::Result<Bar> {
    let (name, [from, to]) = route::ends("bar", input)?;
    let mass_properties = MassProperties::take(&mut Options::parse(input, &MASS_PROPERTIES)?, &name)?;
    Ok(Bar { name, from, to, mass_properties })
}
