//! `#[limit(angle(AB, BC), low = a, high = b, restitution = e)]`, `#[limit(elbow = phi, low = a)]`.

use quote::format_ident;
use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::contact_law::{CONTACT_LAW, ContactLaw};
use super::drive::{Target, target};
use super::options::Options;
use super::plain;

/// Bounds of what a drive could prescribe, one-sided.
#[derive(Clone, Debug)]
pub struct LimitDeclaration {
    /// Its name: that of the coordinate, or `AB_BC` of `angle(AB, BC)`, if none is given.
    pub name: Ident,
    /// What is bounded.
    pub target: Target,
    /// The least value.
    pub low: Option<Expr>,
    /// The greatest value.
    pub high: Option<Expr>,
    /// How the bounds act.
    pub contact_law: ContactLaw,
}

/// A bound, a one-sided constraint of its own.
#[derive(Clone, Debug)]
pub struct Bound<'a> {
    /// Its name, `AB_BC_low`.
    pub name: String,
    /// Its value.
    pub value: &'a Expr,
    /// Whether it is the greatest value.
    pub is_upper: bool,
}

impl LimitDeclaration {
    /// Its bounds, the lower first.
    pub fn bounds(&self) -> impl Iterator<Item = Bound<'_>> {
        let sides = [("low", &self.low, false), ("high", &self.high, true)];
        sides.into_iter().filter_map(|(side, value, is_upper)| {
            let name = format!("{}_{side}", plain(&self.name));
            Some(Bound { name, value: value.as_ref()?, is_upper })
        })
    }
}

/// Reads a limit.
pub(super) fn parse(input: ParseStream) -> syn::Result<LimitDeclaration> {
    let name: Option<Ident> = if input.peek2(Token![=]) { Some(input.parse()?) } else { None };
    if name.is_some() {
        input.parse::<Token![=]>()?;
    }
    let target = target(input)?;
    let mut options = Options::with_flags(input, &[&["low", "high"], &CONTACT_LAW[..]].concat(), &["stop"])?;
    let (low, high) = (options.take("low"), options.take("high"));
    if low.is_none() && high.is_none() {
        let text = "a limit has a bound: `low = …`, `high = …` or both";
        return Err(syn::Error::new(target.ident().span(), text));
    }
    Ok(LimitDeclaration {
        name: name.unwrap_or_else(|| own_name(&target)),
        target,
        low,
        high,
        contact_law: ContactLaw::take(&mut options)?,
    })
}

fn own_name(target: &Target) -> Ident {
    match target {
        Target::Coordinate(name) | Target::Angle(name) => name.clone(),
        Target::Position(point, axis) => format_ident!("{}_{point}", ["x", "y"][*axis], span = point.span()),
        Target::Distance([a, b]) | Target::Turn([a, b]) | Target::Along(a, b) => {
            format_ident!("{a}_{b}", span = a.span())
        }
    }
}
