//! Names and parameters.

use proc_macro2::TokenStream;
use quote::quote;

use super::numbers::{measures, restitution};
use super::{nominal, scenery};
use crate::Analysis;
use crate::motion::Contact;
use crate::system::Law;

/// The layout and the methods that need no equations.
pub(super) fn methods(analysis: &Analysis) -> TokenStream {
    let layout = layout(analysis);
    let fields = &analysis.system.parameters;
    let indices = 0..fields.len();
    let (measures, scenery) = (measures(analysis), scenery::scenery(analysis));
    let nominal = nominal::nominal(analysis);
    let restitution = restitution(analysis);
    quote! {
        const LAYOUT: &'static Layout = &#layout;
        fn parameters(&self) -> Self::Parameters { [#(self.#fields),*] }
        fn from_parameters(values: &[f64]) -> Self { Self { #(#fields: values[#indices]),* } }
        #measures
        #restitution
        #scenery
        fn nominal(&self) -> Self::Accelerations<f64> { #nominal }
    }
}

fn layout(analysis: &Analysis) -> TokenStream {
    let (system, kinematics) = (&analysis.system, &analysis.kinematics);
    let (name, declaration, summary) = (system.ident.to_string(), &system.declaration, &system.summary);
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
            summary: #summary,
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
