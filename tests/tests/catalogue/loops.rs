//! Closed loops.

use super::CLOSE;
use super::common::{at, pose, prepared, run};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use core::f64::consts::FRAC_PI_2;
use liftoff::prelude::*;
use liftoff_models::*;
use liftoff_tests::catalogue::{parallelogram, slider_crank, squeezer};

#[test]
fn a_parallelogram_swings_like_a_pendulum() {
    for (m, c, amplitude) in [(1.0, 1.0, 1.0), (0.1, 3.0, 0.4), (2.0, 0.0, 1.5)] {
        let model = Parallelogram { m, l: 1.0, c, d: 2.0, g: 9.81 };
        let run = run(&model, Pose::at("phi", amplitude), &["phi = 0"]);
        let square = parallelogram::frequency_squared(m, c, 1.0, 9.81);
        assert_abs_diff_eq!(4.0 * run.end_time(), parallelogram::period(square, amplitude), epsilon = CLOSE);
        assert_abs_diff_eq!(at(&run, "tilt", run.end_time()), 0.0, epsilon = CLOSE);
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
        assert_abs_diff_eq!(at(&run, "phi", t), phi, epsilon = CLOSE);
        assert_abs_diff_eq!(at(&run, "x(B)", t), x, epsilon = CLOSE);
        assert_abs_diff_eq!(at(&run, "vx(B)", t), 4.0 * v, epsilon = CLOSE);
        assert_abs_diff_eq!(at(&run, "ax(B)", t), 16.0 * a, epsilon = CLOSE);
        assert_abs_diff_eq!(at(&run, "drive(phi)", t), linkage.torque(phi, 4.0), epsilon = CLOSE);
    }
}

/// The published angles of the model's coordinates: `phi` and `omega` are a quarter turn off.
fn published(state: &[f64]) -> Vec<f64> {
    let mut state = state.to_vec();
    state[3] += FRAC_PI_2;
    state[5] -= FRAC_PI_2;
    state
}

/// The lengths, given to four digits, close the loops at the published start to its last digits only.
#[test]
fn the_squeezer_starts_where_published() {
    let model = Squeezer { torque: 0.033, k: 4530.0 };
    let run = run(&model, Pose::at("theta", 0.0), &["t = 0.001"]);
    for (found, expected) in published(&run.state(0.0)).iter().zip(squeezer::START) {
        assert_abs_diff_eq!(*found, expected, epsilon = 1e-14);
    }
    for (output, expected) in ["beta''", "theta''"].iter().zip(squeezer::START_ACCELERATIONS) {
        assert_relative_eq!(at(&run, output, 0.0), expected, max_relative = 1e-11);
    }
}

/// The crank makes two and a half turns; the reference is good to some 11 digits.
#[test]
fn the_squeezer_ends_where_published() {
    let model = Squeezer { torque: 0.033, k: 4530.0 };
    let run = prepared(&model, Pose::at("theta", 0.0), &["t = 0.03"]).tolerance(1e-14).run().unwrap();
    let found = published(&run.final_state());
    for (found, expected) in found.iter().zip(squeezer::END) {
        println!("{found:.16e} {expected:.16e} {:.1e}", (found - expected).abs() / expected.abs());
    }
    for (found, expected) in found.iter().zip(squeezer::END) {
        assert_relative_eq!(*found, expected, max_relative = CLOSE);
    }
}

/// One pass through the level position, where every loop is singular, at the rate that energy leaves.
#[test]
fn a_row_of_loops_falls_to_the_level() {
    let model = NFourBar { m: 1.0, l: 1.0, g: 9.81 };
    let run = run(&model, pose(&[("phi", 0.0), ("phi'", 1.0)]), &["phi = 1.5"]);
    let square = parallelogram::row_rate_squared(2.0, 1.0, 9.81, 1.0, 1.5);
    assert_relative_eq!(at(&run, "phi'", run.end_time()), square.sqrt(), max_relative = CLOSE);
    assert_abs_diff_eq!(at(&run, "psi_d", run.end_time()), 0.0, epsilon = CLOSE);
    let _ = pose;
}
