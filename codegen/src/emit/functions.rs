//! Functions of the full state.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};

use super::body::{self, Inputs};
use super::constants::UsedConstants;
use super::{count, variable};
use crate::Analysis;
use crate::algebra::Symbol;
use crate::functions::{Mass, Paths};
use crate::motion::Motion;
use crate::program::Id;

/// A state whose coordinates, rates and time are bound to their names.
pub(super) struct State<'a> {
    pub analysis: &'a Analysis,
    pub constants: &'a UsedConstants<'a>,
}

impl Inputs for State<'_> {
    fn input(&self, symbol: Symbol) -> TokenStream {
        match symbol {
            Symbol::Coordinate { index, order } => {
                let name = of_motion(self.analysis, index.into(), order);
                quote!(#name)
            }
            Symbol::Reaction(row) => {
                let name = multiplier(row.into());
                quote!(#name)
            }
            Symbol::Time => quote!(t),
            Symbol::Switch(i) => {
                let name = variable(&format!("s_{}", i + 1));
                quote!(#name)
            }
            Symbol::Parameter(_) | Symbol::Sense(_) | Symbol::Opaque { .. } => {
                quote!(compile_error!("not a state variable"))
            }
        }
    }

    fn constant(&self, id: Id) -> Option<TokenStream> {
        self.constants.field(id)
    }

    fn is_stored(&self, id: Id) -> bool {
        self.constants.contains(id)
    }
}

/// `q_phi`, `v_phi` or `a_phi`: coordinate, rate or acceleration.
fn of_motion(analysis: &Analysis, index: usize, order: u8) -> Ident {
    let name = &analysis.kinematics.coordinates[index].name;
    variable(&format!("{}_{name}", ["q", "v", "a"][usize::from(order)]))
}

/// `lambda_2` of row 2.
fn multiplier(row: usize) -> Ident {
    variable(&format!("lambda_{row}"))
}

/// The entries of a reduced state: coordinates, rates, and what else a state has.
#[derive(Clone, Copy)]
pub(crate) struct Entries<'a> {
    pub kept: &'a [usize],
    pub moving: &'a [usize],
    pub motion: &'a Motion,
}

impl Entries<'_> {
    pub fn len(&self) -> usize {
        self.kept.len() + self.moving.len() + self.motion.carried().count()
    }

    /// Where they are in a full state of `n` coordinates.
    pub fn places(&self, n: usize) -> Vec<Literal> {
        let rates = self.moving.iter().map(|i| n + i);
        let carried = 2 * n..self.motion.entries();
        self.kept.iter().copied().chain(rates).chain(carried).map(count).collect()
    }

    /// The time derivatives of what a state has beside coordinates and rates, as numbers.
    pub fn slopes(&self) -> impl Iterator<Item = TokenStream> + use<> {
        let slope = |symbol| count(usize::from(symbol == Symbol::Time));
        self.motion.carried().map(slope).map(|slope| quote!(S::ratio(#slope, 1)))
    }

    /// The state, or its derivative where `rates` is 2.
    pub fn symbols(&self, rates: u8) -> impl Iterator<Item = Symbol> {
        let symbol = |&index: &usize, order: u8| Symbol::Coordinate { index: index as u16, order };
        let kept = self.kept.iter().map(move |i| symbol(i, rates - 1));
        let moving = self.moving.iter().map(move |i| symbol(i, rates));
        kept.chain(moving).chain(self.motion.carried())
    }
}

/// A pattern that binds the symbols that are read; `_` for the others.
pub(super) fn pattern(
    state: &State,
    symbols: impl Iterator<Item = Symbol>,
    read: &BTreeSet<Symbol>,
) -> TokenStream {
    let places = symbols.map(|symbol| if read.contains(&symbol) { state.input(symbol) } else { quote!(_) });
    quote!([#(#places),*])
}

/// A function body that reads its `entries` from `state`; `result` is given the outputs.
pub(super) fn body(
    analysis: &Analysis,
    constants: &UsedConstants,
    entries: Entries,
    outputs: &[Id],
    result: impl FnOnce(&[TokenStream]) -> TokenStream,
) -> TokenStream {
    let inputs = State { analysis, constants };
    let program = &analysis.functions.program;
    let written = body::write(program, outputs, &inputs, &quote!(S));
    let (accelerations, others): (BTreeSet<Symbol>, BTreeSet<Symbol>) =
        written.inputs.iter().partition(|s| matches!(s, Symbol::Coordinate { order: 2, .. }));
    let state = (!others.is_empty()).then(|| {
        let pattern = pattern(&inputs, entries.symbols(1), &others);
        quote!(let #pattern = *state;)
    });
    let derivative = (!accelerations.is_empty()).then(|| {
        let pattern = pattern(&inputs, entries.symbols(2), &accelerations);
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

/// The associated types.
pub(super) fn types(analysis: &Analysis) -> TokenStream {
    let n = analysis.motion.n;
    let rows = analysis.motion.rows.len();
    let (reactions, unknowns) = (count(analysis.motion.reactions()), count(n + rows));
    let state = count(analysis.motion.entries());
    let points = count(analysis.functions.points.len());
    let feet = count(analysis.functions.feet.len());
    let (n, rows) = (count(n), count(rows));
    let parameters = count(analysis.system.parameters.len());
    quote! {
        type Parameters<S: Real> = [S; #parameters];
        type Constants<S: Real> = Constants<S>;
        type State<S: Real> = [S; #state];
        type Reactions<S: Real> = [S; #reactions];
        type Accelerations<S: Real> = [S; #n];
        type Multipliers<S: Real> = [S; #rows];
        type Kernel<S: Real> = Kernel<S, #n, #rows, #unknowns>;
        type Points<S: Real> = [S; #points];
        type Feet<S: Real> = [S; #feet];
    }
}

/// `kernel`, `energy`, `points` and `feet`, and `kinks` where there are any.
pub(super) fn methods(analysis: &Analysis, constants: &UsedConstants) -> TokenStream {
    let functions = &analysis.functions;
    let all: Vec<usize> = (0..analysis.motion.n).collect();
    let all = Entries { kept: &all, moving: &all, motion: &analysis.motion };
    let array = |results: &[TokenStream]| quote!([#(#results),*]);
    let points = body(analysis, constants, all, &functions.points, array);
    let feet = body(analysis, constants, all, &functions.feet, array);
    let energy = body(analysis, constants, all, &functions.energy, energies);
    let kernel = kernel(analysis, constants, all);
    let kinks: Vec<Id> = functions.kinks.iter().map(|kink| kink.value()).collect();
    let kinks = (!kinks.is_empty()).then(|| {
        let values = body(analysis, constants, all, &kinks, array);
        quote! {
            fn kinks<S: Real>(k: &Constants<S>, state: &Self::State<S>, kinks: &mut [S]) {
                kinks.copy_from_slice(&{ #values });
            }
        }
    });
    let slips = slips(analysis, constants, all);
    quote! {
        fn kernel<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Self::Kernel<S> { #kernel }
        fn energy<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Energy<S> { #energy }
        fn points<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Self::Points<S> { #points }
        fn feet<S: Real>(k: &Constants<S>, state: &Self::State<S>) -> Self::Feet<S> { #feet }
        #kinks
        #slips
    }
}

/// `slips`, where contacts have friction.
fn slips(analysis: &Analysis, constants: &UsedConstants, all: Entries) -> Option<TokenStream> {
    let outputs: Vec<Id> = analysis.functions.slips.iter().flatten().copied().collect();
    let values = body(analysis, constants, all, &outputs, |results| {
        let slips = results.chunks(3).map(|slip| match slip {
            [velocity, kinetic, limit] => {
                quote!(SlipState { velocity: #velocity, kinetic: #kinetic, limit: #limit })
            }
            _ => TokenStream::new(),
        });
        quote!([#(#slips),*])
    });
    (!outputs.is_empty()).then(|| {
        quote! {
            fn slips<S: Real>(k: &Constants<S>, state: &Self::State<S>, slips: &mut [SlipState<S>]) {
                slips.copy_from_slice(&{ #values });
            }
        }
    })
}

pub(super) fn energies(results: &[TokenStream]) -> TokenStream {
    let [kinetic, potential] = results else { return TokenStream::new() };
    quote!(Energy { kinetic: #kinetic, potential: #potential })
}

fn kernel(analysis: &Analysis, constants: &UsedConstants, all: Entries) -> TokenStream {
    let outputs = kernel_outputs(analysis);
    body(analysis, constants, all, &outputs, |results| kernel_of(analysis, results))
}

/// What a kernel is written from, in the order of [`kernel_of`].
pub(super) fn kernel_outputs(analysis: &Analysis) -> Vec<Id> {
    let kernel = &analysis.functions.kernel;
    let mut outputs = kernel.mass.written(kernel.force.len());
    outputs.extend(kernel.force.iter().chain(&kernel.gap));
    outputs.extend(kernel.jacobian.iter().flatten().chain(&kernel.bias).chain(&kernel.prescribed_gap_rate));
    outputs.extend(&kernel.friction);
    outputs
}

/// A kernel of these values.
pub(super) fn kernel_of(analysis: &Analysis, results: &[TokenStream]) -> TokenStream {
    let kernel = &analysis.functions.kernel;
    let (n, rows) = (kernel.force.len(), kernel.gap.len());
    let (mass, rest) = results.split_at(kernel.mass.written(n).len());
    let (force, rest) = rest.split_at(n);
    let (gap, rest) = rest.split_at(rows);
    let (jacobian, rest) = rest.split_at(rows * n);
    let (bias, rest) = rest.split_at(rows);
    let (prescribed, friction) = rest.split_at(rows);
    let grid = |entries: &[TokenStream]| {
        let rows = entries.chunks(n.max(1)).map(|row| quote!([#(#row),*]));
        quote!([#(#rows),*])
    };
    let jacobian = grid(jacobian);
    let mass = match &kernel.mass {
        Mass::Entries(_) => grid(mass),
        Mass::Paths(paths) => by_paths(analysis, paths, mass),
    };
    quote! {
        Kernel {
            mass: #mass,
            force: [#(#force),*],
            gap: [#(#gap),*],
            jacobian: #jacobian,
            bias: [#(#bias),*],
            prescribed_gap_rate: [#(#prescribed),*],
            friction: [#(#friction),*],
        }
    }
}

/// The products that a long tree's mass matrix is made of.
fn by_paths(analysis: &Analysis, paths: &Paths, factors: &[TokenStream]) -> TokenStream {
    let runtime = &analysis.system.runtime;
    let parents = paths.parents.iter().map(|parent| match parent.map(count) {
        Some(parent) => quote!(Some(#parent)),
        None => quote!(None),
    });
    let (vectors, own) = factors.split_at(4 * paths.own.len());
    let vectors: Vec<TokenStream> = vectors.chunks(2).map(|v| quote!([#(#v),*])).collect();
    let (reach, moments) = vectors.split_at(paths.own.len());
    quote!(#runtime::__private::kernel::mass_by_paths(&[#(#parents),*], &[#(#reach),*], &[#(#moments),*], &[#(#own),*]))
}
