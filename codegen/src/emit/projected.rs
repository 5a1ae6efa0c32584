//! The form with all coordinates and multipliers for the closed rows: the runtime's dense solve,
//! and emitted code where a contact set has its own.

use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

use super::constants::UsedConstants;
use super::contact_sets::{bits, bits_method};
use super::count;
use super::functions::{Entries, body};
use crate::Analysis;
use crate::functions::{HeldMotion, phase_names};
use crate::program::Id;

/// All coordinates with multipliers for the closed rows.
pub(super) fn projected(analysis: &Analysis) -> TokenStream {
    let coordinates = count(analysis.motion.n);
    let n = count(analysis.motion.entries());
    let [derivative, reactions] = match analysis.functions.held.is_empty() {
        true => {
            let [derivative, reactions] = solved(analysis);
            [quote!(|k, set, state| { #derivative }), quote!(|k, set, state| { #reactions })]
        }
        false => {
            let own = |method: &Ident| {
                let arms = held(analysis).map(|(motion, name)| {
                    let set = bits(analysis, motion.set);
                    quote!(::core::option::Option::Some(#set) => #name::#method,)
                });
                let bits = bits_method(analysis);
                quote!(match set.#bits() { #(#arms)* _ => Held::#method })
            };
            ["derivative", "reactions"].map(|method| own(&format_ident!("{method}")))
        }
    };
    let visit = match &analysis.functions.projected {
        None => quote!(visit::<#n>),
        Some(_) => quote!(visit_projected::<#n, FullSeries>),
    };
    quote! {
        visitor.#visit(Phase {
            set,
            form: Form::Multipliers,
            coordinates: #coordinates,
            rates: #coordinates,
            derivative: #derivative,
            reactions: #reactions,
            embed: |_, state| *state,
            restrict: |state| *state,
            affine: false,
        })
    }
}

/// The derivative and the reactions in any contact set, by the runtime.
fn solved(analysis: &Analysis) -> [TokenStream; 2] {
    let runtime = &analysis.system.runtime;
    let n = count(analysis.motion.entries());
    if analysis.motion.has_hinges() {
        return [
            quote!(#runtime::__private::hinge::derivative::<Self, S, #n>(k, set, state)),
            quote!(#runtime::__private::hinge::reactions::<Self, S>(k, set, state)),
        ];
    }
    let model = super::model();
    let kernel = quote!(&<#model as BarSystem>::kernel(k, state), <#model as BarSystem>::LAYOUT, set);
    [
        quote!(#runtime::__private::kernel::derivative(#kernel, state)),
        quote!(#runtime::__private::kernel::reactions(#kernel)),
    ]
}

/// The motions with code of their own and what they are called.
fn held(analysis: &Analysis) -> impl Iterator<Item = (&HeldMotion, Ident)> {
    let names = phase_names(analysis).split_off(analysis.functions.phases.len());
    analysis.functions.held.iter().zip(names.into_iter().map(|name| format_ident!("{name}")))
}

/// What the phases without a closed form refer to.
pub(super) fn held_motions(analysis: &Analysis, constants: &UsedConstants) -> Option<TokenStream> {
    if analysis.functions.held.is_empty() {
        return None;
    }
    let n = count(analysis.motion.entries());
    let r = count(analysis.motion.reactions());
    let [derivative, reactions] = solved(analysis);
    let motions = held(analysis).map(|(motion, name)| held_motion(analysis, constants, motion, &name));
    Some(quote! {
        /// All coordinates, with multipliers for the closed rows, by elimination with partial
        /// pivoting.
        enum Held {}

        impl Held {
            fn derivative<S: Scalar>(k: &Constants<S>, set: &ContactSet, state: &[S; #n]) -> [S; #n] {
                #derivative
            }
            fn reactions<S: Scalar>(k: &Constants<S>, set: &ContactSet, state: &[S; #n]) -> [S; #r] {
                #reactions
            }
        }

        #(#motions)*
    })
}

/// The same of one contact set by code of its own, where its pivots can be trusted.
fn held_motion(
    analysis: &Analysis,
    constants: &UsedConstants,
    held: &HeldMotion,
    name: &Ident,
) -> TokenStream {
    let runtime = &analysis.system.runtime;
    let (n, r) = (count(analysis.motion.entries()), count(analysis.motion.reactions()));
    let pivots = count(held.solution.pivots.len());
    let solution = solution(analysis, constants, held);
    let is_free = held.set.closed == 0;
    let reactions = match is_free {
        true => quote!([S::ratio(0, 1); #r]),
        false => quote! {
            if const { S::PLAIN } {
                let (_, reactions, pivots) = Self::solution(k, state);
                if #runtime::__private::kernel::are_trusted(&pivots) {
                    return reactions;
                }
            }
            Held::reactions(k, set, state)
        },
    };
    quote! {
        /// M a = f + Jᵀ λ and J a + b = 0 over the closed rows, by L D Lᵀ written out; in the
        /// precision of f64, and where no pivot is a small part of what it is left of.
        enum #name {}

        impl #name {
            /// ẏ; the reactions; of each row of M that varies, and of each closed one, what it has
            /// on the diagonal of M or of J M⁻¹ Jᵀ, and the pivot that is left of it.
            #[inline]
            fn solution<S: Real>(k: &Constants<S>, state: &[S; #n]) -> ([S; #n], [S; #r], [[S; 2]; #pivots]) {
                #solution
            }
            fn derivative<S: Scalar>(k: &Constants<S>, set: &ContactSet, state: &[S; #n]) -> [S; #n] {
                if const { S::PLAIN } {
                    let (derivative, _, pivots) = Self::solution(k, state);
                    if #runtime::__private::kernel::are_trusted(&pivots) {
                        return derivative;
                    }
                }
                Held::derivative(k, set, state)
            }
            fn reactions<S: Scalar>(k: &Constants<S>, set: &ContactSet, state: &[S; #n]) -> [S; #r] {
                #reactions
            }
        }
    }
}

/// The body of `solution`.
fn solution(analysis: &Analysis, constants: &UsedConstants, held: &HeldMotion) -> TokenStream {
    let motion = &analysis.motion;
    let all: Vec<usize> = (0..motion.n).collect();
    let entries = Entries { kept: &all, moving: &all, motion };
    // The place among the reactions of each row that has one.
    let borne = motion.rows_of_reactions().map(|row| held.rows.iter().position(|&closed| closed == row));
    let borne: Vec<Option<usize>> = borne.collect();
    let multipliers = borne.iter().flatten().map(|&k| held.solution.multipliers[k]);
    let pivots = held.solution.pivots.as_flattened();
    let derivative = held.rates.iter().chain(&held.solution.accelerations);
    let outputs: Vec<Id> = derivative.chain(pivots).copied().chain(multipliers).collect();
    body(analysis, constants, entries, &outputs, |results| {
        let (derivative, rest) = results.split_at(2 * all.len());
        let (pivots, multipliers) = rest.split_at(pivots.len());
        let derivative = derivative.iter().cloned().chain(entries.slopes());
        let pivots = pivots.chunks(2).map(|pair| quote!([#(#pair),*]));
        let mut multipliers = multipliers.iter().cloned();
        let zero = || quote!(S::ratio(0, 1));
        let reactions = borne.iter().map(|row| row.and_then(|_| multipliers.next()).unwrap_or_else(zero));
        quote!(([#(#derivative),*], [#(#reactions),*], [#(#pivots),*]))
    })
}
