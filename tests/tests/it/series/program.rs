//! The program of a model in jets, operation by operation.

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::elementary::Elementary;
use liftoff_codegen::functions::PhaseFunctions;
use liftoff_codegen::program::{Id, Operation, Program};
use liftoff_core::scalar::{Jet, Real};

use super::emitted::Series;

/// Values of `outputs`.
fn evaluate(program: &Program, outputs: &[Id], input: &dyn Fn(Symbol) -> Series) -> Vec<Series> {
    let mut values = vec![Jet::constant(f64::NAN); program.operations().len()];
    for id in program.reachable(outputs) {
        let at = |a: Id| values[a.index()];
        values[id.index()] = match program.operation(id) {
            Operation::Ratio(value) => Jet::constant(value.to_f64()),
            Operation::Pi => Jet::pi(),
            Operation::Input(symbol) => input(symbol),
            Operation::Add(a, b) => at(a) + at(b),
            Operation::Sub(a, b) => at(a) - at(b),
            Operation::Mul(a, b) => at(a) * at(b),
            Operation::Div(a, b) => at(a) / at(b),
            Operation::Neg(a) => -at(a),
            Operation::MulAdd(a, b, c) => at(a) * at(b) + at(c),
            Operation::Sqrt(a) => at(a).sqrt(),
            Operation::Sin(a) => at(a).sin_cos().0,
            Operation::Cos(a) => at(a).sin_cos().1,
            Operation::Elementary(Elementary::Exp, a) => at(a).exp(),
            Operation::Elementary(Elementary::Log, a) => at(a).ln(),
            Operation::Elementary(Elementary::Tanh, a) => at(a).tanh(),
            Operation::Elementary(Elementary::Atan, a) => at(a).atan(),
            Operation::Elementary(Elementary::Table(table), a) => at(a).spline(&table.knots, &table.pieces),
        };
    }
    outputs.iter().map(|id| values[id.index()]).collect()
}

/// Rates of the reduced state, reactions, gaps (zero where closed) and feet, as `PhaseSeries` gives
/// them.
pub fn terms(
    analysis: &Analysis,
    phase: &PhaseFunctions,
    parameters: &[f64],
    state: &[Series],
) -> [Vec<Series>; 4] {
    let (n, functions) = (analysis.motion.n, &analysis.functions);
    let (k, m) = (phase.kept.len(), phase.moving.len());
    let mut full = vec![Jet::constant(f64::NAN); 3 * n];
    phase.kept.iter().enumerate().for_each(|(place, &i)| full[i] = state[place]);
    phase.moving.iter().enumerate().for_each(|(place, &i)| full[n + i] = state[k + place]);
    let values = |full: &[Series], ids: &[Id]| {
        evaluate(&functions.program, ids, &|symbol| match symbol {
            Symbol::Parameter(i) => Jet::constant(parameters[usize::from(i)]),
            Symbol::Coordinate { index, order } => full[usize::from(index) + n * usize::from(order)],
            Symbol::Time => state[k + m],
            Symbol::Switch(i) => state[k + m + usize::from(analysis.motion.is_timed()) + usize::from(i)],
            Symbol::Reaction(_) | Symbol::Opaque { .. } | Symbol::Sense(_) => Jet::constant(f64::NAN),
        })
    };
    let embedded = values(&full, &phase.embedding);
    let accelerations = values(&full, &phase.accelerations);
    let mut rates = values(&full, &phase.rates);
    rates.extend(&accelerations);
    rates.extend(analysis.motion.carried().map(|symbol| Jet::constant(f64::from(symbol == Symbol::Time))));
    full[..2 * n].copy_from_slice(&embedded);
    phase.moving.iter().zip(&accelerations).for_each(|(&i, &a)| full[2 * n + i] = a);
    let mut gaps = values(&full, &functions.kernel.gap[..phase.reactions.len()]);
    let closed = |i: &usize| phase.set.closed >> i & 1 == 1;
    (0..gaps.len()).filter(closed).for_each(|i| gaps[i] = Jet::constant(0.0));
    [rates, values(&full, &phase.reactions), gaps, values(&full, &functions.feet)]
}
