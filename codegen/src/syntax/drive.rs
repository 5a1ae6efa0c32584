//! `#[drive(phi = f)]`, `#[drive(angle(AB) = f)]`, `#[drive(x(P) = f)]`, `#[drive(y(P) = f)]`, and
//! relative motions, `#[drive(distance(A, B) = f)]`, `#[drive(angle(AB, BC) = f)]`,
//! `#[drive(along(P, AB) = f)]`; `while("…")`,
//! `breaks("…")`.

use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Expr, Ident, Token};

use super::options::{self, CONDITIONS, Options};
use super::switch::SwitchDeclaration;

/// A prescribed motion.
#[derive(Clone, Debug)]
pub struct DriveDeclaration {
    /// What is driven.
    pub target: Target,
    /// Its value.
    pub value: Expr,
    /// The condition that it is there on.
    pub armed: Option<SwitchDeclaration>,
    /// The condition that ends it.
    pub breaks: Option<SwitchDeclaration>,
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
    /// The distance of two points.
    Distance([Ident; 2]),
    /// The direction of the second bar less that of the first.
    Turn([Ident; 2]),
    /// How far a point is along a bar.
    Along(Ident, Ident),
}

impl Target {
    /// The coordinate, or the bars and points.
    pub fn idents(&self) -> Vec<&Ident> {
        match self {
            Self::Coordinate(name) | Self::Angle(name) | Self::Position(name, _) => vec![name],
            Self::Distance(names) | Self::Turn(names) => names.iter().collect(),
            Self::Along(point, bar) => vec![point, bar],
        }
    }

    /// The first of them.
    pub fn ident(&self) -> &Ident {
        match self {
            Self::Coordinate(name) | Self::Angle(name) | Self::Position(name, _) => name,
            Self::Distance([name, _]) | Self::Turn([name, _]) | Self::Along(name, _) => name,
        }
    }
}

/// Reads a drive.
pub(super) fn parse(input: ParseStream) -> syn::Result<DriveDeclaration> {
    let target = target(input)?;
    let value = options::assigned(input)?;
    if !options::is_condition_ahead(input) {
        options::refuse_contact_options(input)?;
        if input.peek(Token![,]) {
            return Err(input.error("one drive has one value; write another `#[drive(…)]`"));
        }
    }
    let mut options = Options::parse(input, &CONDITIONS)?;
    let (armed, breaks) = (options.take_switch(), options.take_break());
    Ok(DriveDeclaration { target, value, armed, breaks })
}

/// Reads what is driven, or bounded.
pub(super) fn target(input: ParseStream) -> syn::Result<Target> {
    if !input.peek2(syn::token::Paren) {
        return input.parse().map(Target::Coordinate);
    }
    let kind: Ident = input.parse()?;
    let content;
    syn::parenthesized!(content in input);
    let mut names = Punctuated::<Ident, Token![,]>::parse_terminated(&content)?.into_iter();
    let wrong = |text: &str| Err(syn::Error::new(kind.span(), text));
    match (kind.to_string().as_str(), names.next(), names.next(), names.next()) {
        ("angle", Some(bar), None, _) => Ok(Target::Angle(bar)),
        ("angle", Some(from), Some(bar), None) => Ok(Target::Turn([from, bar])),
        ("x", Some(point), None, _) => Ok(Target::Position(point, 0)),
        ("y", Some(point), None, _) => Ok(Target::Position(point, 1)),
        ("distance", Some(a), Some(b), None) => Ok(Target::Distance([a, b])),
        ("along", Some(point), Some(bar), None) => Ok(Target::Along(point, bar)),
        ("angle", ..) => {
            wrong("write `angle(BAR)`, or `angle(BAR, BAR)` for the angle from the first to the second")
        }
        ("distance", ..) => wrong("write `distance(POINT, POINT)`"),
        ("along", ..) => wrong("write `along(POINT, BAR)`"),
        _ => wrong(
            "what is driven or bounded is a coordinate, `angle(BAR)`, `angle(BAR, BAR)`, `x(POINT)`, `y(POINT)`, `distance(POINT, POINT)` or \
             `along(POINT, BAR)`",
        ),
    }
}
