//! `#[support(A = floor)]`, `#[support(heel = wall(0), under = A, facing = right, rough,
//! restitution = e)]`.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::contact_law::{CONTACT_LAW, ContactLaw, FRICTION};
use super::options::{self, Options};
use super::shape::{ShapeDeclaration, shape};
use super::{nearest, plain};

/// A one-sided support.
#[derive(Clone, Debug)]
pub struct SupportDeclaration {
    /// Its name.
    pub name: Ident,
    /// What it is.
    pub shape: ShapeDeclaration,
    /// What it is under: a point, or for a corner a bar.
    pub under: Option<Ident>,
    /// The bar that a corner is over.
    pub over: Option<Ident>,
    /// The free side of a wall, of a bar or an edge.
    pub facing: Option<Facing>,
    /// How it acts.
    pub contact_law: ContactLaw,
    /// The velocity of its surface along its direction.
    pub moving: Option<Expr>,
    /// Where its shape is written.
    pub span: Span,
}

impl SupportDeclaration {
    /// The names of its one-sided constraints: a slot has two.
    pub fn names(&self) -> Vec<String> {
        match self.shape {
            ShapeDeclaration::Slot(..) => {
                ["lower", "upper"].map(|side| format!("{}_{side}", plain(&self.name))).into()
            }
            _ => vec![plain(&self.name)],
        }
    }
}

/// The free side of a wall, of a bar or an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Towards −x; to the left of a bar from its first point to its last.
    Left,
    /// Towards +x; to the right of it.
    Right,
}

/// Reads a support.
pub(super) fn parse(input: ParseStream) -> syn::Result<SupportDeclaration> {
    let name = input.parse()?;
    input.parse::<Token![=]>()?;
    let kind: Ident = input.parse()?;
    let shape = shape(&kind, options::arguments(input)?)?;
    let mut options = Options::with_flags(
        input,
        &[&["under", "over", "facing", "moving"], &CONTACT_LAW[..], &FRICTION[..]].concat(),
        &["rough", "stop", "jams"],
    )?;
    let under = options.take_name("under")?;
    let over = options.take_name("over")?;
    let facing = options.take_name("facing")?.map(facing).transpose()?;
    let wrong = |text: &str| Err(syn::Error::new(kind.span(), text));
    match (&shape, &under, &over, facing) {
        (ShapeDeclaration::Corner(_), Some(_), None, None)
        | (ShapeDeclaration::Corner(_), None, Some(_), None) => {}
        (ShapeDeclaration::Corner(_), ..) => {
            return wrong("a corner is either `under = BAR` or `over = BAR`");
        }
        (_, _, Some(_), _) => return wrong("only a corner can be `over` something"),
        (ShapeDeclaration::Wall(_) | ShapeDeclaration::Bar(_) | ShapeDeclaration::Edge(_), ..)
        | (.., None) => {}
        (.., Some(_)) => return wrong("only a wall, a bar or an edge has `facing`"),
    }
    let contact_law = ContactLaw::take(&mut options)?;
    let moving = options.take("moving");
    if let Some(moving) = &moving {
        let rubs = contact_law.friction.is_some() || contact_law.rough;
        moves_along(&shape, rubs).map_or(Ok(()), |text| Err(syn::Error::new_spanned(moving, text)))?;
    }
    Ok(SupportDeclaration { name, shape, under, over, facing, contact_law, moving, span: kind.span() })
}

/// Why a surface does not move along itself.
fn moves_along(shape: &ShapeDeclaration, rubs: bool) -> Option<&'static str> {
    match shape {
        ShapeDeclaration::Corner(_)
        | ShapeDeclaration::Circle(..)
        | ShapeDeclaration::Bowl(..)
        | ShapeDeclaration::Disc(_) => Some(
            "only a straight surface can be `moving` along itself: `floor`, `wall`, `slope`, `slot`, `bar`, `edge`",
        ),
        _ if !rubs => {
            Some("a surface that moves along itself acts by friction only; add `friction = mu` or `rough`")
        }
        _ => None,
    }
}

fn facing(side: Ident) -> syn::Result<Facing> {
    let name = side.to_string();
    match name.as_str() {
        "left" => Ok(Facing::Left),
        "right" => Ok(Facing::Right),
        _ => {
            let near = nearest(&name, &["left", "right"]);
            let hint = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            let text = format!("a wall, a bar or an edge faces `left` or `right`{hint}");
            Err(syn::Error::new(side.span(), text))
        }
    }
}
