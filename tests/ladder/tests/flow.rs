//! Motion without events, also where there is no standard library
//! (`--no-default-features --features libm`), against closed forms; the tolerance of ten steps.

use liftoff::flow;
use liftoff_ladder::{FreeBar, GRAVITY, bare};

const TOLERANCE: f64 = 1e-12;

#[test]
fn a_thrown_bar() {
    let end = bare::fall(&[0.0, 0.0, 0.0, 3.0, 1.0, 2.0], 0.5, TOLERANCE).unwrap();
    let expected = [1.5, 0.5, 1.0 - GRAVITY / 8.0, 3.0, 1.0, 2.0 - GRAVITY / 2.0];
    for (a, b) in end.into_iter().zip(expected) {
        assert!((a - b).abs() < 10.0 * TOLERANCE, "{a} {b}");
    }
    let [_, x, ..] = flow(&FreeBar::SCENE, &[0.0, 0.0, 0.0, 3.0, 1.0, 2.0], 0.5, TOLERANCE).unwrap();
    assert!((x - 0.5).abs() < 10.0 * TOLERANCE);
}

/// ⅙ φ̇² = ½ g (cos φ − cos φ₀), m = l = 1.
#[test]
fn a_pendulum_keeps_its_energy() {
    let [phi, w] = bare::swing(&[1.0, 0.0], 2.0, TOLERANCE).unwrap();
    let change = w * w / 6.0 - 0.5 * GRAVITY * (phi.cos() - 1.0_f64.cos());
    assert!(change.abs() < 100.0 * TOLERANCE, "{change:e}");
}

/// The same with ½ k (r − s)², r² = 2 − 2 sin φ.
#[test]
fn flow_with_a_spring_agrees() {
    let energy = |[phi, w]: [f64; 2]| {
        let stretch = (2.0 - 2.0 * phi.sin()).sqrt() - 0.5;
        w * w / 6.0 - 0.5 * GRAVITY * phi.cos() + 10.0 * stretch * stretch
    };
    let end = bare::bounce(&[0.3, 0.0], 2.0, TOLERANCE).unwrap();
    let change = energy(end) - energy([0.3, 0.0]);
    assert!(change.abs() < 1000.0 * TOLERANCE, "{change:e} after {end:?}");
}
