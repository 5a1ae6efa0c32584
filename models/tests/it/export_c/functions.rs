//! What the program says of a state, for the library to say too.

use super::expected::{Expected, expected};
use liftoff_codegen::Analysis;
use liftoff_codegen::functions::PhaseFunctions;
use liftoff_codegen::program::Id;
use liftoff_core::model::{ContactSet, Form};
use liftoff_core::system::Model;
use std::sync::Arc;

/// What the compiled model says at a full state.
pub fn compiled(model: &Model, set: ContactSet, state: &[f64]) -> Vec<Expected> {
    let (n, rows) = (model.layout().coordinates.len(), model.system.equations(state).gap().len());
    let motion = |state: &[f64]| {
        let (mut accelerations, mut multipliers) = (vec![0.0; n], vec![0.0; rows]);
        model.system.solve(state, set, &mut accelerations, &mut multipliers);
        [accelerations, multipliers]
    };
    let points = |state: &[f64]| {
        let mut points = vec![0.0; 2 * model.layout().points.len()];
        model.system.points(state, &mut points);
        points
    };
    let energy = |state: &[f64]| {
        let energy = model.system.energy(state);
        vec![energy.kinetic, energy.potential]
    };
    vec![
        expected("accelerations", state, &|state| motion(state)[0].clone()),
        expected("multipliers", state, &|state| motion(state)[1].clone()),
        expected("gaps", state, &|state| model.system.equations(state).gap().to_vec()),
        expected("energy", state, &energy),
        expected("points", state, &points),
    ]
}

/// What it says of a contact set in closed form; nothing where it has none.
pub fn in_closed_form(model: &Model, set: ContactSet, state: &[f64]) -> Vec<Expected> {
    let phase = Arc::clone(&model.system).phase(set, Form::Reduced);
    let info = phase.info();
    if info.form != Form::Reduced {
        return Vec::new();
    }
    let layout = model.layout();
    let restricted = |state: &[f64]| {
        let mut y = vec![0.0; info.entries];
        phase.restrict(state, &mut y);
        y
    };
    let written = |size: usize, write: &dyn Fn(&[f64], &mut [f64]), state: &[f64]| {
        let mut out = vec![0.0; size];
        write(&restricted(state), &mut out);
        out
    };
    let derivative = |y: &[f64], out: &mut [f64]| phase.derivative(y, out);
    let reactions = |y: &[f64], out: &mut [f64]| phase.reactions(y, out);
    let embedding = |y: &[f64], out: &mut [f64]| phase.embed(y, out);
    vec![
        expected("restriction", state, &restricted),
        expected("derivative", state, &|state| written(info.entries, &derivative, state)),
        expected("reactions", state, &|state| {
            written(layout.contacts.len() + layout.frictions.len(), &reactions, state)
        }),
        expected("embedding", state, &|state| written(layout.entries(), &embedding, state)),
    ]
}

/// The same by the interpreter of the operations that the library is written from.
pub fn interpreted(analysis: &Analysis, model: &Model, set: ContactSet, state: &[f64]) -> Vec<Expected> {
    let (layout, n) = (model.layout(), model.layout().coordinates.len());
    let rows = analysis.motion.rows.len();
    let inputs = |state: &[f64], accelerations: &[f64]| {
        let senses = (0..layout.contacts.len()).map(|i| set.sense(i) as f64);
        let time = if layout.timed { state[2 * n] } else { f64::NAN };
        let carried = 2 * n + usize::from(layout.timed);
        let mut all = [&state[..2 * n], accelerations, &vec![f64::NAN; rows][..], &[time]].concat();
        all.extend(senses.chain(state[carried..].iter().copied()));
        all
    };
    let evaluate = |outputs: &[Id], state: &[f64], accelerations: &[f64]| {
        analysis.evaluate(outputs, &model.parameters, &inputs(state, accelerations))
    };
    let none = vec![f64::NAN; n];
    let functions = &analysis.functions;
    let mut all = vec![
        expected("gaps", state, &|state| evaluate(&functions.kernel.gap, state, &none)),
        expected("energy", state, &|state| evaluate(&functions.energy, state, &none)),
        expected("points", state, &|state| evaluate(&functions.points, state, &none)),
    ];
    let bits = set.bits_and_stick();
    let is_it = |phase: &&PhaseFunctions| bits == Some((phase.set.closed, phase.set.stick));
    let Some(phase) = functions.phases.iter().find(is_it) else {
        return all;
    };
    let accelerations = |state: &[f64]| evaluate(&phase.accelerations, state, &none);
    let carried: Vec<f64> =
        (2 * n..state.len()).map(|i| f64::from(u8::from(layout.timed && i == 2 * n))).collect();
    let rates: Vec<Id> = phase.rates.clone();
    all.push(expected("derivative", state, &|state| {
        [evaluate(&rates, state, &none), accelerations(state), carried.clone()].concat()
    }));
    all.push(expected("reactions", state, &|state| {
        let mut full = none.clone();
        for (&i, a) in phase.moving.iter().zip(accelerations(state)) {
            full[i] = a;
        }
        evaluate(&phase.reactions, state, &full)
    }));
    all.push(expected("embedding", state, &|state| {
        [evaluate(&phase.embedding, state, &none), state[2 * n..].to_vec()].concat()
    }));
    all
}

/// Whether the multipliers of a contact set are the only ones.
pub fn is_unique(model: &Model, set: ContactSet, state: &[f64]) -> bool {
    let rows = model.system.equations(state).gap().len();
    let (mut a, mut l) = (vec![0.0; model.layout().coordinates.len()], vec![0.0; rows]);
    model.system.solve(state, set, &mut a, &mut l) && a.iter().all(|a| a.is_finite())
}
