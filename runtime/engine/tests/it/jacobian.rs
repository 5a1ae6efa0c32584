//! The Jacobian of a phase against central differences of the same phase in double-double.

use liftoff::BarSystem;
use liftoff::contact_set;
use liftoff::model::Form;
use liftoff::scalar::{DoubleDouble, Real, Scalar};
use liftoff::system::{Model, precise};
use liftoff_fixtures::Block;
use liftoff_fixtures::FallingPair;
use liftoff_fixtures::SpringPendulum;
use liftoff_fixtures::Zigzag;
use std::sync::Arc;

/// Compares the Jacobian at a full state with differences over ±1e-10, whose error is some 1e-20 by truncation and
/// 1e-32/1e-10 by rounding; how many entries the phase has.
fn compare<M: BarSystem>(model: &M, closed: &[&str], form: Form, state: &[f64]) -> usize {
    let set = contact_set(M::LAYOUT, closed).unwrap();
    let lifted = Model::of(model);
    let phase = Arc::clone(&lifted.system).phase(set, form);
    let wide = precise::<M>(&lifted.parameters).phase(set, form);
    let n = phase.info().entries;
    let (mut y, mut exact) = (vec![0.0; n], vec![0.0; n * n]);
    phase.restrict(state, &mut y);
    phase.jacobian().expect("a compiled model has one")(&y, &mut exact);
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
    let pair = FallingPair { m: 2.0, l: 0.5, g: 9.81 };
    let state = [0.6, -0.17, 1.7, -0.6];
    assert_eq!(compare(&pair, &["P", "Q"], Form::Closed, &state), 2);
    assert_eq!(compare(&pair, &["P", "Q"], Form::Projected, &state), 4);
    assert_eq!(compare(&pair, &[], Form::Projected, &state), 4);
    let block = Block { m: 2.0, b: 0.3, h: 0.5, g: 9.81 };
    assert_eq!(compare(&block, &["A"], Form::Projected, &[0.1, 0.5, 0.2, -0.3, 0.4, 1.1]), 6);
}

/// Without mass in the outer bars M is singular, and definite only on what the closed contacts leave free.
#[test]
fn of_massless_bars() {
    let zigzag = Zigzag { m1: 1.0, m2: 0.0, l: 1.0, g: 9.81 };
    let state = [0.7, 0.5, 0.1, 0.4, -0.3, 0.2];
    for labels in [&["C", "A", "E"][..], &["A", "E"]] {
        assert_eq!(compare(&zigzag, labels, Form::Projected, &state), 6);
        compare(&zigzag, labels, Form::Closed, &state);
    }
}

#[test]
fn of_springs() {
    let pendulum = SpringPendulum { m: 2.0, k: 1e6, l: 1.0, c: 2e3, g: 9.81 };
    assert_eq!(compare(&pendulum, &[], Form::Closed, &[0.8, 0.6001, 1.2, -1.6]), 4);
}
