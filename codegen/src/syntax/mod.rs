//! What is declared: the struct's fields and its helper attributes, with spans, nothing resolved yet.

mod attribute;
mod bar;
mod chain;
mod constant;
mod coordinate;
mod equal;
mod figure;
mod gravity;
mod item;
mod mass;
mod mirror;
mod nearest;
mod options;
mod point;
mod report;
mod support;

use std::collections::BTreeSet;

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Expr, Ident, Path};

pub use bar::{Bar, Matter};
pub use chain::Chain;
pub use coordinate::{Coordinate, Origin, Reading};
pub use equal::{EqualAngles, Member};
pub use gravity::Gravity;
pub use mass::PointMass;
pub use mirror::MirrorLine;
pub use point::PointOnBar;
pub use support::{Facing, Shape, SupportDeclaration};

pub(crate) use nearest::{nearest, unknown};
pub(crate) use report::Report;

/// A position `(x, y)`.
pub type Pair = [Expr; 2];

/// A bar, or a chain of equal ones.
#[derive(Clone, Debug)]
pub enum Beam {
    /// One bar.
    Bar(Bar),
    /// Equal bars, one after the other.
    Chain(Chain),
}

/// A declared model, attribute by attribute in the order written.
#[derive(Clone, Debug)]
pub struct Description {
    /// The struct's name.
    pub ident: Ident,
    /// Where the runtime crate is found.
    pub runtime: Path,
    /// The item's tokens as text.
    pub declaration: String,
    /// The struct's fields: the parameters.
    pub fields: Vec<Ident>,
    /// `#[constant(h = …)]`.
    pub constants: Vec<(Ident, Expr)>,
    /// `#[gravity(…)]`.
    pub gravity: Option<Gravity>,
    /// `#[bar(…)]` and `#[chain(…)]`.
    pub beams: Vec<Beam>,
    /// `#[point(…)]`.
    pub points: Vec<PointOnBar>,
    /// `#[mass(…)]`.
    pub masses: Vec<PointMass>,
    /// `#[pin(…)]`.
    pub pins: Vec<(Ident, Pair)>,
    /// `#[support(…)]`.
    pub supports: Vec<SupportDeclaration>,
    /// `#[coordinate(…)]`.
    pub coordinates: Vec<Coordinate>,
    /// `#[equal(…)]`.
    pub equal: Vec<EqualAngles>,
    /// `#[figure(…)]`.
    pub figure: Vec<(Ident, Pair)>,
    /// `#[mirror(…)]`.
    pub mirror: Option<MirrorLine>,
    /// Mistakes found so far; [`crate::system::System::resolve`] adds its own and tells all.
    pub(crate) report: Report,
    /// Names of malformed attributes.
    pub(crate) broken: Vec<&'static str>,
    /// Names in malformed attributes: that these are unknown elsewhere is no second mistake.
    pub(crate) malformed: BTreeSet<String>,
}

/// Reads a struct with its helper attributes. Mistakes within one attribute are kept in the
/// description, so that they are told together with those found when it is resolved.
///
/// # Errors
/// The item is not a struct with named fields.
pub fn parse(tokens: TokenStream) -> syn::Result<Description> {
    let declaration = tokens.to_string();
    let input: syn::DeriveInput = syn::parse2(tokens)?;
    let mut description = Description::new(input.ident.clone(), declaration);
    item::fields(&input, &mut description)?;
    for attribute in &input.attrs {
        attribute::read(attribute, &mut description);
    }
    Ok(description)
}

impl Description {
    fn new(ident: Ident, declaration: String) -> Self {
        Self {
            ident,
            runtime: syn::parse_quote!(::liftoff),
            declaration,
            fields: Vec::new(),
            constants: Vec::new(),
            gravity: None,
            beams: Vec::new(),
            points: Vec::new(),
            masses: Vec::new(),
            pins: Vec::new(),
            supports: Vec::new(),
            coordinates: Vec::new(),
            equal: Vec::new(),
            figure: Vec::new(),
            mirror: None,
            report: Report::default(),
            broken: Vec::new(),
            malformed: BTreeSet::new(),
        }
    }
}

/// All identifiers, at any depth.
pub(crate) fn identifiers(tokens: &impl ToTokens) -> Vec<String> {
    let names = |token| match token {
        TokenTree::Group(group) => identifiers(&group.stream()),
        TokenTree::Ident(name) => vec![name.to_string()],
        TokenTree::Punct(_) | TokenTree::Literal(_) => Vec::new(),
    };
    tokens.to_token_stream().into_iter().flat_map(names).collect()
}
