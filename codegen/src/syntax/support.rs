//! `#[support(A = floor)]`, `floor(h)`, `wall(x)`, `slope(angle)`, `slope(angle, (x, y))`, `corner(x, y)`.

use proc_macro2::Span;
use syn::parse::{Parse, ParseStream};
use syn::{Expr, Ident, Token};

use super::options::{self, Options};
use super::{Pair, unknown};

/// A one-sided support.
#[derive(Clone, Debug)]
pub struct SupportDeclaration {
    /// Its name.
    pub name: Ident,
    /// What it is.
    pub shape: Shape,
    /// What it is under: a point, or for a corner a bar.
    pub under: Option<Ident>,
    /// The bar that a corner is over.
    pub over: Option<Ident>,
    /// The free side of a wall.
    pub facing: Option<Facing>,
    /// Where its shape is written.
    pub span: Span,
}

/// What carries.
#[derive(Clone, Debug)]
pub enum Shape {
    /// The horizontal at this height, 0 if absent.
    Floor(Option<Expr>),
    /// The vertical at this x.
    Wall(Expr),
    /// The line of this direction through a point, the origin if absent; free to its left.
    Slope(Expr, Option<Pair>),
    /// A corner or peg at a point.
    Corner(Pair),
}

/// The free side of a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Towards −x.
    Left,
    /// Towards +x.
    Right,
}

const SHAPES: [&str; 4] = ["floor", "wall", "slope", "corner"];

/// Reads a support.
pub(super) fn read(input: ParseStream) -> syn::Result<SupportDeclaration> {
    let name = input.parse()?;
    input.parse::<Token![=]>()?;
    let kind: Ident = input.parse()?;
    let shape = shape(&kind, arguments(input)?)?;
    let mut options = Options::read(input, &["under", "over", "facing"])?;
    let under = options.take_name("under")?;
    let over = options.take_name("over")?;
    let facing = options.take_name("facing")?.map(facing).transpose()?;
    let wrong = |text: &str| Err(syn::Error::new(kind.span(), text));
    match (&shape, &under, &over, facing) {
        (Shape::Corner(_), Some(_), None, None) | (Shape::Corner(_), None, Some(_), None) => {}
        (Shape::Corner(_), ..) => return wrong("a corner is either `under = BAR` or `over = BAR`"),
        (_, _, Some(_), _) => return wrong("only a corner can be `over` something"),
        (Shape::Floor(_) | Shape::Slope(..), _, _, Some(_)) => {
            return wrong("only a wall has `facing`");
        }
        _ => {}
    }
    Ok(SupportDeclaration { name, shape, under, over, facing, span: kind.span() })
}

fn arguments(input: ParseStream) -> syn::Result<Vec<Expr>> {
    if !input.peek(syn::token::Paren) {
        return Ok(Vec::new());
    }
    let content;
    syn::parenthesized!(content in input);
    Ok(content.parse_terminated(Expr::parse, Token![,])?.into_iter().collect::<Vec<_>>())
}

fn shape(kind: &Ident, arguments: Vec<Expr>) -> syn::Result<Shape> {
    let wrong = |text: &str| Err(syn::Error::new(kind.span(), text));
    let count = arguments.len();
    let mut arguments = arguments.into_iter();
    match (kind.to_string().as_str(), count, arguments.next(), arguments.next()) {
        ("floor", 0 | 1, height, _) => Ok(Shape::Floor(height)),
        ("wall", 1, Some(x), _) => Ok(Shape::Wall(x)),
        ("slope", 1 | 2, Some(angle), through) => {
            Ok(Shape::Slope(angle, through.map(options::pair).transpose()?))
        }
        ("corner", 2, Some(x), Some(y)) => Ok(Shape::Corner([x, y])),
        ("floor", ..) => wrong("write `floor` or `floor(height)`"),
        ("wall", ..) => wrong("write `wall(x)`"),
        ("slope", ..) => wrong("write `slope(angle)` or `slope(angle, (x, y))`"),
        ("corner", ..) => wrong("write `corner(x, y)`"),
        _ => wrong(&unknown("support of the kind", kind, SHAPES)),
    }
}

fn facing(side: Ident) -> syn::Result<Facing> {
    match side.to_string().as_str() {
        "left" => Ok(Facing::Left),
        "right" => Ok(Facing::Right),
        _ => Err(syn::Error::new(side.span(), "a wall faces `left` or `right`")),
    }
}
