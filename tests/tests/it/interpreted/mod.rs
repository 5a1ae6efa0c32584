//! Interpreted models against the compiled ones of the same declarations.

mod choices;
mod clutches;
mod equations;
mod guides;
mod runs;

use std::sync::Arc;

use liftoff_compiled::models;
use liftoff_core::model::{Form, Layout};
use liftoff_core::system::Model;
use liftoff_interpreter::Interpreted;
use liftoff_studio::registry::Entry;
use liftoff_studio::run_spec::Values;

/// Every model twice: compiled, and its declaration derived once more and interpreted.
fn each(mut compare: impl FnMut(&Entry, &Arc<Interpreted>)) {
    for entry in models().with(guides::models()).with(clutches::models()).with(choices::models()).iter() {
        let analysis = liftoff_codegen::analyse(entry.layout().declaration.parse().unwrap()).unwrap();
        compare(entry, &Interpreted::from_analysis(&analysis));
    }
}

/// Values of the parameters of the default run, in order.
fn parameters(layout: &Layout, values: &Values) -> Vec<f64> {
    let value = |name: &&str| values.iter().rev().find(|(given, _)| given == name).unwrap().1;
    layout.parameters.iter().map(value).collect()
}

/// Numbers between −1 and 1 that look random.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A state near the nominal figure.
fn state(model: &Model, layout: &Layout, noise: &mut impl FnMut() -> f64) -> Vec<f64> {
    let n = layout.coordinates.len();
    let coordinates = model.nominal.iter().map(|x| x + 0.1 * noise()).collect::<Vec<f64>>();
    coordinates.into_iter().chain((n..layout.entries()).map(|_| noise())).collect()
}

const FORMS: [Form; 2] = [Form::Reduced, Form::Multipliers];
