//! Names, parameters, measures, scenery and the nominal figure.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::{self, Body};
use super::constants::Parameters;
use crate::Analysis;
use crate::algebra::{Angle, Series};
use crate::motion::Contact;
use crate::program::{Id, Lowering, Program};
use crate::system::{CoordinateKind, OneSided, Reference};

/// The layout and the methods that need no equations.
pub(super) fn methods(analysis: &Analysis) -> TokenStream {
    let layout = layout(analysis);
    let fields = &analysis.system.parameters;
    let indices = 0..fields.len();
    let (measures, scenery, nominal) = (measures(analysis), scenery(analysis), nominal(analysis));
    quote! {
        const LAYOUT: &'static Layout = &#layout;
        fn parameters(&self) -> ::std::vec::Vec<f64> { ::std::vec![#(self.#fields),*] }
        fn from_parameters(values: &[f64]) -> Self { Self { #(#fields: values[#indices]),* } }
        fn measures(&self) -> ::std::vec::Vec<Measure> { #measures }
        fn scenery(&self) -> ::std::vec::Vec<Scenery> { #scenery }
        fn nominal(&self) -> ::std::vec::Vec<f64> { #nominal }
    }
}

fn layout(analysis: &Analysis) -> TokenStream {
    let (system, kinematics) = (&analysis.system, &analysis.kinematics);
    let (name, declaration) = (system.ident.to_string(), &system.declaration);
    let parameters = system.parameters.iter().map(ToString::to_string);
    let coordinates = kinematics.coordinates.iter().map(|c| {
        let (name, is_angle) = (&c.name, c.is_angle());
        quote!(Coordinate { name: #name, is_angle: #is_angle })
    });
    let mut feet = 0_usize..;
    let contacts = analysis.motion.contacts.iter().map(|contact| {
        let foot = contact.foot.as_ref().and_then(|_| feet.next());
        contact_tokens(analysis, contact, foot)
    });
    let joints = kinematics.joints.iter().map(|joint| &joint.name);
    let points = system.points.iter().map(|point| &point.name);
    let bars = system.bodies.iter().map(|bar| {
        let (name, from, to) = (&bar.name, bar.from, bar.to);
        quote!(Bar { name: #name, from: #from, to: #to })
    });
    let closed = analysis.functions.phases.iter().map(|phase| phase.set);
    quote! {
        Layout {
            name: #name,
            declaration: #declaration,
            parameters: &[#(#parameters),*],
            coordinates: &[#(#coordinates),*],
            contacts: &[#(#contacts),*],
            joints: &[#(#joints),*],
            tangents: &[],
            timed: false,
            quantities: &[],
            points: &[#(#points),*],
            bars: &[#(#bars),*],
            closed_forms: &[#(ContactSet(#closed)),*],
        }
    }
}

fn contact_tokens(analysis: &Analysis, contact: &Contact, foot: Option<usize>) -> TokenStream {
    let label = contact.label(&analysis.system);
    let supports = contact.supports.iter().map(|&s| &analysis.system.supports[s].name);
    let shared = contact.shared;
    let foot = match foot {
        Some(i) => quote!(::core::option::Option::Some(#i)),
        None => quote!(::core::option::Option::None),
    };
    quote! {
        Contact {
            label: #label,
            supports: &[#(#supports),*],
            shared: #shared,
            foot: #foot,
            kind: ContactKind::Support,
            rough: false,
            law: Law::Newton,
            stop: false,
        }
    }
}

/// Lowers series of parameters and gives their expressions over `self` in `f64`.
fn numbers(analysis: &Analysis, lower: impl FnOnce(&mut Lowering) -> Vec<Id>) -> Body {
    let mut program = Program::default();
    let ids = lower(&mut Lowering::new(&mut program, &analysis.system, []));
    let inputs = Parameters { system: &analysis.system, scalar: quote!(f64) };
    body::write(&program, &ids, &inputs, &quote!(f64))
}

fn measures(analysis: &Analysis) -> TokenStream {
    let system = &analysis.system;
    let bodies = system.bodies.iter().flat_map(|body| {
        let of = format!("bar {}", body.name);
        [(&body.mass, quote!(Mass)), (&body.length, quote!(Length)), (&body.inertia, quote!(Inertia))]
            .map(|(value, kind)| (of.clone(), kind, value.clone()))
    });
    let particles = system.particles.iter().map(|particle| {
        let of = format!("mass at {}", system.points[particle.point].name);
        (of, quote!(Mass), particle.mass.clone())
    });
    let squares = system.gravity.iter().map(|[x, y]| {
        let square = &x.pow(2) + &y.pow(2);
        ("gravity".to_owned(), quote!(Gravity), square)
    });
    let all: Vec<(String, TokenStream, Series)> = bodies.chain(particles).chain(squares).collect();
    let plain = all.len() - usize::from(system.gravity.is_some());
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        let mut ids: Vec<Id> = all.iter().map(|(_, _, value)| lowering.series(value)).collect();
        ids[plain..].iter_mut().for_each(|id| *id = lowering.program().sqrt(*id));
        ids
    });
    let (of, kinds) = (all.iter().map(|(of, _, _)| of), all.iter().map(|(_, kind, _)| kind));
    quote! {
        #statements
        ::std::vec![#(Measure { of: #of, kind: MeasureKind::#kinds, value: #results }),*]
    }
}

fn scenery(analysis: &Analysis) -> TokenStream {
    let system = &analysis.system;
    let mut places: Vec<(&str, Option<&Angle>, bool, &[Series; 2])> = Vec::new();
    for support in &system.supports {
        places.push(match &support.contact {
            OneSided::Line { through, direction, .. } => (&support.name, Some(direction), false, through),
            OneSided::Corner { at, .. } => (&support.name, None, false, at),
            OneSided::Circle { .. } | OneSided::Thread { .. } => continue,
        });
    }
    let pins = system.pins.iter().map(|pin| (system.points[pin.point].name.as_str(), None, true, &pin.at));
    places.extend(pins);
    let level = Angle::zero();
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        let values = |(_, angle, _, at): &(&str, Option<&Angle>, bool, &[Series; 2])| {
            let angle = lowering.angle(angle.unwrap_or(&level));
            [lowering.series(&at[0]), lowering.series(&at[1]), angle]
        };
        places.iter().flat_map(values).collect()
    });
    let items = places.iter().zip(results.chunks(3)).map(|((name, angle, pin, _), result)| {
        let [x, y, value] = result else { return TokenStream::new() };
        let shape = match (angle, pin) {
            (Some(_), _) => quote!(Shape::Line { angle: #value }),
            (None, true) => quote!(Shape::Pin),
            (None, false) => quote!(Shape::Corner),
        };
        quote!(Scenery { name: #name, shape: #shape, at: [#x, #y] })
    });
    quote! {
        #statements
        ::std::vec![#(#items),*]
    }
}

fn nominal(analysis: &Analysis) -> TokenStream {
    let (system, runtime) = (&analysis.system, &analysis.system.runtime);
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        let mut ids: Vec<Id> = system.figure.iter().flatten().map(|s| lowering.series(s)).collect();
        for coordinate in &analysis.kinematics.coordinates {
            ids.push(match &coordinate.reading {
                CoordinateKind::Angle { reference: Reference::Ground(angle), .. } => lowering.angle(angle),
                _ => lowering.program().integer(0),
            });
        }
        ids
    });
    let (figure, references) = results.split_at(2 * system.figure.len());
    let direction = |body: usize| {
        let at = |point: usize| {
            let (x, y) = (&figure[2 * point], &figure[2 * point + 1]);
            quote!([#x, #y])
        };
        let (from, to) = (at(system.bodies[body].from), at(system.bodies[body].to));
        quote!(#runtime::figure::direction(#from, #to))
    };
    let values = analysis.kinematics.coordinates.iter().zip(references).map(|(coordinate, constant)| {
        let (value, sign) = match &coordinate.reading {
            CoordinateKind::Position { point, axis, sign } => (figure[2 * point + axis].clone(), *sign),
            CoordinateKind::Angle { body, reference, sign } => {
                let from = match reference {
                    Reference::Ground(_) => constant.clone(),
                    Reference::Body(other) => direction(*other),
                };
                let own = direction(*body);
                (quote!(#runtime::figure::wrapped(#own - (#from))), *sign)
            }
        };
        if sign < 0 { quote!(-(#value)) } else { value }
    });
    quote! {
        #statements
        ::std::vec![#(#values),*]
    }
}
