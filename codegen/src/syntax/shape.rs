//! What carries: `floor`, `floor(h)`, `wall(x)`, `slope(angle)`, `slope(angle, (x, y))`,
//! `corner(x, y)`, `circle((x, y), r)`, `bowl((x, y), r)`, `slot(angle, (x, y), w)`, `bar(AB)`,
//! `edge(A, B)`, `disc(Q)`; the centre of a circle or bowl may be a point, `circle(Q, r)`.

use syn::{Expr, Ident};

use super::options;
use super::{Pair, unknown};

/// What carries.
#[derive(Clone, Debug)]
pub enum ShapeDeclaration {
    /// The horizontal at this height, 0 if absent.
    Floor(Option<Expr>),
    /// The vertical at this x.
    Wall(Expr),
    /// The line of this direction through a point, the origin if absent; free to its left.
    Slope(Expr, Option<Box<Pair>>),
    /// A corner or peg at a point.
    Corner(Pair),
    /// A circle's centre and radius, free outside.
    Circle(CentreDeclaration, Expr),
    /// A circle's centre and radius, free inside.
    Bowl(CentreDeclaration, Expr),
    /// Two parallel lines of this direction, a point midway between them, and how far apart they
    /// are.
    Slot(Expr, Box<Pair>, Expr),
    /// A bar, along its length.
    Bar(Ident),
    /// What lies between two points of a body.
    Edge([Ident; 2]),
    /// The disc about a point.
    Disc(Ident),
}

/// The centre of a circle.
#[derive(Clone, Debug)]
pub enum CentreDeclaration {
    /// A place of the ground.
    Ground(Box<Pair>),
    /// A point.
    Point(Ident),
}

impl ShapeDeclaration {
    /// The bar or the points that carry.
    pub fn movers(&self) -> Vec<&Ident> {
        match self {
            Self::Bar(name) | Self::Disc(name) => vec![name],
            Self::Circle(CentreDeclaration::Point(centre), _)
            | Self::Bowl(CentreDeclaration::Point(centre), _) => vec![centre],
            Self::Edge(ends) => ends.iter().collect(),
            _ => Vec::new(),
        }
    }
}

const SHAPES: [&str; 10] =
    ["floor", "wall", "slope", "corner", "circle", "bowl", "slot", "bar", "edge", "disc"];

/// The shape of a kind with its arguments.
pub(super) fn shape(kind: &Ident, arguments: Vec<Expr>) -> syn::Result<ShapeDeclaration> {
    let wrong = |text: &str| Err(syn::Error::new(kind.span(), text));
    let mut arguments = arguments.into_iter();
    let [a, b, c, more] = [(); 4].map(|()| arguments.next());
    match (kind.to_string().as_str(), a, b, c, more) {
        ("floor", height, None, ..) => Ok(ShapeDeclaration::Floor(height)),
        ("wall", Some(x), None, ..) => Ok(ShapeDeclaration::Wall(x)),
        ("slope", Some(angle), through, None, _) => {
            Ok(ShapeDeclaration::Slope(angle, through.map(options::pair).transpose()?.map(Box::new)))
        }
        ("corner", Some(x), Some(y), None, _) => Ok(ShapeDeclaration::Corner([x, y])),
        ("circle", Some(centre), Some(r), None, _) => Ok(ShapeDeclaration::Circle(self::centre(centre)?, r)),
        ("bowl", Some(centre), Some(r), None, _) => Ok(ShapeDeclaration::Bowl(self::centre(centre)?, r)),
        ("slot", Some(angle), Some(through), Some(width), None) => {
            Ok(ShapeDeclaration::Slot(angle, Box::new(options::pair(through)?), width))
        }
        ("bar", Some(bar), None, ..) => options::identifier(&bar).map(ShapeDeclaration::Bar),
        ("disc", Some(centre), None, ..) => options::identifier(&centre).map(ShapeDeclaration::Disc),
        ("edge", Some(from), Some(to), None, _) => {
            Ok(ShapeDeclaration::Edge([options::identifier(&from)?, options::identifier(&to)?]))
        }
        ("floor", ..) => wrong("write `floor` or `floor(height)`"),
        ("wall", ..) => wrong("write `wall(x)`"),
        ("slope", ..) => wrong("write `slope(angle)` or `slope(angle, (x, y))`"),
        ("corner", ..) => wrong("write `corner(x, y)`"),
        ("circle", ..) => wrong("write `circle((x, y), radius)` or `circle(POINT, radius)`"),
        ("bowl", ..) => wrong("write `bowl((x, y), radius)` or `bowl(POINT, radius)`"),
        ("slot", ..) => wrong("write `slot(angle, (x, y), width)`"),
        ("bar", ..) => wrong("write `bar(AB)`"),
        ("disc", ..) => {
            wrong("write `disc(POINT)`, about which there is a `#[disc(POINT, radius = radius)]`")
        }
        ("edge", ..) => wrong("write `edge(A, B)` with two points of one body"),
        _ => wrong(&unknown("support of the kind", kind, SHAPES)),
    }
}

/// `(x, y)` or the name of a point.
fn centre(value: Expr) -> syn::Result<CentreDeclaration> {
    match options::identifier(&value) {
        Ok(point) => Ok(CentreDeclaration::Point(point)),
        Err(_) => options::pair(value).map(|pair| CentreDeclaration::Ground(Box::new(pair))),
    }
}
