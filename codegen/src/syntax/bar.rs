//! `#[bar(AD, mass = m, length = l)]`, `#[bar(shin = knee -> foot, mass = m, length = l, inertia = i, centre = c)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::options::{self, Options};

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
    pub matter: Matter,
}

/// Mass and its distribution.
#[derive(Clone, Debug)]
pub struct Matter {
    /// Mass.
    pub mass: Expr,
    /// Distance between the ends.
    pub length: Expr,
    /// Moment of inertia about the centre of mass; m l²/12 if absent.
    pub inertia: Option<Expr>,
    /// The centre of mass: along the bar from its first point, and across it to the left; the middle if absent.
    pub centre: Option<Vec<Expr>>,
}

/// The options that [`Matter::take`] takes.
pub(super) const MATTER: [&str; 4] = ["mass", "length", "inertia", "centre"];

impl Matter {
    /// Takes the matter of `owner` from its options.
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
pub(super) fn read(input: ParseStream) -> syn::Result<Bar> {
    let name: Ident = input.parse()?;
    let [from, to] = if input.peek(Token![=]) { ends(input)? } else { letters(&name)? };
    let matter = Matter::take(&mut Options::read(input, &MATTER)?, &name)?;
    Ok(Bar { name, from, to, matter })
}

fn ends(input: ParseStream) -> syn::Result<[Ident; 2]> {
    input.parse::<Token![=]>()?;
    let from = input.parse()?;
    input.parse::<Token![->]>()?;
    Ok([from, input.parse()?])
}

/// `AD` goes from `A` to `D`.
fn letters(name: &Ident) -> syn::Result<[Ident; 2]> {
    let wrong = || {
        let text =
            format!("bar `{name}` needs its ends: `{name} = A -> D`; two letters alone name both ends");
        syn::Error::new(name.span(), text)
    };
    let point = |letter: char| {
        let mut point: Ident = syn::parse_str(&letter.to_string()).map_err(|_| wrong())?;
        point.set_span(name.span());
        Ok(point)
    };
    let letters: Vec<Ident> = name.to_string().chars().map(point).collect::<syn::Result<_>>()?;
    letters.try_into().map_err(|_| wrong())
}
