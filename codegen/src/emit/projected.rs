//! The form with all coordinates and multipliers for the closed rows: the runtime's dense solve, and without contacts what the
//! joints leave by emitted code.

use proc_macro2::TokenStream;
use quote::quote;

use super::constants::Constants;
use super::count;
use super::functions::{Entries, body};
use crate::Analysis;
use crate::program::Id;

/// All coordinates with multipliers for the closed rows.
pub(super) fn projected(analysis: &Analysis) -> TokenStream {
    let runtime = &analysis.system.runtime;
    let coordinates = count(analysis.motion.n);
    let n = count(2 * analysis.motion.n + usize::from(analysis.motion.is_timed()));
    let solved = quote! {
        #runtime::kernel::derivative(
            &<Self as BarSystem>::kernel(_k, _state),
            <Self as BarSystem>::LAYOUT,
            _set,
            _state,
        )
    };
    let derivative = match &analysis.functions.joint_solution {
        None => solved,
        Some(_) => quote! {
            let _solved = || #solved;
            if const { S::PLAIN } && _set.is_empty() {
                let (_derivative, _pivots) = JointSolution::derivative(_k, _state);
                #runtime::kernel::trusted(_derivative, &_pivots).unwrap_or_else(_solved)
            } else {
                _solved()
            }
        },
    };
    quote! {
        _visitor.visit::<#n>(Phase {
            set: _set,
            form: Form::Projected,
            coordinates: #coordinates,
            rates: #coordinates,
            derivative: |_k, _set, _state| { #derivative },
            reactions: |_k, _set, _state| {
                #runtime::kernel::reactions(
                    &<Self as BarSystem>::kernel(_k, _state),
                    <Self as BarSystem>::LAYOUT,
                    _set,
                )
            },
            embed: |_, _state| *_state,
            restrict: |_state| *_state,
        })
    }
}

/// The accelerations that the joints leave, with the pivots of their elimination.
pub(super) fn joint_solution(analysis: &Analysis, constants: &Constants) -> Option<TokenStream> {
    let joint_solution = analysis.functions.joint_solution.as_ref()?;
    let all: Vec<usize> = (0..analysis.motion.n).collect();
    let entries = Entries { kept: &all, moving: &all, timed: analysis.motion.is_timed() };
    let (n, joints) = (count(entries.len()), count(joint_solution.pivots.len()));
    let outputs = joint_solution
        .rates
        .iter()
        .chain(&joint_solution.accelerations)
        .chain(joint_solution.pivots.iter().flatten());
    let outputs: Vec<Id> = outputs.copied().collect();
    let body = body(analysis, constants, entries, &outputs, |results| {
        let (derivative, pivots) = results.split_at(2 * all.len());
        let time = entries.timed.then(|| quote!(S::ratio(1, 1)));
        let derivative = derivative.iter().chain(&time);
        let pivots = pivots.chunks(2).map(|pair| quote!([#(#pair),*]));
        quote!(([#(#derivative),*], [#(#pivots),*]))
    });
    Some(quote! {
        enum JointSolution {}

        impl JointSolution {
            fn derivative<S: Real>(_k: &Constants<S>, _state: &[S; #n]) -> ([S; #n], [[S; 2]; #joints]) {
                #body
            }
        }
    })
}
