//! Contact sets as emitted code writes them.

use proc_macro2::{Literal, TokenStream};

use crate::Analysis;
use crate::functions::PhaseFunctions;
use crate::motion::ClosedSet;

/// The method of a contact set that tells its bits.
pub(super) fn bits_method(analysis: &Analysis) -> TokenStream {
    if analysis.functions.slips.is_empty() { quote!(bits) } else { quote!(bits_and_stick) }
}

/// The pattern of a contact set.
pub(super) fn bits(analysis: &Analysis, set: ClosedSet) -> TokenStream {
    let [closed, stick] = [set.closed, set.stick].map(Literal::u64_unsuffixed);
    if analysis.functions.slips.is_empty() { quote!(#closed) } else { quote!((#closed, #stick)) }
}

/// A phase's contact set.
pub(super) fn set(phase: &PhaseFunctions) -> TokenStream {
    let [closed, stick] = [phase.set.closed, phase.set.stick].map(Literal::u64_unsuffixed);
    match phase.set.stick {
        0 => quote!(ContactSet::from_bits(#closed)),
        _ => quote!(ContactSet::from_bits_and_stick(#closed, #stick)),
    }
}
