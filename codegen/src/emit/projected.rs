//! The form with all coordinates and multipliers for the closed rows: the runtime's dense solve, and without contacts what the
//! joints leave by emitted code.

use proc_macro2::TokenStream;

use super::constants::Constants;
use super::count;
use super::functions::{Entries, body};
use crate::Analysis;
use crate::program::Id;

/// All coordinates with multipliers for the closed rows.
pub(super) fn projected(analysis: &Analysis) -> TokenStream {
    let runtime = &analysis.system.runtime;
    let coordinates = count(analysis.motion.n);
    let n = count(analysis.motion.entries());
    let (solved, reactions) = match analysis.motion.has_hinges() {
        true => (
            quote!(#runtime::hinge::derivative::<Self, S, #n>(k, set, state)),
            quote!(#runtime::hinge::reactions::<Self, S>(k, set, state)),
        ),
        false => {
            let kernel = quote!(&<Self as BarSystem>::kernel(k, state), <Self as BarSystem>::LAYOUT, set);
            (
                quote!(#runtime::kernel::derivative(#kernel, state)),
                quote!(#runtime::kernel::reactions(#kernel)),
            )
        }
    };
    let derivative = match &analysis.functions.joint_solution {
        None => solved,
        Some(_) => quote! {
            let solved = || #solved;
            if const { S::PLAIN } && set.is_empty() {
                let (derivative, pivots) = JointSolution::derivative(k, state);
                #runtime::kernel::trusted(derivative, &pivots).unwrap_or_else(solved)
            } else {
                solved()
            }
        },
    };
    let visit = match &analysis.functions.projected {
        None => quote!(visit::<#n>),
        Some(_) => quote!(visit_projected::<#n, FullSeries>),
    };
    quote! {
        visitor.#visit(Phase {
            set,
            form: Form::Projected,
            coordinates: #coordinates,
            rates: #coordinates,
            derivative: |k, set, state| { #derivative },
            reactions: |k, set, state| { #reactions },
            embed: |_, state| *state,
            restrict: |state| *state,
            affine: false,
        })
    }
}

/// The accelerations that the joints leave, with the pivots of their elimination.
pub(super) fn joint_solution(analysis: &Analysis, constants: &Constants) -> Option<TokenStream> {
    let joint_solution = analysis.functions.joint_solution.as_ref()?;
    let all: Vec<usize> = (0..analysis.motion.n).collect();
    let entries = Entries { kept: &all, moving: &all, motion: &analysis.motion };
    let (n, joints) = (count(entries.len()), count(joint_solution.pivots.len()));
    let outputs = joint_solution
        .rates
        .iter()
        .chain(&joint_solution.accelerations)
        .chain(joint_solution.pivots.iter().flatten());
    let outputs: Vec<Id> = outputs.copied().collect();
    let body = body(analysis, constants, entries, &outputs, |results| {
        let (derivative, pivots) = results.split_at(2 * all.len());
        let derivative = derivative.iter().cloned().chain(entries.slopes());
        let pivots = pivots.chunks(2).map(|pair| quote!([#(#pair),*]));
        quote!(([#(#derivative),*], [#(#pivots),*]))
    });
    Some(quote! {
        enum JointSolution {}

        impl JointSolution {
            fn derivative<S: Real>(k: &Constants<S>, state: &[S; #n]) -> ([S; #n], [[S; 2]; #joints]) {
                #body
            }
        }
    })
}
