//! Many periods: the energy of a pendulum and of a double pendulum does not drift.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::integrate::{Gauss, StepState, Stepper, Tolerance};

/// The largest change of `energy` over each tenth of the time, and the last state.
fn run<const N: usize>(
    f: &dyn Fn(&[f64; N]) -> [f64; N],
    energy: &dyn Fn(&[f64; N]) -> f64,
    start: [f64; N],
    (tol, end): (f64, f64),
) -> ([f64; 10], [f64; N]) {
    let tolerance = Tolerance::new(tol, [tol; N]).expect("a valid tolerance");
    let step_state = StepState::new(tolerance, 0.0, start).with_end(end);
    let mut solver = Gauss::new(f, step_state).with_pairs(N / 2);
    let mut worst = [0.0f64; 10];
    while solver.step_state().time() < end {
        solver.step().expect("a smooth motion");
        let (t, y) = (solver.step_state().time(), solver.step_state().state());
        let tenth = ((10.0 * t / end) as usize).min(9);
        worst[tenth] = worst[tenth].max((energy(y) - energy(&start)).abs());
    }
    (worst, *solver.step_state().state())
}

/// θ″ = −sin θ from 90° over a thousand periods 2π/agm(1, cos 45°).
#[test]
fn a_pendulum_keeps_its_energy() {
    let mean = (0..8).fold((1.0f64, (0.5 * FRAC_PI_2).cos()), |(a, b), _| (0.5 * (a + b), (a * b).sqrt())).0;
    let end = 1000.0 * 2.0 * PI / mean;
    let f = |y: &[f64; 2]| [y[1], -y[0].sin()];
    let energy = |y: &[f64; 2]| 0.5 * y[1] * y[1] - y[0].cos();
    let (worst, y) = run(&f, &energy, [FRAC_PI_2, 0.0], (1e-12, end));
    // The tolerance of a step, but for a factor: what one period loses it gains.
    assert!(worst.iter().all(|e| *e < 2e-11), "{worst:?}");
    assert!(worst[9] < 1.5 * worst[0], "drift: {worst:?}");
    // The phase error grows with time, 1e-12 per unit and more; a rate sin 90° = 1 at the turn.
    assert!(y[1].abs() < 1e-11 * end, "phase: {:e}", y[1]);
    let (rounding, _) = run(&f, &energy, [FRAC_PI_2, 0.0], (1e-15, 0.1 * end));
    // A random walk of roundings, ε √(steps) with some 1e4 steps.
    assert!(rounding.iter().all(|e| *e < 1e-14), "{rounding:?}");
}

/// A bar that whirls: between its ends a step is as good as at them.
#[test]
fn a_fast_turn_is_dense() {
    let f = |y: &[f64; 2]| [y[1], -15.0 * y[0].cos()];
    let energy = |y: &[f64; 2]| 0.5 * y[1] * y[1] + 15.0 * y[0].sin();
    let start = [0.1, -313.0];
    let tolerance = Tolerance::new(1e-12, [1e-12; 2]).expect("a valid tolerance");
    let mut solver = Gauss::new(&f, StepState::new(tolerance, 0.0, start).with_end(2.0)).with_pairs(1);
    while solver.step_state().time() < 2.0 {
        solver.step().expect("a smooth motion");
        let drift = |k: u32| energy(&solver.dense().interpolate(f64::from(k) / 16.0)) - energy(&start);
        // ω δω with rates known to the tolerance.
        let worst = (0..=16).map(drift).fold(0.0, |most: f64, drift| most.max(drift.abs()));
        assert!(worst < 10.0 * 1e-12 * 313.0 * 313.0, "{worst:e} at {}", solver.step_state().time());
    }
}

/// Two equal bars of mass and length 1, g = 1; the motion is chaotic or not, the energy is kept.
#[test]
fn a_double_pendulum_keeps_its_energy() {
    let f = |&[a, b, u, v]: &[f64; 4]| {
        let (sin, cos) = (a - b).sin_cos();
        let (m11, m12, m22) = (4.0 / 3.0, 0.5 * cos, 1.0 / 3.0);
        let (p, q) = (-0.5 * sin * v * v - 1.5 * a.sin(), 0.5 * sin * u * u - 0.5 * b.sin());
        let det = m11 * m22 - m12 * m12;
        [u, v, (m22 * p - m12 * q) / det, (m11 * q - m12 * p) / det]
    };
    let energy = |&[a, b, u, v]: &[f64; 4]| {
        (4.0 * u * u + v * v) / 6.0 + 0.5 * (a - b).cos() * u * v - 1.5 * a.cos() - 0.5 * b.cos()
    };
    let (worst, _) = run(&f, &energy, [0.5, 0.8, 0.0, 0.0], (1e-12, 2000.0));
    assert!(worst.iter().all(|e| *e < 2e-11), "{worst:?}");
    assert!(worst[9] < 2.0 * worst[0], "drift: {worst:?}");
}
