//! What carries: `floor`, `floor(h)`, `wall(x)`, `slope(angle)`, `slope(angle, (x, y))`, `corner(x, y)`,
//! `circle((x, y), r)`, `bowl((x, y), r)`, `slot(angle, (x, y), w)`, `bar(AB)`, `edge(A, B)`.

use syn::{Expr, Ident};

use super::options;
use super::{Pair, unknown};

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
    /// A circle's centre and radius, free outside.
    Circle(Pair, Expr),
    /// A circle's centre and radius, free inside.
    Bowl(Pair, Expr),
    /// Two parallel lines of this direction, a point midway between them, and how far apart they are.
    Slot(Expr, Box<Pair>, Expr),
    /// A bar, along its length.
    Bar(Ident),
    /// What lies between two points of a body.
    Edge([Ident; 2]),
}

impl Shape {
    /// The bar or points that carry, which move.
    pub fn movers(&self) -> Vec<&Ident> {
        match self {
            Self::Bar(bar) => vec![bar],
            Self::Edge(ends) => ends.iter().collect(),
            _ => Vec::new(),
        }
    }
}

const SHAPES: [&str; 9] = ["floor", "wall", "slope", "corner", "circle", "bowl", "slot", "bar", "edge"];

/// The shape of a kind with its arguments.
pub(super) fn shape(kind: &Ident, arguments: Vec<Expr>) -> syn::Result<Shape> {
    let wrong = |text: &str| Err(syn::Error::new(kind.span(), text));
    let mut arguments = arguments.into_iter();
    let [a, b, c, more] = [(); 4].map(|()| arguments.next());
    match (kind.to_string().as_str(), a, b, c, more) {
        ("floor", height, None, ..) => Ok(Shape::Floor(height)),
        ("wall", Some(x), None, ..) => Ok(Shape::Wall(x)),
        ("slope", Some(angle), through, None, _) => {
            Ok(Shape::Slope(angle, through.map(options::pair).transpose()?))
        }
        ("corner", Some(x), Some(y), None, _) => Ok(Shape::Corner([x, y])),
        ("circle", Some(centre), Some(r), None, _) => Ok(Shape::Circle(options::pair(centre)?, r)),
        ("bowl", Some(centre), Some(r), None, _) => Ok(Shape::Bowl(options::pair(centre)?, r)),
        ("slot", Some(angle), Some(through), Some(width), None) => {
            Ok(Shape::Slot(angle, Box::new(options::pair(through)?), width))
        }
        ("bar", Some(bar), None, ..) => options::identifier(&bar).map(Shape::Bar),
        ("edge", Some(from), Some(to), None, _) => {
            Ok(Shape::Edge([options::identifier(&from)?, options::identifier(&to)?]))
        }
        ("floor", ..) => wrong("write `floor` or `floor(height)`"),
        ("wall", ..) => wrong("write `wall(x)`"),
        ("slope", ..) => wrong("write `slope(angle)` or `slope(angle, (x, y))`"),
        ("corner", ..) => wrong("write `corner(x, y)`"),
        ("circle", ..) => wrong("write `circle((x, y), radius)`"),
        ("bowl", ..) => wrong("write `bowl((x, y), radius)`"),
        ("slot", ..) => wrong("write `slot(angle, (x, y), width)`"),
        ("bar", ..) => wrong("write `bar(AB)`"),
        ("edge", ..) => wrong("write `edge(A, B)` with two points of one body"),
        _ => wrong(&unknown("support of the kind", kind, SHAPES)),
    }
}
