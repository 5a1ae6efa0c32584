//! What depends on parameters only: the fields of the emitted `Constants`.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};

use super::body::{self, Inputs};
use crate::algebra::{Rational, Symbol};
use crate::program::{Id, Operation, Program};
use crate::syntax::plain;
use crate::system::System;

/// The constants that a model's functions use.
pub(super) struct Constants<'a> {
    program: &'a Program,
    fields: BTreeMap<Id, Ident>,
}

impl<'a> Constants<'a> {
    /// Collects what `outputs` use of the parameter-only part of `program`.
    pub(super) fn of(system: &System, program: &'a Program, outputs: &[Id]) -> Self {
        let mut taken: BTreeSet<String> = BTreeSet::new();
        let mut fields = BTreeMap::new();
        for id in program.used_constants(outputs).into_iter().filter(|&id| !is_number(program, id)) {
            let readable = readable(system, program, id);
            let numbered = (fields.len()..).map(|k| format!("k{k}"));
            let name = readable.into_iter().chain(numbered).find(|name| !taken.contains(name));
            let Some(name) = name else { continue };
            fields.insert(id, field(&name));
            taken.insert(name);
        }
        Self { program, fields }
    }

    /// The struct and the function that fills it.
    pub(super) fn tokens(&self) -> (TokenStream, TokenStream) {
        let names: Vec<&Ident> = self.fields.values().collect();
        let ids: Vec<Id> = self.fields.keys().copied().collect();
        let body = body::write(self.program, &ids, &Values, &quote!(S));
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
pub(super) struct Values;

impl Inputs for Values {
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

/// A field of this name, which may be a word of the language.
fn field(name: &str) -> Ident {
    syn::parse_str(name).unwrap_or_else(|_| Ident::new_raw(name, Span::call_site()))
}

fn is_number(program: &Program, id: Id) -> bool {
    match program.operation(id) {
        Operation::Ratio(_) | Operation::Pi => true,
        Operation::Input(_) => false,
        operation => operation.operands().all(|a| is_number(program, a)),
    }
}

/// `half_m_l_l` for ½ m l l; nothing for sums and longer products.
fn readable(system: &System, program: &Program, id: Id) -> Option<String> {
    let name = match program.operation(id) {
        Operation::Input(Symbol::Parameter(i)) => plain(system.parameters.get(usize::from(i))?),
        Operation::Mul(a, b) => {
            let (a, b) = if is_number(program, b) { (b, a) } else { (a, b) };
            format!("{}_{}", readable(system, program, a)?, readable(system, program, b)?)
        }
        Operation::Neg(a) => format!("minus_{}", readable(system, program, a)?),
        Operation::Ratio(value) if value.signum() < 0 => format!("minus_{}", number(-value)?),
        Operation::Ratio(value) => number(value)?.to_owned(),
        _ => return None,
    };
    (name.len() <= 24).then_some(name)
}

fn number(value: Rational) -> Option<&'static str> {
    let names = [
        (1, 1, "one"),
        (1, 2, "half"),
        (1, 3, "third"),
        (1, 4, "quarter"),
        (1, 6, "sixth"),
        (1, 12, "twelfth"),
        (2, 3, "two_thirds"),
        (4, 3, "four_thirds"),
        (3, 2, "three_halves"),
        (2, 1, "two"),
        (3, 1, "three"),
        (4, 1, "four"),
    ];
    names.iter().find(|(p, q, _)| value == Rational::new(*p, *q)).map(|(_, _, name)| *name)
}
