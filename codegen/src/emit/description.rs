//! Names, parameters, measures, scenery and the nominal figure.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::{self, Body};
use super::constants::Parameters;
use crate::Analysis;
use crate::algebra::{Angle, Series};
use crate::motion::Contact;
use crate::program::{Id, Lowering, Program};
use crate::system::{CoordinateKind, Law, OneSided, Reference, Spring};

/// The layout and the methods that need no equations.
pub(super) fn methods(analysis: &Analysis) -> TokenStream {
    let layout = layout(analysis);
    let fields = &analysis.system.parameters;
    let indices = 0..fields.len();
    let (measures, scenery, nominal) = (measures(analysis), scenery(analysis), nominal(analysis));
    let restitution = restitution(analysis);
    quote! {
        const LAYOUT: &'static Layout = &#layout;
        fn parameters(&self) -> ::std::vec::Vec<f64> { ::std::vec![#(self.#fields),*] }
        fn from_parameters(values: &[f64]) -> Self { Self { #(#fields: values[#indices]),* } }
        fn measures(&self) -> ::std::vec::Vec<Measure> { #measures }
        #restitution
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
    let (tangents, timed) = (&analysis.motion.tangents, analysis.motion.is_timed());
    let quantities = analysis.functions.quantities.iter().map(|(name, _)| name);
    let closed = analysis.functions.phases.iter().map(|phase| phase.set);
    quote! {
        Layout {
            name: #name,
            declaration: #declaration,
            parameters: &[#(#parameters),*],
            coordinates: &[#(#coordinates),*],
            contacts: &[#(#contacts),*],
            joints: &[#(#joints),*],
            tangents: &[#(#tangents),*],
            timed: #timed,
            quantities: &[#(#quantities),*],
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
    let support = contact.support(&analysis.system);
    let (rough, stop) = (support.rough, support.stop);
    let kind = if contact.is_thread(&analysis.system) { quote!(Thread) } else { quote!(Support) };
    let law = match support.law {
        Law::Newton => quote!(Newton),
        Law::Poisson => quote!(Poisson),
    };
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
            kind: ContactKind::#kind,
            rough: #rough,
            law: Law::#law,
            stop: #stop,
        }
    }
}

/// Lowers series of parameters and gives their expressions over `self` in `f64`.
fn numbers(analysis: &Analysis, lower: impl FnOnce(&mut Lowering) -> Vec<Id>) -> Body {
    let mut program = Program::default();
    let ids = lower(&mut Lowering::new(&mut program, &analysis.system, &[], []));
    let inputs = Parameters { system: &analysis.system, scalar: quote!(f64) };
    body::write(&program, &ids, &inputs, &quote!(f64))
}

/// Only where some contact is not plastic.
fn restitution(analysis: &Analysis) -> Option<TokenStream> {
    let supports = analysis.motion.contacts.iter().map(|contact| contact.support(&analysis.system));
    let restitution: Vec<Option<Series>> = supports.map(|support| support.restitution.clone()).collect();
    if restitution.iter().all(Option::is_none) {
        return None;
    }
    let zero = Series::zero();
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        restitution.iter().map(|e| lowering.series(e.as_ref().unwrap_or(&zero))).collect()
    });
    Some(quote! {
        fn restitution(&self) -> ::std::vec::Vec<f64> {
            #statements
            ::std::vec![#(#results),*]
        }
    })
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
    let pair = |spring: &Spring| spring.ends.map(|end| system.points[end].name.as_str()).join(" and ");
    let springs = system.springs.iter().flat_map(|spring| {
        let of = format!("spring between {}", pair(spring));
        let values = [(&spring.stiffness, quote!(Stiffness)), (&spring.damping, quote!(Damping))];
        values.map(|(value, kind)| Some((of.clone(), kind, value.clone()?)))
    });
    let torsions = system.torsions.iter().flat_map(|torsion| {
        let of = format!("torsion of {}", torsion.name);
        let values = [(&torsion.stiffness, quote!(TorsionalStiffness)), (&torsion.damping, quote!(Damping))];
        values.map(|(value, kind)| Some((of.clone(), kind, value.clone()?)))
    });
    let particles = particles.chain(springs.chain(torsions).flatten());
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
    // Bodies whose first two points do not lie along the first axis of their frame.
    let oblique = |body: &usize| {
        let [from, to] = [system.bodies[*body].from, system.bodies[*body].to];
        !(&system.local(*body, to)[1] - &system.local(*body, from)[1]).is_zero()
    };
    let frames: Vec<usize> = (0..system.bodies.len()).filter(oblique).collect();
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        let mut ids: Vec<Id> = system.figure.iter().flatten().map(|s| lowering.series(s)).collect();
        for body in &frames {
            let of = system.local(*body, system.bodies[*body].from);
            let to = system.local(*body, system.bodies[*body].to);
            ids.extend(of.iter().chain(&to).map(|s| lowering.series(s)));
        }
        for coordinate in &analysis.kinematics.coordinates {
            ids.push(match &coordinate.reading {
                CoordinateKind::Angle { reference: Reference::Ground(angle), .. } => lowering.angle(angle),
                _ => lowering.program().integer(0),
            });
        }
        ids
    });
    let (figure, rest) = results.split_at(2 * system.figure.len());
    let (locals, references) = rest.split_at(4 * frames.len());
    let direction = |body: usize| {
        let at = |point: usize| {
            let (x, y) = (&figure[2 * point], &figure[2 * point + 1]);
            quote!([#x, #y])
        };
        let (from, to) = (at(system.bodies[body].from), at(system.bodies[body].to));
        let seen = quote!(#runtime::figure::direction(#from, #to));
        match frames.iter().position(|&frame| frame == body).map(|at| &locals[4 * at..4 * at + 4]) {
            Some([a, b, c, d]) => quote!(#seen - #runtime::figure::direction([#a, #b], [#c, #d])),
            _ => seen,
        }
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
