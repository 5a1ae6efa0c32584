//! Layouts, numbers and equations at random states.

use super::{FORMS, each, noise, parameters, state};
use liftoff_core::model::{ContactSet, Energy, Layout, SlipState};
use liftoff_core::scalar::{DoubleDouble, Real, Scalar};
use liftoff_core::system::{Equations, Model, PhaseEquations, System, TimeSeries};
use std::sync::Arc;

#[test]
fn layouts_are_those_of_the_compiler() {
    each(|entry, interpreted| {
        // The compiler writes the same tokens with other blanks.
        let names = |layout: &Layout| format!("{:#?}", layout.declaration(""));
        let pair = [entry.layout(), interpreted.layout()].map(names);
        let differs = pair[0].lines().zip(pair[1].lines()).find(|(compiled, own)| compiled != own);
        assert!(differs.is_none() && pair[0].len() == pair[1].len(), "{}: {differs:?}", entry.name());
    });
}

#[test]
fn parameter_functions_agree() {
    each(|entry, interpreted| {
        let values = entry.default_run().parameters;
        let (compiled, own) =
            (entry.model(&values).unwrap(), interpreted.model(&parameters(entry.layout(), &values)));
        let of = |model: &Model| {
            format!("{:?}", (&model.nominal, &model.restitution, &model.measures, &model.numbers))
        };
        assert_eq!(of(&compiled), of(&own), "{}", entry.name());
    });
}

/// Within rounding of the largest of its kind; nothing is a number in one alone.
fn alike(what: &str, compiled: &[f64], own: &[f64]) {
    let size = compiled.iter().filter(|x| x.is_finite()).fold(0.0_f64, |most, x| most.max(x.abs()));
    assert_eq!(compiled.len(), own.len(), "{what}");
    for (i, (a, b)) in compiled.iter().zip(own).enumerate() {
        let close = a.to_bits() == b.to_bits() || (a - b).abs() <= 1e-12 * size || a.is_nan() && b.is_nan();
        assert!(close, "{what} [{i}]: {a:e} compiled, {b:e} interpreted");
    }
}

fn columns<S: Scalar>(equations: &Equations<S>, layout: &Layout) -> Vec<f64> {
    let mut values: Vec<S> =
        [equations.force(), equations.gap(), equations.bias(), equations.prescribed_gap_rate()].concat();
    (0..layout.coordinates.len()).for_each(|i| values.extend_from_slice(equations.mass(i)));
    (0..layout.rows()).for_each(|row| values.extend_from_slice(equations.jacobian(row)));
    values.into_iter().map(Scalar::to_f64).collect()
}

/// Everything that a system computes at a state.
fn of_system<S: Scalar>(system: &dyn System<S>, layout: &Layout, state: &[S]) -> Vec<f64> {
    let (n, rows, zero) = (layout.coordinates.len(), layout.rows(), S::ZERO);
    let mut values = columns(&system.equations(state), layout);
    let mut all = |computed: &[S]| values.extend(computed.iter().map(|x| x.to_f64()));
    let Energy { kinetic, potential } = system.energy(state);
    all(&[kinetic, potential]);
    let mut points = vec![zero; 2 * layout.points.len()];
    system.points(state, &mut points);
    let mut feet = vec![zero; 2 * layout.feet()];
    system.feet(state, &mut feet);
    let mut kinks = vec![zero; layout.kinks.len()];
    system.kinks(state, &mut kinks);
    let mut slips = vec![SlipState { velocity: zero, kinetic: zero, limit: zero }; layout.frictions.len()];
    system.slips(state, &mut slips);
    [points, feet, kinks].iter().for_each(|column| all(column));
    slips.iter().for_each(|slip| all(&[slip.velocity, slip.kinetic, slip.limit]));
    let accelerations: Vec<S> = (0..n).map(|i| S::ratio(i as i64 + 1, 3)).collect();
    let multipliers: Vec<S> = (0..rows).map(|i| S::ratio(2, i as i64 + 1)).collect();
    let quantities =
        (0..layout.quantities.len()).map(|entry| system.quantity(entry, state, &accelerations, &multipliers));
    all(&quantities.collect::<Vec<S>>());
    values
}

