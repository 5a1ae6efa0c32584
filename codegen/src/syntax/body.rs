//! `#[body(hull, points(A = (0, 0), B = (l, 0), C = (a, h)), mass = m, inertia = i, centre = (a,
//! b))]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::options::{self, Options};
use super::{Pair, figure};

/// A rigid body of any shape.
#[derive(Clone, Debug)]
pub struct RigidBody {
    /// Its name.
    pub name: Ident,
    /// Its points, two or more, in its own frame.
    pub points: Vec<(Ident, Pair)>,
    /// Mass.
    pub mass: Expr,
    /// Moment of inertia about the centre of mass.
    pub inertia: Option<Expr>,
    /// The centre of mass in its own frame.
    pub centre: Option<Pair>,
}

/// Reads a body.
pub(super) fn parse(input: ParseStream) -> syn::Result<RigidBody> {
    let name: Ident = input.parse()?;
    let points = points(&name, input)?;
    let mut options = Options::parse(input, &["mass", "inertia", "centre"])?;
    Ok(RigidBody {
        points,
        mass: options.require("mass", &name)?,
        inertia: options.take("inertia"),
        centre: options.take("centre").map(options::pair).transpose()?,
        name,
    })
}

fn points(name: &Ident, input: ParseStream) -> syn::Result<Vec<(Ident, Pair)>> {
    let text = format!("`{name}` needs its points first: `{name}, points(A = (0, 0), B = (l, 0))`");
    let wrong = || syn::Error::new(name.span(), &text);
    input.parse::<Token![,]>().map_err(|_| wrong())?;
    let word: Ident = input.parse().map_err(|_| wrong())?;
    if word != "points" || !input.peek(syn::token::Paren) {
        return Err(syn::Error::new(word.span(), text));
    }
    let content;
    syn::parenthesized!(content in input);
    let points = figure::positions(&content)?;
    match points.len() {
        0 | 1 => Err(syn::Error::new(word.span(), "a body needs two points or more")),
        _ => Ok(points),
    }
}
