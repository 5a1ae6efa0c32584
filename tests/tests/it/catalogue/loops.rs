//! Closed loops.

use super::{CLOSE, evaluate_output, pose};
use crate::common::run;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use core::f64::consts::{FRAC_PI_2, PI};
use liftoff::method::Dop853;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{car_axis, parallelogram, slider_crank, squeezer};
use liftoff_tests::numerics::integral;

#[test]
fn a_parallelogram_swings_like_a_pendulum() {
    for (m, c, amplitude) in [(1.0, 1.0, 1.0), (0.1, 3.0, 0.4), (2.0, 0.0, 1.5)] {
        let model = Parallelogram { m, l: 1.0, c, d: 2.0, g: 9.81 };
        let run = run(&model, Pose::new("phi", amplitude), &["phi = 0"]);
        let square = parallelogram::frequency_squared(m, c, 1.0, 9.81);
        assert_abs_diff_eq!(4.0 * run.end_time(), parallelogram::period(square, amplitude), epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "tilt", run.end_time()), 0.0, epsilon = CLOSE);
    }
}

/// The steady crank: the piston, and the torque that the drive gives.
#[test]
fn a_slider_crank_follows_its_drive() {
    let model = SliderCrank { a: 1.0, b: 0.5, c: 2.0, r: 0.1, l: 0.3, omega: 4.0 };
    let linkage = slider_crank::SliderCrank { masses: [1.0, 0.5, 2.0], crank: 0.1, rod: 0.3 };
    let run = run(&model, Pose::nominal(), &["t = 2"]);
    for t in [0.0, 0.3, 0.9, 1.6, 2.0] {
        let phi = 4.0 * t;
        let [x, v, a] = linkage.piston(phi);
        assert_abs_diff_eq!(evaluate_output(&run, "phi", t), phi, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "x(B)", t), x, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "vx(B)", t), 4.0 * v, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "ax(B)", t), 16.0 * a, epsilon = CLOSE);
        assert_abs_diff_eq!(
            evaluate_output(&run, "drive(phi)", t),
            linkage.torque(phi, 4.0),
            epsilon = CLOSE
        );
    }
}

/// The lever points at the crank's pin; the drive gives what the lever gains, T = ½ (b l²/3) ψ̇².
#[test]
fn a_quick_return_follows_its_drive() {
    let (b, r, l, h, omega) = (2.0, 0.2, 1.0, 0.5, 3.0);
    let run = run(&QuickReturn { a: 1.0, b, r, l, h, omega }, Pose::nominal(), &["t = 3"]);
    for t in [0.0, 0.4, 1.1, 2.3, 3.0] {
        let (sin, cos) = (omega * t).sin_cos();
        let (x, y) = (r * cos, h + r * sin);
        let square = x * x + y * y;
        // ψ′ = (x y′ − y x′)/ρ², x y′ − y x′ = r² + h r sin φ
        let turn = (r * r + h * r * sin) / square;
        let bend = (h * r * cos - turn * 2.0 * h * r * cos) / square;
        assert_abs_diff_eq!(evaluate_output(&run, "psi", t), y.atan2(x), epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "psi'", t), omega * turn, epsilon = CLOSE);
        let torque = b * l * l / 3.0 * omega * omega * turn * bend;
        assert_abs_diff_eq!(evaluate_output(&run, "drive(phi)", t), torque, epsilon = CLOSE);
    }
}

/// The published angles of the model's coordinates: `phi` and `omega` are a quarter turn off.
fn published(state: &[f64]) -> Vec<f64> {
    let mut state = state.to_vec();
    state[3] += FRAC_PI_2;
    state[5] -= FRAC_PI_2;
    state
}

#[test]
fn the_squeezer_starts_where_published() {
    let model = Squeezer { torque: 0.033, k: 4530.0 };
    let run = run(&model, Pose::new("theta", 0.0), &["t = 0.001"]);
    for (found, expected) in published(&run.state(0.0)).iter().zip(squeezer::START) {
        assert_abs_diff_eq!(*found, expected, epsilon = 1e-14);
    }
    for (output, expected) in ["beta''", "theta''"].iter().zip(squeezer::START_ACCELERATIONS) {
        assert_relative_eq!(evaluate_output(&run, output, 0.0), expected, max_relative = 1e-11);
    }
}

