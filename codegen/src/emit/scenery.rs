//! What stands still: lines, corners, circles, pins and fixed points.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::Body;
use super::count;
use super::numbers::numbers;
use crate::Analysis;
use crate::algebra::{Angle, Series};
use crate::program::{Id, Lowering};
use crate::system::{Guide, OneSided, System};

/// A fixed thing: its name, a point of it, its shape.
struct Thing<'a> {
    name: &'a str,
    at: &'a [Series; 2],
    shape: Shape<'a>,
}

enum Shape<'a> {
    Line(&'a Angle),
    Guide(&'a Angle),
    Circle(&'a Series, bool),
    Corner,
    Pin,
    Point,
}

impl Shape<'_> {
    /// What of it parameters determine.
    fn number(&self, lowering: &mut Lowering) -> Id {
        match self {
            Self::Line(angle) | Self::Guide(angle) => lowering.angle(angle),
            Self::Circle(radius, _) => lowering.series(radius),
            Self::Corner | Self::Pin | Self::Point => lowering.program().integer(0),
        }
    }

    fn tokens(&self, number: &TokenStream) -> TokenStream {
        match self {
            Self::Line(_) => quote!(Shape::Line { angle: #number }),
            Self::Guide(_) => quote!(Shape::Guide { angle: #number }),
            Self::Circle(_, inside) => quote!(Shape::Circle { radius: #number, inside: #inside }),
            Self::Corner => quote!(Shape::Corner),
            Self::Pin => quote!(Shape::Pin),
            Self::Point => quote!(Shape::Point),
        }
    }
}

/// `scenery` and its type.
pub(super) fn scenery(analysis: &Analysis) -> TokenStream {
    let things = things(&analysis.system);
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        let values = |thing: &Thing| {
            let number = thing.shape.number(lowering);
            [lowering.series(&thing.at[0]), lowering.series(&thing.at[1]), number]
        };
        things.iter().flat_map(values).collect()
    });
    let items = things.iter().zip(results.chunks(3)).map(|(thing, result)| {
        let [x, y, number] = result else { return TokenStream::new() };
        let (name, shape) = (thing.name, thing.shape.tokens(number));
        quote!(Scenery { name: #name, shape: #shape, at: [#x, #y] })
    });
    let entries = count(things.len());
    quote! {
        type Scenery = [Scenery; #entries];
        fn scenery(&self) -> Self::Scenery {
            #statements
            [#(#items),*]
        }
    }
}

fn things(system: &System) -> Vec<Thing<'_>> {
    let supports = system.supports.iter().filter_map(|support| {
        let (at, shape) = match &support.contact {
            OneSided::Line { through, direction, .. } => (through, Shape::Line(direction)),
            OneSided::Corner { at, .. } => (at, Shape::Corner),
            OneSided::Circle { centre, radius, inside, .. } => (centre, Shape::Circle(radius, *inside)),
            OneSided::Thread { .. } => return None,
        };
        Some(Thing { name: &support.name, at, shape })
    });
    let guides = system.sliders.iter().filter_map(|slider| match &slider.guide {
        Guide::Line { through, direction } => {
            Some(Thing { name: &slider.name, at: through, shape: Shape::Guide(direction) })
        }
        Guide::Axis(_) => None,
    });
    let pins = system.pins.iter().map(|pin| Thing {
        name: &system.points[pin.point].name,
        at: &pin.at,
        shape: Shape::Pin,
    });
    let fixed = system.points.iter().filter_map(|point| {
        let at = point.ground.as_ref()?;
        Some(Thing { name: &point.name, at, shape: Shape::Point })
    });
    supports.chain(guides).chain(pins).chain(fixed).collect()
}
