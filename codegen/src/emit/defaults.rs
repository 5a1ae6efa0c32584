//! What a run takes where nothing else is said.

use proc_macro2::TokenStream;

use super::option;
use crate::system::{StartValue, System};

/// `Defaults`.
pub(super) fn defaults(system: &System) -> TokenStream {
    let run = &system.run;
    if system.is_without_defaults() {
        return quote!(&Defaults::NONE);
    }
    let values = system.values.iter().map(|known| option(known.value));
    let units = system.values.iter().map(|known| &known.unit);
    let start = run.start.iter().map(|StartValue { name, value, .. }| quote!((#name, #value)));
    let (until, limit) = (&run.until, option(run.limit));
    quote! {
        &Defaults {
            values: &[#(#values),*],
            units: &[#(#units),*],
            start: &[#(#start),*],
            until: &[#(#until),*],
            limit: #limit,
        }
    }
}
