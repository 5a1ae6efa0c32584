//! Names and parameters.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, format_ident};

use super::defaults::defaults;
use super::numbers::{measures, restitution};
use super::{contact_sets, count, geometry, nominal, option, quantities};
use crate::functions::Kink;
use crate::geometry::Geometry;
use crate::motion::Contact;
use crate::syntax::plain;
use crate::system::{Law, Switch};
use crate::{Analysis, Dimension, in_bytes};

/// The layout and the methods that need no equations.
pub(super) fn methods(analysis: &Analysis) -> TokenStream {
    let drawn = Geometry::from_system(&analysis.system, &analysis.kinematics.coordinates);
    let layout = layout(analysis, &drawn);
    let fields = &analysis.system.parameters;
    let indices = 0..fields.len();
    let (measures, numbers) = (measures(analysis), geometry::values(analysis, &drawn));
    let nominal = nominal::nominal(analysis);
    let restitution = restitution(analysis);
    quote! {
        const LAYOUT: &'static Layout = &#layout;
        fn parameters(&self) -> Self::Parameters<f64> { [#(self.#fields),*] }
        fn from_parameters(values: &[f64]) -> Self { Self { #(#fields: values[#indices]),* } }
        #measures
        #restitution
        #numbers
        fn nominal(&self) -> Self::Accelerations<f64> { #nominal }
    }
}

fn layout(analysis: &Analysis, drawn: &Geometry) -> TokenStream {
    let (system, kinematics) = (&analysis.system, &analysis.kinematics);
    let (name, declaration, summary) = (plain(&system.ident), &system.declaration, &system.summary);
    let parameters = system.parameters.iter().map(plain);
    let dimensions = analysis.dimensions.parameters.iter().copied().map(dimension);
    let covariant = analysis.dimensions.covariant;
    let coordinates = kinematics.coordinates.iter().map(|c| {
        let (name, is_angle) = (&c.name, c.is_angle());
        quote!(Coordinate { name: #name, is_angle: #is_angle })
    });
    let terms = |terms: &[(usize, i32)]| {
        let terms = terms.iter().map(|(index, factor)| quote!(Term { index: #index, factor: #factor }));
        quote!(&[#(#terms),*])
    };
    let dependent = kinematics.dependent.iter().map(|angle| {
        let (name, quarters) = (&angle.declared.name, angle.quarters);
        let (parameters, coordinates) = (terms(&angle.parameters), terms(&angle.coordinates));
        quote! {
            DependentAngle {
                name: #name, quarters: #quarters, parameters: #parameters, coordinates: #coordinates,
            }
        }
    });
    let mut feet = 0_usize..;
    let mut frictions = 0_usize..;
    let contacts = analysis.motion.contacts.iter().map(|contact| {
        let foot = contact.foot.as_ref().and_then(|_| feet.next());
        let friction = contact.friction.as_ref().and_then(|_| frictions.next());
        contact_tokens(analysis, contact, foot, friction)
    });
    let contacts: Vec<TokenStream> = contacts.collect();
    let joints = kinematics.joints.iter().map(|joint| {
        let (name, is_angle) = (&joint.name, joint.is_angle(system));
        quote!(Joint { name: #name, is_angle: #is_angle })
    });
    let points = system.points.iter().map(|point| &point.name);
    let bars = system.bodies.iter().map(|bar| {
        let (name, from, to) = (&bar.name, bar.from, bar.to);
        quote!(Bar { name: #name, from: #from, to: #to })
    });
    let (tangents, timed) = (&analysis.motion.tangents, analysis.motion.is_timed());
    let (compliant, loaded) = (system.is_compliant(), system.is_loaded());
    let switches = system
        .switches
        .iter()
        .map(|Switch { label, condition }| quote!(Switch { label: #label, condition: #condition }));
    let signals = system.signals.iter().map(|signal| {
        let (expression, drives) = (&signal.expression, signal.drives);
        quote!(Signal { expression: #expression, drives: #drives })
    });
    let quantities = analysis.functions.quantities.iter().map(|quantity| {
        let (name, kind) = (&quantity.name, quantities::kind(quantity.kind));
        quote!(Quantity { name: #name, kind: #kind })
    });
    let kinks = analysis.functions.kinks.iter().map(|kink| match kink {
        Kink::Sign(_) => quote!(Kink::Sign),
        Kink::Radicand(_) => quote!(Kink::Radicand),
    });
    let (geometry, defaults) = (geometry::geometry(drawn), defaults(system));
    let closed = analysis.functions.phases.iter().map(contact_sets::set);
    let frictions = analysis.motion.frictions().map(|(contact, row)| {
        let follows_slip = analysis.motion.follows_slip(system, contact);
        let [contact, row] = [contact, row].map(count);
        quote!(Friction { contact: #contact, row: #row, follows_slip: #follows_slip })
    });
    // What a scene does not have is not named.
    let lists = [
        ("parameters", parameters.map(|name| name.to_token_stream()).collect()),
        ("dimensions", dimensions.collect()),
        ("coordinates", coordinates.collect()),
        ("dependent", dependent.collect()),
        ("contacts", contacts),
        ("joints", joints.collect()),
        ("tangents", tangents.iter().map(ToTokens::to_token_stream).collect()),
        ("frictions", frictions.collect()),
        ("switches", switches.collect()),
        ("signals", signals.collect()),
        ("kinks", kinks.collect()),
        ("quantities", quantities.collect()),
        ("points", points.map(ToTokens::to_token_stream).collect()),
        ("bars", bars.collect()),
        ("closed_forms", closed.collect()),
    ];
    let lists = lists.into_iter().filter(|(_, entries): &(_, Vec<TokenStream>)| !entries.is_empty());
    let lists = lists.map(|(field, entries)| {
        let field = format_ident!("{field}");
        quote!(.#field(&[#(#entries),*]))
    });
    let flags = [("covariant", covariant), ("timed", timed), ("compliant", compliant), ("loaded", loaded)];
    let flags = flags.into_iter().filter(|(_, holds)| *holds).map(|(field, _)| {
        let field = format_ident!("{field}");
        quote!(.#field(true))
    });
    quote! {
        Layout::new(#name)
            .declaration(#declaration)
            .summary(#summary)
            .defaults(#defaults)
            .geometry(#geometry)
            #(#lists)*
            #(#flags)*
    }
}

/// None where the powers do not fit a byte over a common denominator.
fn dimension(powers: Option<Dimension>) -> TokenStream {
    option(powers.and_then(in_bytes).map(|(numerators, denominator)| {
        let numerators = numerators.map(Literal::i8_unsuffixed);
        let denominator = Literal::i8_unsuffixed(denominator);
        quote!(Dimension::new([#(#numerators),*], #denominator))
    }))
}

fn contact_tokens(
    analysis: &Analysis,
    contact: &Contact,
    foot: Option<usize>,
    friction: Option<usize>,
) -> TokenStream {
    let label = contact.label(&analysis.system);
    let supports = contact.supports.iter().map(|&s| &analysis.system.supports[s].name);
    let shared = contact.shared;
    let support = contact.support(&analysis.system);
    let (rough, stop) = (support.rough, support.stop);
    let jams = support.friction.as_ref().is_some_and(|friction| friction.jams);
    let [armed, breaks] = [&support.armed, &support.breaks].map(|condition| option(condition.as_ref()));
    let kind = match () {
        () if contact.is_thread(&analysis.system) => quote!(Thread),
        () if contact.two_sided => match contact.force {
            Some([x, y]) => {
                let force = [x, y].map(count);
                quote!(Hinge { force: [#(#force),*] })
            }
            None => quote!(Guide),
        },
        () if contact.is_turned(&analysis.system) && contact.driven => quote!(Turn),
        () if contact.is_turned(&analysis.system) => quote!(AngleLimit),
        () if contact.driven => quote!(Drive),
        () => quote!(Support),
    };
    let law = match support.law {
        Law::Newton => quote!(Newton),
        Law::Moreau => quote!(Moreau),
        Law::Poisson => quote!(Poisson),
        Law::Stronge => quote!(Stronge),
    };
    let [foot, friction] = [foot, friction].map(option);
    quote! {
        Contact {
            label: #label,
            supports: &[#(#supports),*],
            shared: #shared,
            foot: #foot,
            kind: ContactKind::#kind,
            rough: #rough,
            friction: #friction,
            jams: #jams,
            law: Law::#law,
            stop: #stop,
            armed: #armed,
            breaks: #breaks,
        }
    }
}
