//! Random states of models and their contact sets.

use liftoff_core::model::{ContactSet, Layout, Slip};
use liftoff_core::system::Model;
use liftoff_models::models;

/// A number in −1..1.
pub fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// A model with the parameters of its default run.
pub fn model(name: &str) -> Model {
    let models = models();
    let entry = models.find(name).expect("a model");
    entry.model(&entry.default_run().parameters).expect("its own parameters")
}

/// Coordinates near the figure, any rates, then the time and what is switched.
pub fn state(model: &Model, seed: &mut u64) -> Vec<f64> {
    let layout = model.layout();
    let q: Vec<f64> = model.nominal.iter().map(|q| q + 0.3 * random(seed)).collect();
    let u: Vec<f64> = q.iter().map(|_| 2.0 * random(seed)).collect();
    layout.state_at(&[q, u].concat(), random(seed).abs())
}

/// The contact sets of the first contacts, those with friction now sticking, now sliding either
/// way; guides are always closed.
pub fn sets(layout: &Layout, seed: &mut u64) -> Vec<ContactSet> {
    let contacts = layout.contacts.len().min(4);
    let guides = |i: usize| layout.contacts[i].kind == liftoff_core::model::ContactKind::Guide;
    let all = (0_u64..1 << contacts).map(ContactSet::from_bits);
    let all = all.filter(|set| (0..layout.contacts.len()).all(|i| set.contains(i) || !guides(i)));
    all.map(|set| {
        let rough = layout.frictions.iter().filter(|friction| set.contains(friction.contact));
        rough.fold(set, |set, friction| {
            let slip =
                [Slip::Stick, Slip::Forward, Slip::Backward][(1.5 * (random(seed) + 1.0)) as usize % 3];
            set.slipping(friction.contact, slip)
        })
    })
    .collect()
}
