//! What is declared: the struct's fields and its helper attributes, with spans, nothing resolved
//! yet.

mod attribute;
mod attribute_check;
mod bar;
mod body;
mod budget;
mod chain;
mod constant;
mod contact_law;
mod coordinate;
mod couple;
mod disc;
mod drive;
mod equal;
mod figure;
mod force;
mod gravity;
mod hinge;
mod item;
mod joint_limit;
mod mass;
mod mirror;
mod options;
mod particle;
mod point;
mod report;
mod route;
mod run;
mod section;
mod shape;
mod slider;
mod spring;
mod support;
mod switch;
mod thread;
mod torsion;
mod value;
mod weld;

use std::collections::BTreeSet;

use proc_macro2::{Group, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Expr, Ident, Path, Token, Visibility};

use crate::limits;

pub use attribute_check::check_attributes;
pub use bar::{Bar, MassProperties};
pub use body::RigidBody;
pub use budget::Budget;
pub use chain::ChainDeclaration;
pub use contact_law::{ContactLaw, FrictionLaw, ImpactLaw};
pub(crate) use coordinate::DIRECTIONS;
pub use coordinate::{CoordinateDeclaration, Origin, ReadingDeclaration};
pub use couple::Couple;
pub use disc::DiscDeclaration;
pub use drive::{DriveDeclaration, Target};
pub use equal::{EqualAngles, Member, Multiple};
pub use force::Force;
pub use gravity::Gravity;
pub use hinge::HingeDeclaration;
pub use joint_limit::{Bound, LimitDeclaration};
pub use mass::PointMass;
pub use mirror::MirrorLine;
pub use point::PointOnBar;
pub use run::{RunDeclaration, StartValue};
pub use section::SectionDeclaration;
pub use shape::{CentreDeclaration, ShapeDeclaration};
pub use slider::{SliderDeclaration, Track};
pub use spring::{Resistance, SpringDeclaration};
pub use support::{Facing, SupportDeclaration};
pub use switch::SwitchDeclaration;
pub use thread::ThreadDeclaration;
pub use torsion::TorsionDeclaration;
pub use value::DefaultValue;
pub use weld::WeldDeclaration;

pub(crate) use crate::nearest::{nearest, unknown};
pub(crate) use report::Report;
pub(crate) use value::without_unit;

/// The function that chooses between two values.
const CHOICE: &str = "if";

/// A position `(x, y)`.
pub type Pair = [Expr; 2];

/// What is rigid: a bar, a chain of equal ones, or any body.
#[derive(Clone, Debug)]
pub enum Beam {
    /// One bar.
    Bar(Bar),
    /// Equal bars, one after the other.
    Chain(ChainDeclaration),
    /// A body of any shape.
    Body(RigidBody),
}

/// A declared model, attribute by attribute in the order written.
#[derive(Clone, Debug)]
pub struct Description {
    /// The struct's name.
    pub ident: Ident,
    /// Where the runtime crate is found.
    pub runtime: Path,
    /// How far the constants with its names are seen, as far as the struct; none if there are to be
    /// none.
    pub names: Option<Visibility>,
    /// The item's tokens as text.
    pub declaration: String,
    /// The first paragraph of its documentation.
    pub summary: String,
    /// The struct's fields: the parameters.
    pub fields: Vec<Ident>,
    /// What each field means, from its documentation.
    pub meanings: Vec<String>,
    /// `#[value(…)]` of each field.
    pub values: Vec<DefaultValue>,
    /// `#[run(…)]`.
    pub run: Option<RunDeclaration>,
    /// `#[constant(h = …)]`.
    pub constants: Vec<(Ident, Expr)>,
    /// `#[gravity(…)]`.
    pub gravity: Option<Gravity>,
    /// The most contact sets that get own code.
    pub sets: Option<usize>,
    /// Whether parameters are pure numbers, whatever they stand for.
    pub dimensionless: bool,
    /// `#[budget(…)]`.
    pub budgets: Vec<Budget>,
    /// `#[bar(…)]`, `#[chain(…)]` and `#[body(…)]`.
    pub beams: Vec<Beam>,
    /// `#[point(…)]`.
    pub points: Vec<PointOnBar>,
    /// `#[mass(…)]`.
    pub masses: Vec<PointMass>,
    /// `#[disc(…)]`.
    pub discs: Vec<DiscDeclaration>,
    /// `#[pin(…)]`.
    pub pins: Vec<(Ident, Pair)>,
    /// Places of those that let go; drives hold them.
    pub loose_pins: Vec<(Ident, Pair)>,
    /// `#[particle(…)]`.
    pub particles: Vec<PointMass>,
    /// `#[ground(…)]`.
    pub ground: Vec<(Ident, Pair)>,
    /// `#[weld(…)]`.
    pub welds: Vec<WeldDeclaration>,
    /// `#[hinge(…)]`.
    pub hinges: Vec<HingeDeclaration>,
    /// `#[slider(…)]`.
    pub sliders: Vec<SliderDeclaration>,
    /// `#[drive(…)]`.
    pub drives: Vec<DriveDeclaration>,
    /// `#[spring(…)]`.
    pub springs: Vec<SpringDeclaration>,
    /// `#[torsion(…)]`.
    pub torsions: Vec<TorsionDeclaration>,
    /// `#[force(…)]`.
    pub forces: Vec<Force>,
    /// `#[couple(…)]`.
    pub couples: Vec<Couple>,
    /// `#[section(…)]`.
    pub sections: Vec<SectionDeclaration>,
    /// `#[thread(…)]`.
    pub threads: Vec<ThreadDeclaration>,
    /// `#[limit(…)]`.
    pub limits: Vec<LimitDeclaration>,
    /// `#[support(…)]`.
    pub supports: Vec<SupportDeclaration>,
    /// `#[coordinate(…)]`.
    pub coordinates: Vec<CoordinateDeclaration>,
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
    limits::check_declaration(&tokens)?;
    let declaration = tokens.to_string();
    let input: syn::DeriveInput =
        syn::parse2(if has_raw_names(&declaration, &tokens) { respell(tokens) } else { tokens })?;
    let mut description = Description::new(input.ident.clone(), input.vis.clone(), declaration);
    description.summary = item::summary(&input.attrs);
    item::fields(&input, &mut description)?;
    for attribute in &input.attrs {
        attribute::parse(attribute, &mut description);
    }
    Ok(description)
}

