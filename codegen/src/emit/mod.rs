//! The implementation of `BarSystem` as Rust. Decides nothing: every name and number comes from the stages before.

mod body;
mod chain;
mod constants;
mod description;
mod fallback;
mod functions;
mod geometry;
mod meaning;
mod names;
mod nominal;
mod numbers;
mod phases;
mod projected;
mod quantities;
mod series;
mod settled;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::Analysis;
use constants::Constants;

pub use fallback::fallback;

/// The implementation for an analysed model.
pub fn implementation(analysis: &Analysis) -> TokenStream {
    let runtime = &analysis.system.runtime;
    let ident = &analysis.system.ident;
    let constants =
        Constants::of(&analysis.system, &analysis.functions.program, &analysis.functions.outputs());
    let (definition, filled) = constants.tokens();
    let types = functions::types(analysis);
    let described = description::methods(analysis);
    let full = functions::methods(analysis, &constants);
    let names = names::constants(analysis);
    let quantity = quantities::method(analysis, &constants);
    let (selection, phases) = phases::phases(analysis, &constants);
    quote! {
        #[automatically_derived]
        #[allow(clippy::all, non_snake_case, non_camel_case_types, unused_parens, reason = "generated")]
        const _: () = {
            use #runtime::model::*;
            use #runtime::scalar::{Real, Scalar};

            #definition

            #names

            impl BarSystem for #ident {
                #types
                #described
                fn constants<S: Real>(&self) -> Constants<S> { #filled }
                #full
                #quantity
                #selection
            }

            #phases
        };
    }
}

/// A number without its type.
fn count(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}
