//! The Taylor series of a closed form, and of the full equations: one function that serves every
//! order, `PhaseSeries::order` and `KernelSeries::order`.

mod waves;
mod writer;

use proc_macro2::{Ident, TokenStream};

use super::constants::UsedConstants;
use super::count;
use super::functions::{Entries, State, kernel_of, kernel_outputs, pattern};
use crate::Analysis;
use crate::functions::{PhaseFunctions, SeriesScope};
use crate::program::Id;
use writer::{Written, write};

/// `PhaseSeries` for the phase of this name.
pub(super) fn implementation(
    analysis: &Analysis,
    constants: &UsedConstants,
    phase: &PhaseFunctions,
    (name, entries): (&Ident, Entries),
) -> TokenStream {
    let functions = &analysis.functions;
    let along = functions.series(&analysis.motion, phase);
    let state = State { analysis, constants };
    let scope = SeriesScope { phase, program: &functions.program };
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

/// `KernelSeries`, where phases need it.
pub(super) fn of_kernel(analysis: &Analysis, constants: &UsedConstants) -> Option<TokenStream> {
    let phase = analysis.functions.projected.as_ref()?;
    let entries = Entries { kept: &phase.kept, moving: &phase.moving, motion: &analysis.motion };
    let state = State { analysis, constants };
    let scope = SeriesScope { phase, program: &analysis.functions.program };
    let kernel = kernel_outputs(analysis);
    let outputs: Vec<Id> = kernel.iter().chain(&analysis.functions.feet).copied().collect();
    let Written { statements, results, inputs, columns } = write(&scope, &state, &outputs);
    let (kernel, feet) = results.split_at(kernel.len());
    let kernel = kernel_of(analysis, kernel);
    let pattern = (!inputs.is_empty()).then(|| {
        let pattern = pattern(&state, entries.symbols(1), &inputs);
        quote!(let #pattern = *state;)
    });
    let [mass, jacobian] = analysis.functions.varying().map(|entries| {
        entries.into_iter().map(|[i, j]| [i, j].map(count)).map(|[i, j]| quote!([#i, #j])).collect::<Vec<_>>()
    });
    let (model, n, blocks) = (super::model(), count(entries.len()), count(columns.div_ceil(LANES)));
    Some(quote! {
        enum FullSeries {}

        impl KernelSeries<#model, #n> for FullSeries {
            const VARYING: Varying<'static> = Varying { mass: &[#(#mass),*], jacobian: &[#(#jacobian),*] };
            type Tape<S: Real> = Tape<S, #blocks>;
            #[inline(always)]
            fn order<S: Real, O: SeriesOps<S>>(
                k: &Constants<S>,
                order: &mut O,
                state: &[S; #n],
            ) -> (<#model as BarSystem>::Kernel<S>, <#model as BarSystem>::Feet<S>) {
                #pattern
                #statements
                (#kernel, [#(#feet),*])
            }
        }
    })
}

/// Columns of one block of a tape, `liftoff_core::series::LANES`.
const LANES: usize = 8;
