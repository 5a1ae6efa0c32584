//! One set of functions per closed form, and the selection among them.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::constants::Constants;
use super::functions::{body, energies};
use crate::Analysis;
use crate::functions::PhaseFunctions;
use crate::program::Id;

/// The method `phase`, and the free functions it refers to.
pub(super) fn phases(analysis: &Analysis, constants: &Constants) -> (TokenStream, TokenStream) {
    let closed: Vec<(&PhaseFunctions, Ident)> =
        analysis.functions.phases.iter().map(|p| (p, module(analysis, p.set))).collect();
    let arms = closed.iter().map(|(phase, module)| {
        let set = phase.set;
        let n = 2 * phase.kept.len();
        let kept: Vec<usize> =
            phase.kept.iter().copied().chain(phase.kept.iter().map(|i| analysis.motion.n + i)).collect();
        quote! {
            (Form::Closed, #set) => visitor.visit::<#n>(Phase {
                set,
                form,
                derivative: #module::derivative,
                reactions: #module::reactions,
                embed: #module::embed,
                restrict: |state| [#(state[#kept]),*],
                pivot: #module::pivot,
                energy: #module::energy,
            }),
        }
    });
    let projected = projected(analysis);
    let selection = quote! {
        fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(
            set: ContactSet,
            form: Form,
            visitor: V,
        ) -> V::Output {
            match (form, set.0) {
                #(#arms)*
                _ => #projected,
            }
        }
    };
    let modules = closed.iter().map(|(phase, module)| functions(analysis, constants, phase, module));
    (selection, quote!(#(#modules)*))
}

fn module(analysis: &Analysis, set: u64) -> Ident {
    let labels: Vec<String> = analysis
        .motion
        .contacts
        .iter()
        .enumerate()
        .filter(|(i, _)| set >> i & 1 == 1)
        .map(|(_, contact)| contact.label(&analysis.system).replace(", ", "_").to_lowercase())
        .collect();
    if labels.is_empty() { format_ident!("free") } else { format_ident!("on_{}", labels.join("_and_")) }
}

/// All coordinates with multipliers for the closed rows.
fn projected(analysis: &Analysis) -> TokenStream {
    let runtime = &analysis.system.runtime;
    let contacts = analysis.motion.contacts.len();
    let n = 2 * analysis.motion.n;
    quote! {
        visitor.visit::<#n>(Phase {
            set,
            form: Form::Projected,
            derivative: |k, set, state| {
                #runtime::kernel::derivative(&Self::kernel(k, state), #contacts, set, state)
            },
            reactions: |k, set, state| {
                #runtime::kernel::reactions(&Self::kernel(k, state), #contacts, set)
            },
            embed: |_, state| *state,
            restrict: |state| *state,
            pivot: |_, _| S::ratio(1, 1),
            energy: Self::energy,
        })
    }
}

fn functions(
    analysis: &Analysis,
    constants: &Constants,
    phase: &PhaseFunctions,
    module: &Ident,
) -> TokenStream {
    let n = phase.kept.len();
    let (reduced, full) = (2 * n, 2 * analysis.motion.n);
    let contacts = analysis.motion.contacts.len();
    let of = |outputs: &[Id], result: &dyn Fn(&[TokenStream]) -> TokenStream| {
        body(analysis, constants, &phase.kept, outputs, |results| result(results))
    };
    let array = |results: &[TokenStream]| quote!([#(#results),*]);
    let derivative: Vec<Id> = phase.rates.iter().chain(&phase.accelerations).copied().collect();
    let derivative = of(&derivative, &array);
    let reactions = of(&phase.reactions, &array);
    let embed = of(&phase.embedding, &array);
    let pivots = of(&phase.pivots, &|results| quote!(least([#(#results),*])));
    let energy = of(&phase.energy, &energies);
    let runtime = &analysis.system.runtime;
    quote! {
        #[allow(unused_variables, unused_imports, reason = "a phase may not need its constants or its state")]
        mod #module {
            use super::Constants;
            use #runtime::model::*;
            use #runtime::scalar::{Real, Scalar};

            #[inline]
            pub fn derivative<S: Scalar>(k: &Constants<S>, _: ContactSet, state: &[S; #reduced]) -> [S; #reduced] {
                #derivative
            }
            pub fn reactions<S: Scalar>(k: &Constants<S>, _: ContactSet, state: &[S; #reduced]) -> [S; #contacts] {
                #reactions
            }
            pub fn embed<S: Scalar>(k: &Constants<S>, state: &[S; #reduced]) -> [S; #full] {
                #embed
            }
            pub fn pivot<S: Scalar>(k: &Constants<S>, state: &[S; #reduced]) -> S {
                #pivots
            }
            pub fn energy<S: Scalar>(k: &Constants<S>, state: &[S; #reduced]) -> Energy<S> {
                #energy
            }
        }
    }
}