/// What an item without generic parameters is called, and where its runtime is, whatever else is
/// wrong with it.
pub(crate) fn name_and_runtime(tokens: &TokenStream) -> Option<(Ident, Path)> {
    let mut runtime = syn::parse_quote!(::liftoff);
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    for (i, token) in tokens.iter().enumerate() {
        match (token, tokens.get(i + 1), tokens.get(i + 2)) {
            (TokenTree::Group(group), ..) => runtime = runtime_of(group).unwrap_or(runtime),
            (TokenTree::Ident(word), Some(TokenTree::Ident(name)), after)
                if ["struct", "enum", "union"].iter().any(|kind| word == kind) =>
            {
                let generic = matches!(after, Some(TokenTree::Punct(mark)) if mark.as_char() == '<');
                let is_name = syn::parse2::<Ident>(name.to_token_stream()).is_ok();
                return (is_name && !generic).then(|| (name.clone(), runtime));
            }
            _ => {}
        }
    }
    None
}

/// `path` of `[liftoff(crate = path, …)]`.
fn runtime_of(attribute: &Group) -> Option<Path> {
    let tokens: Vec<TokenTree> = attribute.stream().into_iter().collect();
    let [TokenTree::Ident(name), TokenTree::Group(settings)] = tokens.as_slice() else { return None };
    let path = |input: ParseStream| {
        input.parse::<Token![crate]>()?;
        input.parse::<Token![=]>()?;
        let path = input.call(Path::parse_mod_style)?;
        input.parse::<TokenStream>()?;
        Ok(path)
    };
    Some(settings.stream()).filter(|_| name == "liftoff").and_then(|settings| path.parse2(settings).ok())
}

impl Description {
    fn new(ident: Ident, visibility: Visibility, declaration: String) -> Self {
        Self {
            ident,
            runtime: syn::parse_quote!(::liftoff),
            names: Some(visibility),
            declaration,
            summary: String::new(),
            fields: Vec::new(),
            meanings: Vec::new(),
            values: Vec::new(),
            run: None,
            constants: Vec::new(),
            gravity: None,
            sets: None,
            dimensionless: false,
            budgets: Vec::new(),
            beams: Vec::new(),
            points: Vec::new(),
            masses: Vec::new(),
            discs: Vec::new(),
            pins: Vec::new(),
            loose_pins: Vec::new(),
            particles: Vec::new(),
            ground: Vec::new(),
            welds: Vec::new(),
            hinges: Vec::new(),
            sliders: Vec::new(),
            drives: Vec::new(),
            springs: Vec::new(),
            torsions: Vec::new(),
            forces: Vec::new(),
            couples: Vec::new(),
            sections: Vec::new(),
            threads: Vec::new(),
            limits: Vec::new(),
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

/// A name without `r#`.
pub fn plain(name: &Ident) -> String {
    name.unraw().to_string()
}

/// The identifier of a name, which may be a word of the language.
pub(crate) fn ident(name: &str) -> Ident {
    syn::parse_str(name).unwrap_or_else(|_| Ident::new_raw(name, Span::call_site()))
}

/// Whether a name is written with `r#`, or is to be.
fn has_raw_names(declaration: &str, tokens: &TokenStream) -> bool {
    let chooses = || identifiers(tokens).iter().any(|name| name == CHOICE);
    declaration.contains("r#") || declaration.contains(CHOICE) && chooses()
}

/// With `r#` where it is needed and nowhere else, so that one name is written one way. `if` is a
/// function here.
fn respell(tokens: TokenStream) -> TokenStream {
    let token = |token| match token {
        TokenTree::Group(group) => {
            let mut inside = Group::new(group.delimiter(), respell(group.stream()));
            inside.set_span(group.span());
            TokenTree::Group(inside)
        }
        TokenTree::Ident(name) if name == CHOICE => TokenTree::Ident(Ident::new_raw(CHOICE, name.span())),
        TokenTree::Ident(name) => TokenTree::Ident(Some(name.unraw()).filter(is_free).unwrap_or(name)),
        other => other,
    };
    tokens.into_iter().map(token).collect()
}

/// Whether it is a name in every edition.
fn is_free(name: &Ident) -> bool {
    name != "gen" && syn::parse2::<Ident>(name.to_token_stream()).is_ok()
}

/// All identifiers, at any depth.
pub(crate) fn identifiers(tokens: &impl ToTokens) -> Vec<String> {
    let names = |token| match token {
        TokenTree::Group(group) => identifiers(&group.stream()),
        TokenTree::Ident(name) => vec![plain(&name)],
        TokenTree::Punct(_) | TokenTree::Literal(_) => Vec::new(),
    };
    tokens.to_token_stream().into_iter().flat_map(names).collect()
}
