//! Chains of equal bars, by the runtime's loops.

use proc_macro2::TokenStream;
use quote::quote;

use super::constants::Constants;
use super::functions::State;
use super::{body, count};
use crate::Analysis;
use crate::functions::Chain;

/// The derivative of a chain of equal bars.
pub(super) fn by_loops(analysis: &Analysis, constants: &Constants, chain: &Chain, n: usize) -> TokenStream {
    let inputs = State { analysis, constants };
    let written = body::write(&analysis.functions.program, &chain.constants(), &inputs, &quote!(S));
    let (statements, runtime, n) = (&written.statements, &analysis.system.runtime, count(n));
    let [mass, length, inertia, x, y, slenderness, lever] = &written.results[..] else {
        return TokenStream::new();
    };
    quote! {
        #statements
        let _chain = #runtime::chain::Chain::prepared(#mass, #length, #inertia, [#x, #y], #slenderness, #lever);
        let _angles: [S; #n] = ::core::array::from_fn(|_i| _state[_i]);
        let _rates: [S; #n] = ::core::array::from_fn(|_i| _state[#n + _i]);
        let _accelerations = _chain.accelerations(&_angles, &_rates);
        ::core::array::from_fn(|_i| if _i < #n { _rates[_i] } else { _accelerations[_i - #n] })
    }
}
