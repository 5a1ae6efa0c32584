//! The coordinates of the nominal figure.

use proc_macro2::TokenStream;

use super::body::FunctionBody;
use super::numbers::expressions;
use crate::Analysis;
use crate::numbers::{self, NominalDirection, NominalReading, NominalReference};

/// The body of `nominal`.
pub(super) fn nominal(analysis: &Analysis) -> TokenStream {
    let runtime = &analysis.system.runtime;
    let nominal = numbers::nominal(analysis);
    let FunctionBody { statements, results, .. } = expressions(analysis, &nominal.numbers);
    let between = |ends: [[usize; 2]; 2]| {
        let [[a, b], [c, d]] = ends.map(|place| place.map(|number| &results[number]));
        quote!(#runtime::__private::figure::direction([#a, #b], [#c, #d]))
    };
    let direction = |direction: &NominalDirection| {
        let (seen, own) = (between(direction.seen), direction.own.map(between));
        own.map_or_else(|| seen.clone(), |own| quote!(#seen - #own))
    };
    let values = nominal.readings.iter().map(|reading| {
        let (value, is_opposite) = match reading {
            NominalReading::Position { number, is_opposite } => (results[*number].clone(), is_opposite),
            NominalReading::Angle { from, to, is_opposite } => {
                let to = direction(to);
                let from = match from {
                    NominalReference::Ground(constant) => results[*constant].clone(),
                    NominalReference::Body(other) => direction(other),
                };
                (quote!(#runtime::__private::figure::wrapped(#to - (#from))), is_opposite)
            }
        };
        if *is_opposite { quote!(-(#value)) } else { value }
    });
    quote! {
        #statements
        [#(#values),*]
    }
}
