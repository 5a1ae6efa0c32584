//! Numbers that parameters determine: measures and restitution.

use proc_macro2::TokenStream;

use super::body::{self, FunctionBody, Inputs};
use super::constants::ParameterInputs;
use super::{count, variant};
use crate::Analysis;
use crate::algebra::Symbol;
use crate::numbers::{self, Measure, MeasureValue, Measures, ParameterProgram, Turned};
use crate::program::Id;
use crate::system::System;

/// Their expressions over `self` in `f64`.
pub(super) fn expressions(analysis: &Analysis, numbers: &ParameterProgram) -> FunctionBody {
    body::write(&numbers.program, &numbers.ids, &Fields { system: &analysis.system }, &quote!(f64))
}

/// Only where some contact is not plastic.
pub(super) fn restitution(analysis: &Analysis) -> Option<TokenStream> {
    let numbers = numbers::restitution(analysis)?;
    let FunctionBody { statements, results, .. } =
        body::write(&numbers.program, &numbers.ids, &ParameterInputs, &quote!(S));
    Some(quote! {
        fn restitution<S: Real>(p: &Self::Parameters<S>) -> Self::Reactions<S> {
            #statements
            [#(#results),*]
        }
    })
}

/// Parameters read from `self`.
struct Fields<'a> {
    system: &'a System,
}

impl Inputs for Fields<'_> {
    fn input(&self, symbol: Symbol) -> TokenStream {
        match symbol {
            Symbol::Parameter(i) => {
                let name = &self.system.parameters[usize::from(i)];
                quote!(f64::from_f64(self.#name))
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

/// `measures` and its type.
pub(super) fn measures(analysis: &Analysis) -> TokenStream {
    let Measures { numbers, entries, reads_figure } = numbers::measures(analysis);
    let FunctionBody { statements, results, .. } = expressions(analysis, &numbers);
    let length = count(entries.len());
    let nominal = reads_figure.then(|| quote!(let nominal = BarSystem::nominal(self);));
    let entries = entries.iter().map(|Measure { of, kind, value }| {
        let (kind, value) = (variant(kind), self::value(analysis, value, &results));
        quote!(Measure { of: #of, kind: MeasureKind::#kind, value: #value })
    });
    quote! {
        type Measures = [Measure; #length];
        fn measures(&self) -> Self::Measures {
            #statements
            #nominal
            [#(#entries),*]
        }
    }
}

fn value(analysis: &Analysis, value: &MeasureValue, numbers: &[TokenStream]) -> TokenStream {
    match value {
        MeasureValue::Number(k) => numbers[*k].clone(),
        MeasureValue::Quotient(a, b) => {
            let (a, b) = (&numbers[*a], &numbers[*b]);
            quote!((#a) / (#b))
        }
        MeasureValue::Branch([zero, other]) => {
            let [zero, other] = [zero, other].map(|angle| distance(analysis, angle, numbers));
            quote!(#other - #zero)
        }
    }
}

/// How far an angle is from zero in the figure.
fn distance(
    analysis: &Analysis,
    Turned { constant, terms }: &Turned,
    numbers: &[TokenStream],
) -> TokenStream {
    let (runtime, constant) = (&analysis.system.runtime, &numbers[*constant]);
    let terms = terms.iter().map(|&(i, k)| {
        let (i, k) = (count(i), f64::from(k));
        quote!(+ #k * nominal[#i])
    });
    quote!(#runtime::__private::figure::wrapped(#constant #(#terms)*).abs())
}
