//! The Taylor series of a closed form: one function that serves every order, `PhaseSeries::order`.

mod scope;
mod waves;
mod writer;

use proc_macro2::{Ident, TokenStream};

use super::constants::Constants;
use super::count;
use super::functions::{Entries, State, pattern};
use crate::Analysis;
use crate::functions::PhaseFunctions;
use crate::motion::contains;
use crate::program::Id;
use scope::Scope;
use writer::{Written, write};

/// `PhaseSeries` for the phase of this name.
pub(super) fn implementation(
    analysis: &Analysis,
    constants: &Constants,
    phase: &PhaseFunctions,
    (name, entries): (&Ident, Entries),
) -> TokenStream {
    let functions = &analysis.functions;
    let (contacts, reactions) = (analysis.motion.contacts.len(), phase.reactions.len());
    let slides = |k: usize| {
        let contact = analysis.motion.frictions().nth(k).map(|(contact, _)| contact);
        contact.is_some_and(|i| contains(phase.set.closed, i) && !contains(phase.set.stick, i))
    };
    // Of the contacts the gaps of the open ones, then of those with friction the slip velocities of the sliding ones.
    let watched = |i: usize| i.checked_sub(contacts).map_or_else(|| !contains(phase.set.closed, i), slides);
    let watched_id = |i: usize| match i.checked_sub(contacts) {
        None => functions.kernel.gap[i],
        Some(k) => functions.slips[k][0],
    };
    let gaps = (0..reactions).filter(|&i| watched(i)).map(watched_id);
    let rates = phase.rates.iter().chain(&phase.accelerations);
    let outputs: Vec<Id> =
        rates.chain(&phase.reactions).copied().chain(gaps).chain(functions.feet.iter().copied()).collect();
    let state = State { analysis, constants };
    let scope = Scope { state: &state, phase, program: &functions.program };
    let Written { statements, results, inputs, columns } = write(&scope, &outputs);
    let (rates, rest) = results.split_at(phase.rates.len() + phase.accelerations.len());
    let (forces, rest) = rest.split_at(reactions);
    let (gaps, feet) = rest.split_at(rest.len() - functions.feet.len());
    let mut gaps = gaps.iter();
    let zero = quote!(S::ratio(0, 1));
    let gaps = (0..reactions).map(|i| if watched(i) { gaps.next().unwrap_or(&zero) } else { &zero });
    let time = entries.timed.then(|| quote!(order.constant(S::ratio(1, 1))));
    let rates = rates.iter().chain(&time);
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
