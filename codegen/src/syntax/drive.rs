//! `#[drive(phi = f)]`, `#[drive(angle(AB) = f)]`, `#[drive(x(P) = f)]`, `#[drive(y(P) = f)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::coordinate::measured;
use super::options;

/// A prescribed motion.
#[derive(Clone, Debug)]
pub struct DriveDeclaration {
    /// What is driven.
    pub target: Target,
    /// Its value.
    pub value: Expr,
}

/// What is driven.
#[derive(Clone, Debug)]
pub enum Target {
    /// A declared coordinate.
    Coordinate(Ident),
    /// The direction of a bar.
    Angle(Ident),
    /// The position of a point along x (0) or y (1).
    Position(Ident, usize),
}

impl Target {
    /// The coordinate, bar or point.
    pub fn ident(&self) -> &Ident {
        match self {
            Self::Coordinate(name) | Self::Angle(name) | Self::Position(name, _) => name,
        }
    }
}

/// Reads a drive.
pub(super) fn read(input: ParseStream) -> syn::Result<DriveDeclaration> {
    let target = target(input)?;
    let value = options::assigned(input)?;
    match input.is_empty() {
        true => Ok(DriveDeclaration { target, value }),
        false => Err(input.error("one drive has one value; write another `#[drive(…)]`")),
    }
}

fn target(input: ParseStream) -> syn::Result<Target> {
    if !input.peek2(syn::token::Paren) {
        return input.parse().map(Target::Coordinate);
    }
    let (kind, target) = measured(input)?;
    match kind.to_string().as_str() {
        "angle" => Ok(Target::Angle(target)),
        "x" => Ok(Target::Position(target, 0)),
        "y" => Ok(Target::Position(target, 1)),
        _ => {
            let text = "what is driven is a coordinate, `angle(BAR)`, `x(POINT)` or `y(POINT)`";
            Err(syn::Error::new(kind.span(), text))
        }
    }
}
