//! How the model is drawn, as static data; what is empty is left out.

use proc_macro2::{Literal, TokenStream};

use super::body::FunctionBody as Code;
use super::numbers::expressions;
use super::{count, option, variant};
use crate::Analysis;
use crate::geometry::{
    DrawnBody, DrawnDirection, DrawnReading, DrawnSection, DrawnShape, DrawnSpring, DrawnThread, Fixture,
    Geometry, Length, Push, Round, Spot,
};
use crate::numbers::drawn;

/// The static forms.
pub(super) fn geometry(geometry: &Geometry) -> TokenStream {
    let fields = [
        list(&quote!(bodies), &geometry.bodies, body),
        list(&quote!(rounds), &geometry.rounds, round),
        list(&quote!(threads), &geometry.threads, thread),
        list(&quote!(springs), &geometry.springs, spring),
        list(&quote!(spirals), &geometry.spirals, |(point, from)| {
            let (point, from) = (count(*point), direction(from));
            quote!(geometry::Spiral { point: #point, from: #from })
        }),
        list(&quote!(blocks), &geometry.blocks, |(point, along)| {
            let (point, along) = (count(*point), direction(along));
            quote!(geometry::Block { point: #point, along: #along })
        }),
        list(&quote!(marks), &geometry.marks, |(point, look)| {
            let (point, look) = (count(*point), variant(look));
            quote!(geometry::Mark { point: #point, look: geometry::Look::#look })
        }),
        list(&quote!(fixtures), &geometry.fixtures, fixture),
        list(&quote!(sections), &geometry.sections, section),
        list(&quote!(readings), &geometry.readings, reading),
        list(&quote!(lengths), &geometry.lengths, length),
        list(&quote!(pushes), &geometry.pushes, push),
        geometry.gravity.map(|components| {
            let components = indices(&components);
            quote!(gravity: ::core::option::Option::Some(#components),)
        }),
    ];
    let fields = fields.into_iter().flatten();
    quote!(&Geometry { #(#fields)* ..Geometry::EMPTY })
}

/// `numbers` and its type.
pub(super) fn values(analysis: &Analysis, geometry: &Geometry) -> TokenStream {
    let Code { statements, results, .. } = expressions(analysis, &drawn(analysis, geometry));
    let entries = count(results.len());
    quote! {
        type Numbers = [f64; #entries];
        fn numbers(&self) -> Self::Numbers {
            #statements
            [#(#results),*]
        }
    }
}

/// A field with its entries; none without any.
fn list<T>(name: &TokenStream, entries: &[T], entry: impl Fn(&T) -> TokenStream) -> Option<TokenStream> {
    let entries: Vec<TokenStream> = entries.iter().map(entry).collect();
    (!entries.is_empty()).then(|| quote!(#name: &[#(#entries),*],))
}

fn indices(indices: &[usize]) -> TokenStream {
    let indices = indices.iter().map(|&index| count(index));
    quote!([#(#indices),*])
}

fn spot(spot: &Spot) -> TokenStream {
    match spot {
        Spot::Point(point) => {
            let point = count(*point);
            quote!(geometry::Spot::Point(#point))
        }
        Spot::Fixed(at) => {
            let at = indices(at);
            quote!(geometry::Spot::Fixed(#at))
        }
    }
}

fn direction(direction: &DrawnDirection) -> TokenStream {
    match direction {
        DrawnDirection::Fixed(angle) => {
            let angle = count(*angle);
            quote!(geometry::Direction::Fixed(#angle))
        }
        DrawnDirection::Towards(from, to) => {
            let (from, to) = (spot(from), spot(to));
            quote!(geometry::Direction::Towards(#from, #to))
        }
        DrawnDirection::Axis(ends, step) => {
            let (ends, step) = (indices(ends), indices(step));
            quote!(geometry::Direction::Axis { ends: #ends, step: #step })
        }
    }
}

fn body(DrawnBody { outline, inner }: &DrawnBody) -> TokenStream {
    let (outline, inner) = (indices(outline), indices(inner));
    quote!(geometry::Body { outline: &#outline, inner: &#inner })
}

fn round(Round { centre, radius, text, solid, along }: &Round) -> TokenStream {
    let (centre, radius, solid) = (count(*centre), count(*radius), variant(solid));
    let along = option(along.as_ref().map(direction));
    quote! {
        geometry::Round {
            centre: #centre, radius: #radius, text: #text, solid: geometry::Solid::#solid, along: #along
        }
    }
}

fn thread(DrawnThread { name, path, length, text }: &DrawnThread) -> TokenStream {
    let (path, length) = (indices(path), count(*length));
    quote!(geometry::Thread { name: #name, path: &#path, length: #length, text: #text })
}

fn spring(DrawnSpring { name, ends, coil, dashpot, text }: &DrawnSpring) -> TokenStream {
    let ends = indices(ends);
    quote!(geometry::Spring { name: #name, ends: #ends, coil: #coil, dashpot: #dashpot, text: #text })
}

fn fixture(Fixture { name, at, shape }: &Fixture) -> TokenStream {
    let at = indices(at);
    let shape = match shape {
        DrawnShape::Line { angle, solid } => {
            let angle = count(*angle);
            quote!(Line { angle: #angle, solid: #solid })
        }
        DrawnShape::Circle { radius, solid, text } => {
            let (radius, solid) = (count(*radius), variant(solid));
            quote!(Circle { radius: #radius, solid: geometry::Solid::#solid, text: #text })
        }
        DrawnShape::Wedge => quote!(Wedge),
    };
    quote!(geometry::Fixture { name: #name, at: #at, shape: geometry::Shape::#shape })
}

fn section(DrawnSection { name, ends, at }: &DrawnSection) -> TokenStream {
    let (ends, at) = (indices(ends), count(*at));
    quote!(geometry::Section { name: #name, ends: #ends, at: #at })
}

fn reading(reading: &DrawnReading) -> TokenStream {
    match reading {
        DrawnReading::Angle { vertex, tip, from, against, sign } => {
            let (vertex, tip, from) = (count(*vertex), count(*tip), direction(from));
            let sign = Literal::i8_unsuffixed(*sign);
            quote! {
                geometry::Reading::Angle { vertex: #vertex, tip: #tip, from: #from, against: #against, sign: #sign }
            }
        }
        DrawnReading::Position { point, axis, sign } => {
            let (point, axis, sign) = (count(*point), count(*axis), Literal::i8_unsuffixed(*sign));
            quote!(geometry::Reading::Position { point: #point, axis: #axis, sign: #sign })
        }
    }
}

fn length(Length { value, text, between }: &Length) -> TokenStream {
    let (value, between) = (count(*value), between.iter().map(|ends| indices(ends)));
    quote!(geometry::Length { value: #value, text: #text, between: &[#(#between),*] })
}

fn push(Push { support, at, rim, along, turns, slip }: &Push) -> TokenStream {
    let (at, rim, along) = (spot(at), option(rim.map(count)), direction(along));
    let (turns, slip) = (Literal::u8_unsuffixed(*turns), Literal::i8_unsuffixed(*slip));
    quote!(geometry::Push { support: #support, at: #at, rim: #rim, along: #along, turns: #turns, slip: #slip })
}