/// Two and a half turns of the crank, against the published equations and against the published
/// numbers. Those are late by 1e-12 s, as two other integrations of the published equations have it
/// too; at rates of 1e3 and accelerations of 6e5 that is seen.
#[test]
fn the_squeezer_ends_where_published() {
    let model = Squeezer { torque: 0.033, k: 4530.0 };
    let run = run(&model, Pose::new("theta", 0.0), &["t = 0.03"]);
    let found = published(&run.final_state());
    for (found, expected) in found.iter().zip(squeezer::state(0.03, 900)) {
        assert_relative_eq!(*found, expected, max_relative = CLOSE);
    }
    for (found, expected) in found.iter().zip(squeezer::PUBLISHED) {
        assert_relative_eq!(*found, expected, max_relative = 1e-7);
    }
    for (found, expected) in found[..7].iter().zip(squeezer::PUBLISHED) {
        assert_relative_eq!(*found, expected, max_relative = 5.0 * CLOSE);
    }
}

/// Loops whose positions stay regular are integrated as exactly as was asked, not more.
#[test]
fn loops_take_the_tolerance_that_is_asked_for() {
    let model = Squeezer { torque: 0.033, k: 4530.0 };
    let simulation = Simulation::new(&model).unwrap().start(Pose::new("theta", 0.0)).unwrap().limit(0.03);
    let expected = squeezer::state(0.03, 900);
    let mut steps = Vec::new();
    for tolerance in [1e-5, 1e-10] {
        let run = simulation.clone().tolerance(tolerance).method(Dop853).run().unwrap();
        for (found, expected) in published(&run.final_state())[..7].iter().zip(expected) {
            // γ, the least of them, turns at 11 rad/s while β does at 1100.
            assert_relative_eq!(*found, expected, max_relative = 100.0 * tolerance);
        }
        steps.push(run.statistics().steps);
    }
    assert!(2 * steps[0] < steps[1], "{steps:?}");
}

/// Three seconds over bumps. The published forces are divided by the stiffness; the guide's is
/// positive to its left, against the axis.
#[test]
fn the_car_axis_ends_where_published() {
    let model = CarAxis { m: 10.0, l: 1.0, h: 0.5, k: 1e4, r: 0.1, omega: 10.0, g: 1.0 };
    let run = run(&model, Pose::nominal(), &["t = 3"]);
    let outputs = ["x(L)", "y(L)", "x(R)", "y(R)", "vx(L)", "vy(L)", "vx(R)", "vy(R)"];
    for (output, expected) in outputs.iter().zip(car_axis::PUBLISHED) {
        assert_abs_diff_eq!(evaluate_output(&run, output, 3.0), expected, epsilon = CLOSE);
    }
    let force = -car_axis::MULTIPLIER * model.k * model.l;
    assert_relative_eq!(evaluate_output(&run, "slider(L)", 3.0), force, max_relative = 1e-9);
}

/// Ten seconds, ten passes through the level position, where every loop is singular: angle and rate
/// are those of the one pendulum that the row of parallelograms is.
#[test]
fn a_row_of_loops_passes_its_singular_positions() {
    let model = NFourBar { m: 1.0, l: 1.0, g: 9.81 };
    let run = run(&model, pose(&[("phi", 0.0), ("phi'", 1.0)]), &["t = 10"]);
    let rate = |phi| parallelogram::row_rate_squared(2.0, 1.0, 9.81, 1.0, phi).sqrt();
    let turn = 2.0 * integral(|phi| 1.0 / rate(phi), 0.0, PI);
    for half in 1..=9 {
        let t = 0.5 * f64::from(half) * turn;
        if t < 10.0 {
            assert_abs_diff_eq!(evaluate_output(&run, "phi", t), PI * f64::from(half), epsilon = CLOSE);
        }
    }
    for t in [2.5, 5.0, 7.5, 10.0] {
        let phi = evaluate_output(&run, "phi", t);
        assert_relative_eq!(evaluate_output(&run, "phi'", t), rate(phi), max_relative = CLOSE);
        for output in ["psi_b", "psi_d", "phi_c - phi", "phi_e - phi"] {
            assert_abs_diff_eq!(evaluate_output(&run, output, t), 0.0, epsilon = CLOSE);
        }
    }
}
