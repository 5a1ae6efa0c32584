//! `#[coordinate(phi = angle(DB), from = horizontal)]`, `#[coordinate(y = -y(D))]`.

use syn::parse::ParseStream;
use syn::{Ident, Token};

use super::options::Options;

/// A generalised coordinate chosen by the user.
#[derive(Clone, Debug)]
pub struct CoordinateDeclaration {
    /// Its name.
    pub name: Ident,
    /// Whether it is counted the other way.
    pub negative: bool,
    /// What it measures.
    pub reading: ReadingDeclaration,
}

/// What a coordinate measures.
#[derive(Clone, Debug)]
pub enum ReadingDeclaration {
    /// The direction of a bar.
    Angle {
        /// The bar.
        bar: Ident,
        /// What it is measured from.
        from: Origin,
    },
    /// The position of a point along x (0) or y (1).
    Position {
        /// The point.
        point: Ident,
        /// 0 or 1.
        axis: usize,
    },
}

/// What an angle is measured from.
#[derive(Clone, Debug)]
pub enum Origin {
    /// An undirected line: 0 for the horizontal, 1 for the vertical; acute and positive in the
    /// figure.
    Line(i64),
    /// A direction, in quarter turns from +x; counter-clockwise.
    Direction(i64),
    /// Another bar; counter-clockwise.
    Bar(Ident),
}

/// Reads a coordinate.
pub(super) fn parse(input: ParseStream) -> syn::Result<CoordinateDeclaration> {
    let name = input.parse()?;
    input.parse::<Token![=]>()?;
    let negative = input.parse::<Option<Token![-]>>()?.is_some();
    let (kind, target) = measured(input)?;
    let from = Options::parse(input, &["from"])?.take_name("from")?;
    let reading = reading(&kind, target, from.as_ref())?;
    let text = "an angle from the horizontal or vertical is positive in the figure; remove the minus or \
                measure it `from = right`, `up`, `left` or `down`";
    match &reading {
        ReadingDeclaration::Angle { from: Origin::Line(_), .. } if negative => {
            Err(syn::Error::new(kind.span(), text))
        }
        _ => Ok(CoordinateDeclaration { name, negative, reading }),
    }
}

fn reading(kind: &Ident, target: Ident, from: Option<&Ident>) -> syn::Result<ReadingDeclaration> {
    let wrong = |at: &Ident, text: &str| Err(syn::Error::new(at.span(), text));
    match (kind.to_string().as_str(), from) {
        ("angle", None) => Ok(ReadingDeclaration::Angle { bar: target, from: Origin::Direction(0) }),
        ("angle", Some(from)) => Ok(ReadingDeclaration::Angle { bar: target, from: origin(from) }),
        ("x" | "y", Some(from)) => wrong(from, "only an angle is measured `from` something"),
        ("x", None) => Ok(ReadingDeclaration::Position { point: target, axis: 0 }),
        ("y", None) => Ok(ReadingDeclaration::Position { point: target, axis: 1 }),
        _ => wrong(kind, "a coordinate is `angle(BAR)`, `x(POINT)` or `y(POINT)`"),
    }
}

/// `angle(DB)`: what is measured, and of what.
pub(super) fn measured(input: ParseStream) -> syn::Result<(Ident, Ident)> {
    let kind = input.parse()?;
    let content;
    syn::parenthesized!(content in input);
    let target = content.parse()?;
    match content.is_empty() {
        true => Ok((kind, target)),
        false => Err(content.error("expected one name")),
    }
}

/// Directions by their quarter turns from +x.
pub(crate) const DIRECTIONS: [&str; 4] = ["right", "up", "left", "down"];

fn origin(from: &Ident) -> Origin {
    let direction = (0..).zip(DIRECTIONS).find(|(_, direction)| from == direction);
    match direction {
        Some((quarters, _)) => Origin::Direction(quarters),
        None if from == "horizontal" => Origin::Line(0),
        None if from == "vertical" => Origin::Line(1),
        None => Origin::Bar(from.clone()),
    }
}