/// Everything that a phase computes at a state.
fn of_phase(phase: &dyn PhaseEquations, layout: &Layout, state: &[f64]) -> Vec<f64> {
    let entries = phase.info().entries;
    let mut y = vec![0.0; entries];
    phase.restrict(state, &mut y);
    let mut values = y.clone();
    let (mut f, mut reactions) = (vec![0.0; entries], vec![0.0; layout.reactions()]);
    for _ in 0..OFTEN {
        phase.derivative(&y, &mut f);
        phase.reactions(&y, &mut reactions);
    }
    let mut embedded = vec![0.0; layout.entries()];
    phase.embed(&y, &mut embedded);
    let Energy { kinetic, potential } = phase.energy(&y);
    [f, reactions, embedded, vec![kinetic, potential, phase.pivots(&y).least]]
        .iter()
        .for_each(|part| values.extend(part));
    if let Some(jacobian) = phase.jacobian() {
        let mut rows = vec![0.0; entries * entries];
        jacobian(&y, &mut rows);
        values.extend(rows);
    }
    if let Some(mut series) = phase.series() {
        (0..OFTEN).step_by(19).for_each(|_| series.expand(&y, 0.01, 20));
        values.extend(&series.series()[..21 * entries]);
        if let Some(guards) = series.guards(0.5) {
            (0..layout.reactions())
                .for_each(|i| values.extend(guards.reaction(i).iter().chain(guards.gap(i))));
        }
    }
    values
}

/// Runs after which what can be compiled for this processor is.
const OFTEN: usize = if cfg!(feature = "jit") { 300 } else { 1 };

/// The contact sets of closed forms, and those of up to two contacts.
fn sets(layout: &Layout) -> Vec<ContactSet> {
    let contacts = layout.contacts.len().min(6);
    let pairs = (0..contacts).flat_map(|i| (0..=i).map(move |j| ContactSet::EMPTY.with(i).with(j)));
    layout.closed_forms.iter().copied().chain([ContactSet::EMPTY]).chain(pairs).collect()
}

#[test]
fn equations_are_those_of_the_compiler() {
    each(|entry, interpreted| {
        let (layout, values) = (entry.layout(), entry.default_run().parameters);
        let compiled = entry.model(&values).unwrap();
        let own = interpreted.model(&parameters(layout, &values));
        let mut noise = noise(layout.declaration.len() as u64);
        for _ in 0..5 {
            let state = state(&compiled, layout, &mut noise);
            let of = |model: &Model| of_system(&*model.system, layout, &state);
            alike(entry.name(), &of(&compiled), &of(&own));
            for set in sets(layout) {
                for form in FORMS {
                    let [compiled, own] =
                        [&compiled, &own].map(|model| Arc::clone(&model.system).phase(set, form));
                    assert_eq!((compiled.info(), compiled.kept()), (own.info(), own.kept()));
                    let what = format!("{} {set:?} {form:?}", entry.name());
                    alike(&what, &of_phase(&*compiled, layout, &state), &of_phase(&*own, layout, &state));
                }
            }
        }
    });
}

#[test]
fn other_numbers_give_the_same() {
    each(|entry, interpreted| {
        let (layout, values) = (entry.layout(), entry.default_run().parameters);
        let (model, own) = (entry.model(&values).unwrap(), interpreted.model(&parameters(layout, &values)));
        let state = state(&model, layout, &mut noise(7));
        let varying = |(i, x): (usize, &f64)| TimeSeries::new([*x, 0.1 * i as f64, 0.3, -0.2]);
        let along: Vec<TimeSeries> = state.iter().enumerate().map(varying).collect();
        for k in 0..4 {
            let of = |equations: Equations<TimeSeries>| {
                let mut values = [equations.force(), equations.gap(), equations.bias()].concat();
                (0..layout.rows()).for_each(|row| values.extend_from_slice(equations.jacobian(row)));
                values.iter().map(|x| x.coefficient(k)).collect::<Vec<f64>>()
            };
            let [compiled, own] = [&model, &own].map(|model| model.series.equations(&along).map(of));
            assert_eq!(compiled.is_some(), own.is_some());
            if let (Some(compiled), Some(own)) = (compiled, own) {
                alike(entry.name(), &compiled, &own);
            }
        }
        let wide: Vec<DoubleDouble> = state.iter().map(|&x| DoubleDouble::from_f64(x)).collect();
        let precise = interpreted.precise(&parameters(layout, &values));
        alike(entry.name(), &of_system(&*model.system, layout, &state), &of_system(&*precise, layout, &wide));
    });
}
