//! Improved senses against all modes.

use super::choices::choices;
use super::place::Place;
use super::{policy, search};
use crate::contact::ContactProblem;
use crate::contact::friction::Slip;
use crate::integration::phase_point::{Numbers, RunContext};
use crate::model::ContactSet;
use crate::prelude::*;
use crate::scales::scales_of;
use crate::system::Model;

/// A chain of five bars on a pin, pulled at its end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[bar(CD, mass = m, length = l)]
#[bar(DE, mass = m, length = l)]
#[bar(EF, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = mu, radius = r)]
#[hinge(B, friction = mu, radius = r)]
#[hinge(C, friction = mu, radius = r)]
#[hinge(D, friction = mu, radius = r)]
#[hinge(E, friction = mu, radius = r)]
#[force(F = (p, q))]
#[coordinate(a = angle(AB), from = down)]
#[coordinate(b = angle(BC), from = down)]
#[coordinate(c = angle(CD), from = down)]
#[coordinate(d = angle(DE), from = down)]
#[coordinate(e = angle(EF), from = down)]
#[figure(B = (0, -l), C = (0, -2 * l), D = (0, -3 * l), E = (0, -4 * l), F = (0, -5 * l))]
struct Chain {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    p: f64,
    q: f64,
    g: f64,
}

#[test]
fn what_is_improved_is_what_all_modes_have() {
    let mut seed = 5_u64;
    let mut between = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut improved, mut sticking) = (0, 0);
    for _ in 0..40 {
        let (mu, r) = (between(0.1, 2.0), between(0.02, 0.1));
        let [p, q] = [between(-20.0, 20.0), between(-20.0, 20.0)];
        let chain = Chain { m: 1.0, l: 1.0, mu, r, p, q, g: 9.81 };
        let model = Model::of(&chain);
        let scales = scales_of(&model).unwrap();
        let context = RunContext { model, scales, switches: Vec::new() };
        let spread = between(0.0, 0.4);
        let mut state = [0.0; 10];
        state[..5].iter_mut().for_each(|angle| *angle = between(-spread, spread));
        let hinges: ContactSet = (0..5).collect();
        let slips: Vec<(usize, Slip)> = (0..5).map(|hinge| (hinge, Slip::Rest)).collect();
        let question = ContactProblem { touching: hinges, slips: &slips, ..ContactProblem::default() };
        let place = Place::new(&context, Numbers::from_slice(&state));
        let options = choices(context.layout(), &question);
        let all = search::all(&place, &options);
        let [known] = &all[..] else { panic!("{} motions", all.len()) };
        if let Some(found) = search::improved(&place, &options, usize::MAX) {
            assert_eq!(found[0].set, known.set, "{state:?}");
            improved += 1;
        }
        sticking += known.set.iter().filter(|&i| known.set.slip(i) == crate::model::Slip::Stick).count();
    }
    // Some of all kinds.
    assert!(improved > 30 && sticking > 10 && sticking < 190, "{improved} {sticking}");
}

#[test]
fn all_senses_are_told_apart() {
    let mut senses: Vec<Vec<f64>> = policy::all(4).collect();
    senses.sort_by(|a, b| a.partial_cmp(b).unwrap());
    senses.dedup();
    assert_eq!(senses.len(), 81);
}
