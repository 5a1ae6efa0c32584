//! The implementation of `BarSystem` as Rust. Decides nothing: every name and number comes from the
//! stages before.

/// `quote::quote!` in mixed-site hygiene: the variables of emitted code are its own, whatever a
/// declaration calls its things; types and functions are found where the model stands.
macro_rules! quote {
    ($($code:tt)*) => { ::quote::quote_spanned!(::proc_macro2::Span::mixed_site()=> $($code)*) };
}

mod body;
mod chain;
mod constants;
mod contact_sets;
mod defaults;
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

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::format_ident;
use syn::Path;

use crate::Analysis;
use constants::UsedConstants;

pub use fallback::{fallback, unread};
pub(crate) use functions::Entries;

/// The implementation for an analysed model.
pub fn implementation(analysis: &Analysis) -> TokenStream {
    let model = model();
    let constants =
        UsedConstants::new(&analysis.system, &analysis.functions.program, &analysis.functions.outputs());
    let (definition, filled) = constants.tokens();
    let types = functions::types(analysis);
    let described = description::methods(analysis);
    let full = functions::methods(analysis, &constants);
    let names = names::constants(analysis);
    let quantity = quantities::method(analysis, &constants);
    let (selection, phases) = phases::phases(analysis, &constants);
    let items = quote! {
        #definition

        #names

        impl BarSystem for #model {
            #types
            #described
            #filled
            #full
            #quantity
            #selection
        }

        #phases
    };
    enclosed(&analysis.system.runtime, &analysis.system.ident, &items)
}

/// Items out of reach of all that is called alike outside: in the inner block only what it imports
/// is found first, so that the model and what stands beside it may have any name.
fn enclosed(runtime: &Path, ident: &Ident, items: &TokenStream) -> TokenStream {
    let model = model();
    quote! {
        #[automatically_derived]
        #[allow(
            clippy::all,
            non_snake_case,
            non_camel_case_types,
            uncommon_codepoints,
            mixed_script_confusables,
            unused_parens,
            unused_imports,
            unused_variables,
            reason = "generated"
        )]
        const _: () = {
            type #model = #ident;
            {
                use ::core::prelude::v1::*;
                use ::core::primitive::{bool, f64, i8, str, u8, u64, usize};
                use #runtime::__private::model::*;
                use #runtime::__private::model::variables::*;
                use #runtime::__private::scalar::{Real, Scalar};

                #items
            }
        };
    }
}

/// What the model is called inside.
fn model() -> Ident {
    format_ident!("__LiftoffModel")
}

/// A variable, in the hygiene of `quote!`.
fn variable(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// A variant without fields, which has the same name in the runtime.
fn variant(variant: &impl core::fmt::Debug) -> Ident {
    format_ident!("{variant:?}")
}

fn option(value: Option<impl quote::ToTokens>) -> TokenStream {
    match value {
        Some(value) => quote!(::core::option::Option::Some(#value)),
        None => quote!(::core::option::Option::None),
    }
}

/// A number without its type.
fn count(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}
