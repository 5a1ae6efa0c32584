//! Names as constants of the model, `Ladder::PHI`: in upper snake case, each of a type that tells
//! what it names.
//!
//! Where several names give one constant, the first has it in this order: coordinates, supports,
//! points, threads, bars, springs, sections; a point and a support of one name share it. A name
//! that gives `LAYOUT`, which the trait has, has none.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use proc_macro2::{Span, TokenStream};
use quote::format_ident;
use syn::Ident;

use super::meaning;
use crate::Analysis;
use crate::syntax::{Beam, Description, plain};

/// What the trait calls a constant of its own.
const TAKEN: &str = "LAYOUT";

/// The constants of an analysed model; nothing if it asks for none.
pub(super) fn constants(analysis: &Analysis) -> TokenStream {
    let system = &analysis.system;
    system.name_constants.as_ref().map_or_else(TokenStream::new, |visibility| {
        let constants = named(analysis).list.into_iter().map(|constant| {
            let (value, kind, meaning) = (constant.value(), constant.kind.ident(), constant.meaning);
            let ident = constant.ident;
            quote!(#[doc = #meaning] #visibility const #ident: names::#kind = #value;)
        });
        implementation(constants)
    })
}

/// Constants for all that a declaration with mistakes names, so that their uses are no further
/// mistakes.
pub(super) fn assumed(description: &Description) -> TokenStream {
    description.names.as_ref().map_or_else(TokenStream::new, |visibility| {
        let mut constants = ConstantList::default();
        for name in mentioned(description) {
            constants.add(Kind::Unknown, &name, Span::call_site(), String::new());
        }
        let constants = constants.list.into_iter().map(|Constant { ident, name, .. }| {
            quote!(#[doc(hidden)] #visibility const #ident: names::Unknown = names::Unknown::new(#name);)
        });
        implementation(constants)
    })
}

fn implementation(constants: impl Iterator<Item = TokenStream>) -> TokenStream {
    let model = super::model();
    quote! {
        #[allow(dead_code, reason = "a program uses some of the names")]
        impl #model { #(#constants)* }
    }
}

fn named(analysis: &Analysis) -> ConstantList {
    let (system, mut constants) = (&analysis.system, ConstantList::default());
    let dependent = analysis.kinematics.dependent.iter().map(|angle| &angle.declared);
    for coordinate in analysis.kinematics.coordinates.iter().chain(dependent) {
        let declared = system.coordinates.iter().find(|declared| plain(&declared.name) == coordinate.name);
        let span = declared.map_or_else(Span::call_site, |declared| declared.name.span());
        constants.add(Kind::Coordinate, &coordinate.name, span, meaning::coordinate(system, coordinate));
    }
    let (threads, supports): (Vec<_>, Vec<_>) =
        system.supports.iter().partition(|support| support.contact.is_thread());
    for support in supports.into_iter().filter(|support| support.contact.drive().is_none()) {
        constants.add(Kind::Support, &support.name, support.span, support.meaning(system));
    }
    for point in &system.points {
        constants.add(Kind::Point, &point.name, point.span, meaning::point(system, point));
    }
    for thread in threads {
        constants.add(Kind::Thread, &thread.name, thread.span, thread.meaning(system));
    }
    for body in &system.bodies {
        constants.add(Kind::Part, &body.name, body.span, meaning::body(system, body));
    }
    for spring in &system.springs {
        constants.add(Kind::Part, &spring.name, spring.span, format!("Spring `{}`.", spring.name));
    }
    for section in &system.sections {
        constants.add(Kind::Part, &section.name, section.span, meaning::section(system, section));
    }
    constants
}

fn mentioned(d: &Description) -> Vec<String> {
    let coordinates = d.coordinates.iter().map(|c| plain(&c.name));
    let supports = d.supports.iter().flat_map(|support| support.names());
    let threads = d.threads.iter().map(|thread| plain(&thread.name));
    let limits = d.limits.iter().flat_map(|limit| limit.bounds().map(|bound| bound.name));
    let places = [&d.figure, &d.pins, &d.ground].into_iter().flatten().map(|(name, _)| plain(name));
    let points = d.points.iter().map(|point| plain(&point.name));
    let particles = d.particles.iter().map(|particle| plain(&particle.point));
    let springs = d.springs.iter().map(|spring| plain(&spring.name));
    let sections = d.sections.iter().map(|section| plain(&section.name));
    let beams = d.beams.iter().flat_map(beam);
    let contacts = coordinates.chain(supports).chain(threads).chain(limits);
    let points = places.chain(points).chain(particles).chain(beams);
    contacts.chain(points).chain(springs).chain(sections).chain(d.malformed.iter().cloned()).collect()
}

fn beam(beam: &Beam) -> Vec<String> {
    let names: Vec<&Ident> = match beam {
        Beam::Bar(bar) => vec![&bar.name, &bar.from, &bar.to],
        Beam::Body(body) => {
            core::iter::once(&body.name).chain(body.points.iter().map(|(name, _)| name)).collect()
        }
        Beam::Chain(chain) => {
            return chain.bars().flat_map(|bar| [bar.name, bar.from, bar.to].map(|n| plain(&n))).collect();
        }
    };
    names.into_iter().map(plain).collect()
}

/// The types of `liftoff_core::model::names`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Coordinate,
    Support,
    Point,
    Place,
    Thread,
    Part,
    Unknown,
}

impl Kind {
    fn ident(self) -> Ident {
        format_ident!("{self:?}")
    }
}

struct Constant {
    ident: Ident,
    name: String,
    kind: Kind,
    meaning: String,
}

impl Constant {
    fn value(&self) -> TokenStream {
        let (kind, name) = (self.kind.ident(), &self.name);
        let rate = (self.kind == Kind::Coordinate).then(|| format!("{name}'")).into_iter();
        quote!(names::#kind::new(#name #(, #rate)*))
    }
}

/// Constants in the order of the declaration, no two of one name.
#[derive(Default)]
struct ConstantList {
    list: Vec<Constant>,
    places: BTreeMap<String, usize>,
}

impl ConstantList {
    fn add(&mut self, kind: Kind, name: &str, span: Span, meaning: String) {
        let upper = upper_snake(name);
        let Some(mut ident) = syn::parse_str::<Ident>(&upper).ok().filter(|_| upper != TAKEN) else {
            return;
        };
        match self.places.entry(upper) {
            Entry::Vacant(place) => {
                ident.set_span(span);
                place.insert(self.list.len());
                self.list.push(Constant { ident, name: name.to_owned(), kind, meaning });
            }
            Entry::Occupied(place) => {
                let known = &mut self.list[*place.get()];
                if known.name == name && (known.kind, kind) == (Kind::Support, Kind::Point) {
                    known.kind = Kind::Place;
                    known.meaning = format!("{meaning} {}", known.meaning);
                }
            }
        }
    }
}

/// `phi_inner` and `phiInner` as `PHI_INNER`.
fn upper_snake(name: &str) -> String {
    let (mut text, mut after_lower) = (String::new(), false);
    for letter in name.chars() {
        if after_lower && letter.is_uppercase() {
            text.push('_');
        }
        after_lower = letter.is_lowercase();
        text.extend(letter.to_uppercase());
    }
    text
}

#[cfg(test)]
mod tests;
