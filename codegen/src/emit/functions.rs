//! Functions of the full state.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::body::{self, Inputs};
use super::constants::Constants;
use super::count;
use crate::Analysis;
use crate::algebra::Symbol;
use crate::program::Id;

/// A state whose coordinates and rates are bound to their names.
pub(super) struct State<'a> {
    pub analysis: &'a Analysis,
    pub constants: &'a Constants<'a>,
}

impl Inputs for State<'_> {
    fn input(&self, symbol: Symbol) -> TokenStream {
        let Symbol::Coordinate { index, order } = symbol else {
            return quote!(compile_error!("not a state variable"));
        };
        let name = variable(self.analysis, index.into(), order);
        quote!(#name)
    }

    fn constant(&self, id: Id) -> Option<TokenStream> {
        self.constants.field(id)
    }

    fn is_stored(&self, id: Id) -> bool {
        self.constants.contains(id)
    }
}

/// `phi`, `phi_rate` or `phi_acceleration`.
fn variable(analysis: &Analysis, index: usize, order: u8) -> Ident {
    let name = &analysis.kinematics.coordinates[index].name;
    format_ident!("{name}{}", ["", "_rate", "_acceleration"][usize::from(order)])
}

/// A pattern for values in order of coordinate; `_` for those that are not read.
fn pattern(analysis: &Analysis, kept: &[usize], orders: [u8; 2], read: &BTreeSet<Symbol>) -> TokenStream {
    let places = orders.into_iter().flat_map(|order| kept.iter().map(move |&i| (i, order)));
    let places = places.map(|(i, order)| {
        let symbol = Symbol::Coordinate { index: i as u16, order };
        let name = variable(analysis, i, order);
        if read.contains(&symbol) { quote!(#name) } else { quote!(_) }
    });
    quote!([#(#places),*])
}

/// A function body that reads `kept` coordinates and their rates from `state`; `result` is given the outputs.
pub(super) fn body(
    analysis: &Analysis,
    constants: &Constants,
    kept: &[usize],
    outputs: &[Id],
    result: impl FnOnce(&[TokenStream]) -> TokenStream,
) -> TokenStream {
    let state = State { analysis, constants };
    let program = &analysis.functions.program;
    let written = body::write(program, outputs, &state, &quote!(S));
    let reads = |order| {
        written.inputs.iter().any(|s| matches!(s, Symbol::Coordinate { order: o, .. } if *o == order))
    };
    let state = (reads(0) || reads(1)).then(|| {
        let pattern = pattern(analysis, kept, [0, 1], &written.inputs);
        quote!(let #pattern = *state;)
    });
    let derivative = reads(2).then(|| {
        let pattern = pattern(analysis, kept, [1, 2], &accelerations(&written.inputs));
        quote!(let #pattern = Self::derivative(k, set, state);)
    });
    let (statements, result) = (written.statements, result(&written.results));
    quote! {
        #state
        #derivative
        #statements
        #result
    }
}

fn accelerations(read: &BTreeSet<Symbol>) -> BTreeSet<Symbol> {
    read.iter().copied().filter(|s| matches!(s, Symbol::Coordinate { order: 2, .. })).collect()
}

/// The associated types.
pub(super) fn types(analysis: &Analysis) -> TokenStream {
    let n = analysis.motion.n;
    let rows = analysis.motion.rows.len();
    let (contacts, unknowns, state) = (count(analysis.motion.contacts.len()), count(n + rows), count(2 * n));
    let points = count(analysis.functions.points.len());
    let feet = count(analysis.functions.feet.len());
    let (n, rows) = (count(n), count(rows));
    quote! {
        type Constants<S: Real> = Constants<S>;
        type State<S: Real> = [S; #state];
        type Reactions<S: Real> = [S; #contacts];
        type Accelerations<S: Real> = [S; #n];
        type Multipliers<S: Real> = [S; #rows];
        type Kernel<S: Real> = Kernel<S, #n, #rows, #unknowns>;
        type Points<S: Real> = [S; #points];
        type Feet<S: Real> = [S; #feet];
    }
}

/// `kernel`, `energy`, `points` and `feet`.
pub(super) fn methods(analysis: &Analysis, constants: &Constants) -> TokenStream {
    let functions = &analysis.functions;
    let all: Vec<usize> = (0..analysis.motion.n).collect();
    let array = |results: &[TokenStream]| quote!([#(#results),*]);
    let points = body(analysis, constants, &all, &functions.points, array);
    let feet = body(analysis, constants, &all, &functions.feet, array);
    let energy = body(analysis, constants, &all, &functions.energy, energies);
    let kernel = kernel(analysis, constants, &all);
    quote! {
        #[allow(unused_variables, reason = "a system may have constant equations")]
        fn kernel<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Self::Kernel<S> { #kernel }
        #[allow(unused_variables, reason = "energies may be zero")]
        fn energy<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Energy<S> { #energy }
        #[allow(unused_variables, reason = "points may be fixed")]
        fn points<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Self::Points<S> { #points }
        #[allow(unused_variables, reason = "there may be no feet")]
        fn feet<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Self::Feet<S> { #feet }
        fn quantity<S: Real>(
            _: &Constants<S>,
            _: usize,
            _: &Self::State<S>,
            _: &Self::Accelerations<S>,
            _: &Self::Multipliers<S>,
        ) -> S {
            S::from_f64(f64::NAN)
        }
    }
}

pub(super) fn energies(results: &[TokenStream]) -> TokenStream {
    let [kinetic, potential] = results else { return TokenStream::new() };
    quote!(Energy { kinetic: #kinetic, potential: #potential })
}

fn kernel(analysis: &Analysis, constants: &Constants, all: &[usize]) -> TokenStream {
    let kernel = &analysis.functions.kernel;
    let (n, rows) = (kernel.force.len(), kernel.gap.len());
    let mut outputs: Vec<Id> = Vec::new();
    for i in 0..n {
        outputs.extend((0..n).map(|j| kernel.mass[i.max(j)][i.min(j)]));
    }
    outputs.extend(kernel.force.iter().chain(&kernel.gap));
    outputs.extend(kernel.jacobian.iter().flatten().chain(&kernel.bias));
    body(analysis, constants, all, &outputs, |results| {
        let (mass, rest) = results.split_at(n * n);
        let (force, rest) = rest.split_at(n);
        let (gap, rest) = rest.split_at(rows);
        let (jacobian, bias) = rest.split_at(rows * n);
        let grid = |entries: &[TokenStream]| {
            let rows = entries.chunks(n.max(1)).map(|row| quote!([#(#row),*]));
            quote!([#(#rows),*])
        };
        let (mass, jacobian) = (grid(mass), grid(jacobian));
        let count = count(rows);
        quote! {
            Kernel {
                mass: #mass,
                force: [#(#force),*],
                gap: [#(#gap),*],
                jacobian: #jacobian,
                bias: [#(#bias),*],
                drift: [S::ratio(0, 1); #count],
            }
        }
    })
}
