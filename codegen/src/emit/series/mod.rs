//! The Taylor series of a closed form: one function that serves every order, `PhaseSeries::order`.

mod waves;
mod writer;

use proc_macro2::{Ident, TokenStream};

use super::constants::Constants;
use super::count;
use super::functions::{Entries, State, pattern};
use crate::Analysis;
use crate::functions::{PhaseFunctions, Scope};
use writer::{Written, write};

/// `PhaseSeries` for the phase of this name.
pub(super) fn implementation(
    analysis: &Analysis,
    constants: &Constants,
    phase: &PhaseFunctions,
    (name, entries): (&Ident, Entries),
) -> TokenStream {
    let functions = &analysis.functions;
    let along = functions.series(&analysis.motion, phase);
    let state = State { analysis, constants };
    let scope = Scope { phase, program: &functions.program };
    let Written { statements, results, inputs, columns } = write(&scope, &state, &along.outputs());
    let (rates, rest) = results.split_at(along.rates.len());
    let (forces, rest) = rest.split_at(along.reactions.len());
    let (gaps, feet) = rest.split_at(rest.len() - along.feet.len());
    let (mut gaps, zero) = (gaps.iter(), quote!(S::ratio(0, 1)));
    let gaps = along.gaps.iter().map(|gap| gap.and_then(|_| gaps.next()).unwrap_or(&zero));
    let carried = entries.slopes().map(|slope| quote!(order.constant(#slope)));
    let rates = rates.iter().cloned().chain(carried);
    let pattern = (!inputs.is_empty()).then(|| {
        let pattern = pattern(&state, entries.symbols(1), &inputs);
        quote!(let #pattern = *state;)
    });
    let (model, n) = (super::model(), count(entries.len()));
    let (columns, blocks) = (count(columns), count(columns.div_ceil(LANES)));
    quote! {
        impl PhaseSeries<#model, #n> for #name {
            type Tape<S: Real> = Tape<S, #blocks>;
            type Columns<S: Real> = Columns<S, #columns>;
            #[inline(always)]
            fn order<S: Real, O: SeriesOps<S>>(
                k: &Constants<S>,
                order: &mut O,
                state: &[S; #n],
            ) -> TermsOf<#model, S, #n> {
                #pattern
                #statements
                Terms { rates: [#(#rates),*], reactions: [#(#forces),*], gaps: [#(#gaps),*], feet: [#(#feet),*] }
            }
        }
    }
}

/// Columns of one block of a tape, `liftoff::series::LANES`.
const LANES: usize = 8;
