//! One set of functions per closed form, and the selection among them.

use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

use super::chain::by_loops;
use super::constants::UsedConstants;
use super::contact_sets::{bits, bits_method, set};
use super::count;
use super::functions::{Entries, body, energies};
use super::projected::{held_motions, projected};
use super::series;
use crate::Analysis;
use crate::functions::{PhaseFunctions, phase_names};
use crate::motion::UNROLLED;
use crate::program::Id;

/// The method `phase`, and the free functions it refers to.
pub(super) fn phases(analysis: &Analysis, constants: &UsedConstants) -> (TokenStream, TokenStream) {
    let names = phase_names(analysis).into_iter().map(|name| format_ident!("{name}"));
    let closed: Vec<(&PhaseFunctions, Ident)> = analysis.functions.phases.iter().zip(names).collect();
    let arms = closed.iter().map(|(phase, name)| {
        let set = bits(analysis, phase.set);
        let entries = entries(analysis, phase);
        let n = count(entries.len());
        let (coordinates, rate_count) = (count(phase.kept.len()), count(phase.moving.len()));
        let visit = if has_series(phase) { quote!(visit_series) } else { quote!(visit_closed) };
        let affine = analysis.functions.are_guards_affine(&analysis.motion, phase);
        let embed = if is_full(analysis, phase) { quote!(|_, state| *state) } else { quote!(#name::embed) };
        quote! {
            (Form::Reduced, ::core::option::Option::Some(#set)) => visitor.#visit::<#n, #name>(Phase {
                set,
                form,
                coordinates: #coordinates,
                rates: #rate_count,
                derivative: #name::derivative,
                reactions: #name::reactions,
                embed: #embed,
                restrict: <#name as ClosedForm<Self, #n>>::restrict,
                affine: #affine,
            }),
        }
    });
    let projected = projected(analysis);
    let bits = bits_method(analysis);
    let selection = quote! {
        fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(
            set: ContactSet,
            form: Form,
            visitor: V,
        ) -> V::Output {
            match (form, set.#bits()) {
                #(#arms)*
                _ => #projected,
            }
        }
    };
    let phases = closed.iter().map(|(phase, name)| {
        let functions = functions(analysis, constants, phase, name);
        let entries = entries(analysis, phase);
        let closed = closed_form(analysis, constants, phase, name);
        let series =
            has_series(phase).then(|| series::implementation(analysis, constants, phase, (name, entries)));
        quote!(#functions #closed #series)
    });
    let phases: TokenStream = phases
        .chain(held_motions(analysis, constants))
        .chain(series::of_kernel(analysis, constants))
        .collect();
    (selection, phases)
}

/// `ClosedForm` for the phase of this name.
fn closed_form(
    analysis: &Analysis,
    constants: &UsedConstants,
    phase: &PhaseFunctions,
    name: &Ident,
) -> TokenStream {
    let entries = entries(analysis, phase);
    let (model, set, n) = (super::model(), set(phase), count(entries.len()));
    let (coordinates, rates) = (count(phase.kept.len()), count(phase.moving.len()));
    let restrict = if is_full(analysis, phase) {
        quote!(*state)
    } else {
        let places = entries.places(analysis.motion.n);
        quote!([#(state[#places]),*])
    };
    let pivot = (!phase.pivots.is_empty()).then(|| {
        let collect = |results: &[TokenStream]| quote!(Pivots::collect([#(#results),*]));
        let pivots = body(analysis, constants, entries, &phase.pivots, collect);
        quote!(fn pivots<S: Scalar>(k: &Constants<S>, state: &[S; #n]) -> Pivots<S> { #pivots })
    });
    let energy = if is_full(analysis, phase) {
        quote!(<#model as BarSystem>::energy(k, state))
    } else {
        body(analysis, constants, entries, &phase.energy, energies)
    };
    quote! {
        impl ClosedForm<#model, #n> for #name {
            const COORDINATES: usize = #coordinates;
            const RATES: usize = #rates;
            #[inline(always)]
            fn derivative<S: Real>(k: &Constants<S>, state: &[S; #n]) -> [S; #n] {
                #name::derivative(k, &#set, state)
            }
            #[inline(always)]
            fn restrict<S: Real>(state: &<#model as BarSystem>::State<S>) -> [S; #n] {
                #restrict
            }
            #pivot
            fn energy<S: Real>(k: &Constants<S>, state: &[S; #n]) -> Energy<S> {
                #energy
            }
            fn fill<S: Real, T: Real>(k: &mut Constants<S>, of: &Constants<T>, put: impl Fn(&mut S, T)) {
                k.fill(of, put);
            }
        }
    }
}

/// Whether Taylor series are emitted for it: not beyond what is unrolled.
fn has_series(phase: &PhaseFunctions) -> bool {
    phase.moving.len() <= UNROLLED
}

/// Whether its state is the full one.
fn is_full(analysis: &Analysis, phase: &PhaseFunctions) -> bool {
    phase.moving.len() == analysis.motion.n
}

fn entries<'a>(analysis: &'a Analysis, phase: &'a PhaseFunctions) -> Entries<'a> {
    Entries { kept: &phase.kept, moving: &phase.moving, motion: &analysis.motion }
}

/// The results, and what stands for what else a state has.
fn with_carried(results: &[TokenStream], carried: impl Iterator<Item = TokenStream>) -> TokenStream {
    let results = results.iter().cloned().chain(carried);
    quote!([#(#results),*])
}

/// The derivative; of a chain of equal bars by loops.
fn derivative(analysis: &Analysis, constants: &UsedConstants, phase: &PhaseFunctions) -> TokenStream {
    let entries = entries(analysis, phase);
    let reduced = count(entries.len());
    let outputs: Vec<Id> = phase.rates.iter().chain(&phase.accelerations).copied().collect();
    let body = match &phase.chain {
        Some(chain) => by_loops(analysis, constants, chain, phase.kept.len()),
        None => {
            body(analysis, constants, entries, &outputs, |results| with_carried(results, entries.slopes()))
        }
    };
    quote! {
        #[inline(always)]
        fn derivative<S: Real>(k: &Constants<S>, _: &ContactSet, state: &[S; #reduced]) -> [S; #reduced] {
            #body
        }
    }
}

fn functions(
    analysis: &Analysis,
    constants: &UsedConstants,
    phase: &PhaseFunctions,
    name: &Ident,
) -> TokenStream {
    let entries = entries(analysis, phase);
    let full = count(analysis.motion.entries());
    let reduced = count(entries.len());
    let contacts = count(phase.reactions.len());
    let of = |outputs: &[Id], result: &dyn Fn(&[TokenStream]) -> TokenStream| {
        body(analysis, constants, entries, outputs, |results| result(results))
    };
    let array = |results: &[TokenStream]| quote!([#(#results),*]);
    let derivative = derivative(analysis, constants, phase);
    let reactions = of(&phase.reactions, &array);
    let carried = entries.len() - analysis.motion.carried().count()..entries.len();
    let carried = carried.map(|entry| quote!(state[#entry]));
    let embed = of(&phase.embedding, &|results| with_carried(results, carried.clone()));
    let reduction = (!is_full(analysis, phase)).then(|| {
        quote! {
            fn embed<S: Real>(k: &Constants<S>, state: &[S; #reduced]) -> [S; #full] {
                #embed
            }
        }
    });
    quote! {
        enum #name {}

        impl #name {
            #derivative
            fn reactions<S: Real>(k: &Constants<S>, set: &ContactSet, state: &[S; #reduced]) -> [S; #contacts] {
                #reactions
            }
            #reduction
        }
    }
}
