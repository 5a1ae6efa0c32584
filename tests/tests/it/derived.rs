//! The paper's equations (3.1)–(3.22) against what was derived, through the compiled phases.
//!
//! Both sides are a few dozen operations in `f64` on well-conditioned expressions (0.1 ≤ φ ≤ 1.2),
//! hence 1e-12.

use approx::assert_relative_eq;
use liftoff::prelude::*;
use liftoff_compiled as models;
use liftoff_tests::{paper, random::Source};

const ROUNDING: f64 = 1e-12;

macro_rules! close {
    ($a:expr, $b:expr) => {
        assert_relative_eq!($a, $b, max_relative = ROUNDING, epsilon = ROUNDING)
    };
}

fn falling_pair() -> (models::FallingPair, paper::FallingPair) {
    let (m, l, g) = (1.3, 0.7, 9.81);
    (models::FallingPair { m, l, g }, paper::FallingPair { m, l, g })
}

#[test]
fn falling_pair_on_its_corners() {
    let (model, paper) = falling_pair();
    let phase = model.phase(&["P", "Q"]).unwrap();
    let mut source = Source::new(31);
    for _ in 0..100 {
        let (phi, rate) = (source.range(0.1, 1.2), source.range(-3.0, 3.0));
        let drop = paper.drop(phi);
        let drop_rate = 0.5 * paper.l * rate / phi.cos().powi(2);
        let state = [phi, drop, rate, drop_rate];
        close!(phase.reduced_accelerations(&state)[0], paper.acceleration_at(phi, rate));
        close!(phase.energy(&state).kinetic, paper.constrained_energy(phi, rate));
        close!(phase.reactions(&state)[0], 2.0 * paper.reaction(phi, rate));
        let rest = [phi, drop, 0.0, 0.0];
        let fallen = -phase.energy(&rest).potential;
        close!(fallen, paper.constrained_energy(phi, paper.rate_squared(phi).sqrt()));
    }
}

#[test]
fn falling_pair_in_flight() {
    let (model, paper) = falling_pair();
    let phase = model.phase(&[]).unwrap();
    let mut source = Source::new(32);
    for _ in 0..100 {
        let state: [f64; 4] = core::array::from_fn(|_| source.range(0.1, 1.4));
        let [phi, _, rate, drop_rate] = state;
        close!(phase.energy(&state).kinetic, paper.free_energy(phi, rate, drop_rate));
        let accelerations = phase.accelerations(&state);
        for (derived, published) in accelerations.iter().zip(paper.free_accelerations(phi, rate)) {
            close!(*derived, published);
        }
        close!(paper.free_residual(phi, rate, accelerations[0]), 0.0);
    }
}

fn zigzag(lambda: f64) -> (models::ZigzagPublished, paper::Zigzag) {
    let (m1, m2, l, g) = (1.0 - lambda, lambda, 0.7, 9.81);
    let start = core::f64::consts::FRAC_PI_2;
    (models::ZigzagPublished { m1, m2, l, g }, paper::Zigzag { m1, m2, l, g, start })
}

#[test]
fn zigzag_on_the_floor() {
    let mut source = Source::new(33);
    for lambda in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let (model, paper) = zigzag(lambda);
        let phase = model.phase(&["A", "C", "E"]).unwrap();
        for _ in 0..50 {
            let phi = source.range(0.1, 1.4);
            let rate = -paper.rate_squared(phi).sqrt();
            let state = [phi, 0.0, rate, 0.0];
            close!(phase.reduced_accelerations(&state)[0], paper.acceleration(phi));
            close!(phase.energy(&state).kinetic, paper.constrained_energy(phi, rate));
            close!(phase.energy(&state).kinetic, paper.work(phi));
            close!(phase.reactions(&state)[0], paper.reaction(phi));
        }
    }
}

#[test]
fn zigzag_in_flight() {
    let mut source = Source::new(34);
    for lambda in [0.25, 0.5, 0.75, 1.0] {
        let (model, paper) = zigzag(lambda);
        let phase = model.phase(&[]).unwrap();
        for _ in 0..50 {
            let (phi, rate, drop_rate) =
                (source.range(0.1, 0.6), source.range(-4.0, -0.5), source.range(-1.0, 1.0));
            let state = [phi, -0.1, rate, drop_rate];
            close!(phase.energy(&state).kinetic, paper.free_energy(phi, rate, drop_rate));
            let accelerations = phase.accelerations(&state);
            let h = paper.free_integral(phi, rate);
            close!(accelerations[0], paper.free_acceleration(h, phi));
            close!(accelerations[1], paper.free_drop_acceleration(h, phi));
            for residual in paper.free_residuals(phi, rate, [accelerations[0], accelerations[1]]) {
                close!(residual, 0.0);
            }
        }
    }
}
