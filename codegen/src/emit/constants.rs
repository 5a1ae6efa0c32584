//! What depends on parameters only: the fields of the emitted `Constants`.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};

use super::body::{self, Inputs};
use crate::algebra::Symbol;
use crate::functions::constant_names;
use crate::program::{Id, Program};
use crate::syntax::ident;
use crate::system::System;

/// The constants that a model's functions use.
pub(super) struct UsedConstants<'a> {
    program: &'a Program,
    fields: BTreeMap<Id, Ident>,
}

impl<'a> UsedConstants<'a> {
    /// Collects what `outputs` use of the parameter-only part of `program`.
    pub(super) fn new(system: &System, program: &'a Program, outputs: &[Id]) -> Self {
        let names = constant_names(system, program, outputs);
        Self { program, fields: names.into_iter().map(|(id, name)| (id, ident(&name))).collect() }
    }

    /// The struct and the function that fills it.
    pub(super) fn tokens(&self) -> (TokenStream, TokenStream) {
        let names: Vec<&Ident> = self.fields.values().collect();
        let ids: Vec<Id> = self.fields.keys().copied().collect();
        let body = body::write(self.program, &ids, &ParameterInputs, &quote!(S));
        let (statements, results) = (body.statements, body.results);
        let empty = names.is_empty();
        let marker = empty.then(|| quote!(scalar: ::core::marker::PhantomData<S>));
        let mark = empty.then(|| quote!(scalar: ::core::marker::PhantomData));
        let definition = quote! {
            /// Parameters and their products, computed once.
            #[derive(::core::clone::Clone, ::core::fmt::Debug)]
            pub struct Constants<S> { #(#names: S,)* #marker }

            impl<S: Real> Constants<S> {
                fn fill<T: Real>(&mut self, of: &Constants<T>, put: impl Fn(&mut S, T)) {
                    #(put(&mut self.#names, of.#names);)*
                }
            }
        };
        let filled = quote! {
            fn constants_of<S: Real>(p: &Self::Parameters<S>, set: &ContactSet) -> Constants<S> {
                #statements
                Constants { #(#names: #results,)* #mark }
            }
        };
        (definition, filled)
    }

    /// Whether `id` is stored.
    pub(super) fn contains(&self, id: Id) -> bool {
        self.fields.contains_key(&id)
    }

    /// The field of a stored constant.
    pub(super) fn field(&self, id: Id) -> Option<TokenStream> {
        self.fields.get(&id).map(|name| quote!(k.#name))
    }
}

/// Values of the parameters, `p`, and the senses of what slides in `set`.
pub(super) struct ParameterInputs;

impl Inputs for ParameterInputs {
    fn input(&self, symbol: Symbol) -> TokenStream {
        match symbol {
            Symbol::Parameter(i) => {
                let place = super::count(i.into());
                quote!(p[#place])
            }
            Symbol::Sense(contact) => {
                let contact = super::count(contact.into());
                quote!(S::ratio(set.sense(#contact), 1))
            }
            _ => quote!(compile_error!("not a parameter")),
        }
    }

    fn constant(&self, _: Id) -> Option<TokenStream> {
        None
    }

    fn is_stored(&self, _: Id) -> bool {
        false
    }
}
