//! Chains of equal bars, by the runtime's loops.

use proc_macro2::TokenStream;

use super::constants::UsedConstants;
use super::functions::State;
use super::{body, count};
use crate::Analysis;
use crate::functions::Chain;

/// The derivative of a chain of equal bars.
pub(super) fn by_loops(
    analysis: &Analysis,
    constants: &UsedConstants,
    chain: &Chain,
    n: usize,
) -> TokenStream {
    let inputs = State { analysis, constants };
    let written = body::write(&analysis.functions.program, &chain.constants(), &inputs, &quote!(S));
    let (statements, runtime, n) = (&written.statements, &analysis.system.runtime, count(n));
    let [mass, length, inertia, x, y, slenderness, lever] = &written.results[..] else {
        return TokenStream::new();
    };
    // From both ends digits are lost where J is small beside m l².
    let method = if chain.is_uniform { quote!(accelerations) } else { quote!(articulated) };
    quote! {
        #statements
        let chain = #runtime::__private::chain::Chain::prepared(#mass, #length, #inertia, [#x, #y], #slenderness, #lever);
        let ([angles, rates], _) = state.as_chunks::<#n>() else { return *state };
        let accelerations = chain.#method(angles, rates);
        ::core::array::from_fn(|i| if i < #n { rates[i] } else { accelerations[i - #n] })
    }
}
