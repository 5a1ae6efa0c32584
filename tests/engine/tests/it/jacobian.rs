//! The Jacobian of a phase against central differences of the same phase in double-double.

use liftoff::contact_set;
use liftoff::method::Radau;
use liftoff::prelude::*;
use liftoff_core::model::Form;
use liftoff_core::scalar::{DoubleDouble, Real, Scalar};
use liftoff_core::system::{Model, precise};
use liftoff_fixtures::FallingPair;
use liftoff_fixtures::SpringPendulum;
use std::sync::Arc;

/// Two bars under corners with a spring and damper between their outer ends.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[spring(AB, stiffness = k, length = l, damping = c)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
struct SprungPair {
    m: f64,
    l: f64,
    g: f64,
    k: f64,
    c: f64,
}

/// A block on rough corners, its centre held by a spring.
#[derive(BarSystem)]
#[gravity(g)]
#[body(block, points(G = (0, 0), A = (-b, -h), B = (b, -h)), mass = m, inertia = m * (b * b + h * h) / 3, centre = (0, 0))]
#[ground(O = (0, 2 * h))]
#[spring(OG, stiffness = k, damping = c)]
#[support(A = floor, rough)]
#[support(B = floor, rough)]
#[figure(A = (-b, 0), B = (b, 0))]
#[coordinate(x = x(G))]
#[coordinate(y = y(G))]
#[coordinate(theta = angle(block), from = right)]
struct SprungBlock {
    m: f64,
    b: f64,
    h: f64,
    g: f64,
    k: f64,
    c: f64,
}

/// Four bars in the shape of an M, the outer ones perhaps without mass, with spring hinges beside
/// the middle.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m2, length = l)]
#[bar(BC, mass = m1, length = l)]
#[bar(CD, mass = m1, length = l)]
#[bar(DE, mass = m2, length = l)]
#[torsion(AB, BC, stiffness = k, damping = c)]
#[torsion(CD, DE, stiffness = k, damping = c)]
#[support(A = floor)]
#[support(C = floor)]
#[support(E = floor)]
#[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
#[coordinate(phi_inner = angle(CD), from = horizontal)]
#[coordinate(phi_outer = angle(DE), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
struct SprungZigzag {
    m1: f64,
    m2: f64,
    l: f64,
    g: f64,
    k: f64,
    c: f64,
}

/// Compares the Jacobian at a full state with differences over ±1e-10, whose error is some 1e-20 by
/// truncation and 1e-32/1e-10 by rounding; how many entries the phase has.
fn compare<M: BarSystem>(model: &M, closed: &[&str], form: Form, state: &[f64]) -> usize {
    let set = contact_set(M::LAYOUT, closed).unwrap();
    let lifted = Model::new(model);
    let phase = Arc::clone(&lifted.system).phase(set, form);
    let wide = precise::<M>(&lifted.parameters).phase(set, form);
    let n = phase.info().entries;
    let (mut y, mut exact) = (vec![0.0; n], vec![0.0; n * n]);
    phase.restrict(state, &mut y);
    phase.jacobian().expect("a model with springs has one")(&y, &mut exact);
    let step = DoubleDouble::from_f64(1e-10);
    for j in 0..n {
        let f = |h: DoubleDouble| {
            let mut moved: Vec<_> = y.iter().map(|&y| DoubleDouble::from_f64(y)).collect();
            moved[j] = moved[j] + h;
            let mut f = moved.clone();
            wide.derivative(&moved, &mut f);
            f
        };
        let (plus, minus) = (f(step), f(-step));
        let slope = |i: usize| ((plus[i] - minus[i]) / (step + step)).to_f64();
        let size = (0..n).fold(1.0, |most: f64, i| most.max(slope(i).abs()));
        for i in 0..n {
            // Some hundred roundings of an elimination whose pivots are of order 1e-2 and larger.
            let error = (exact[i * n + j] - slope(i)).abs();
            assert!(error < 1e-12 * size, "{set:?} {form:?} [{i}][{j}]: {error:e}");
        }
    }
    n
}

#[test]
fn of_closed_and_projected_forms() {
    let pair = SprungPair { m: 2.0, l: 0.5, g: 9.81, k: 300.0, c: 7.0 };
    let state = [0.6, -0.17, 1.7, -0.6];
    assert_eq!(compare(&pair, &["P", "Q"], Form::Reduced, &state), 2);
    assert_eq!(compare(&pair, &["P", "Q"], Form::Multipliers, &state), 4);
    assert_eq!(compare(&pair, &[], Form::Multipliers, &state), 4);
    let block = SprungBlock { m: 2.0, b: 0.3, h: 0.5, g: 9.81, k: 50.0, c: 3.0 };
    assert_eq!(compare(&block, &["A"], Form::Multipliers, &[0.1, 0.5, 0.2, -0.3, 0.4, 1.1]), 6);
}

/// Without mass in the outer bars M is singular, and definite only on what the closed contacts
/// leave free.
#[test]
fn of_massless_bars() {
    let zigzag = SprungZigzag { m1: 1.0, m2: 0.0, l: 1.0, g: 9.81, k: 2.0, c: 0.3 };
    let state = [0.7, 0.5, 0.1, 0.4, -0.3, 0.2];
    for labels in [&["C", "A", "E"][..], &["A", "E"]] {
        assert_eq!(compare(&zigzag, labels, Form::Multipliers, &state), 6);
        compare(&zigzag, labels, Form::Reduced, &state);
    }
}

/// Nothing of rigid bars on supports is stiff: there Radau takes differences, and Newton's
/// iteration meets the same error.
#[test]
fn rigid_bars_have_none_and_need_none() {
    let pair = FallingPair { m: 2.0, l: 0.5, g: 9.81 };
    let lifted = Model::new(&pair);
    let set = contact_set(FallingPair::LAYOUT, &["P", "Q"]).unwrap();
    assert!(Arc::clone(&lifted.system).phase(set, Form::Reduced).jacobian().is_none());
    let run = |simulation: Simulation| {
        let start = Pose::new("phi", 0.1);
        simulation.tolerance(1e-9).start(start).unwrap().until("phi = pi/2").unwrap().run().unwrap()
    };
    let stiff = run(Simulation::new(&pair).unwrap().method(Radau));
    let usual = run(Simulation::new(&pair).unwrap());
    assert_eq!(stiff.events().len(), usual.events().len());
    for (a, b) in stiff.final_state().iter().zip(usual.final_state()) {
        assert!((a - b).abs() < 1e-7, "{a} {b}");
    }
}

#[test]
fn of_springs() {
    let pendulum = SpringPendulum { m: 2.0, k: 1e6, l: 1.0, c: 2e3, g: 9.81 };
    assert_eq!(compare(&pendulum, &[], Form::Reduced, &[0.8, 0.6001, 1.2, -1.6]), 4);
}
