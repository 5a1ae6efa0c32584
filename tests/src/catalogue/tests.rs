//! Numbers computed in 25 digits, printed with 17, from these functions; 1e-14 relative is their
//! rounding.

use std::f64::consts::FRAC_PI_2;

use super::*;
use crate::numerics::{root, runge_kutta};

fn close(computed: f64, printed: f64, tolerance: f64) {
    let error = (computed - printed).abs() / printed.abs();
    assert!(error <= tolerance, "{computed:.17} for {printed:.17}, {error:.1e}");
}

#[test]
fn ladder_from_75_degrees() {
    let start = 75f64.to_radians();
    let leaving = ladder::leaving_angle(start);
    close(ladder::time(start, leaving), 1.5475985700798873, 1e-14);
    close(leaving, 0.699_650_781_421_522_1, 1e-14);
    close(ladder::rate_squared(start, leaving).sqrt(), 0.982_815_255_421_418_6, 1e-14);
    close(ladder::free_time(start, 0.0), 0.545_141_940_093_053_3, 1e-14);
    close(ladder::free_rate_squared(start, 0.0).sqrt(), 1.611_635_956_783_063, 1e-14);
}

#[test]
fn ladder_phases_meet_where_the_wall_is_left() {
    let start = 1.1;
    let leaving = ladder::leaving_angle(start);
    assert!(ladder::wall_reaction(start, leaving).abs() < 1e-15);
    close(ladder::floor_reaction(start, leaving), 0.25, 1e-14);
    close(ladder::free_floor_reaction(start, leaving), 0.25, 1e-14);
    let rate = ladder::rate_squared(start, leaving).sqrt();
    close(ladder::free_rate_squared(start, leaving).sqrt(), rate, 1e-14);
    close(ladder::drift(start), 0.5 * leaving.sin() * rate, 1e-14);
}

#[test]
fn rod_on_floor() {
    close(rod_on_floor::rate_squared(0.01, FRAC_PI_2).sqrt(), 1.7320075061182604, 1e-14);
    close(rod_on_floor::time(0.01, FRAC_PI_2), 2.7676462129636743, 1e-14);
    let slope =
        |theta: f64| rod_on_floor::reaction(0.0, theta + 1e-4) - rod_on_floor::reaction(0.0, theta - 1e-4);
    let least = root(slope, 0.3, 1.2).expect("a minimum between");
    // the located minimum is off by 1e-8 (difference quotient), its value by the square of that
    close(rod_on_floor::reaction(0.0, least), 0.16542921931776471, 1e-13);
}

#[test]
fn pendulum_of_90_degrees() {
    close(hinged_bar::period(FRAC_PI_2), 6.055_382_539_204_989, 1e-15);
}

#[test]
fn a_frame_from_80_degrees() {
    let start = 80f64.to_radians();
    close(a_frame::time(start, 0.0), 2.405_378_338_205_828, 1e-14);
    close(a_frame::landing_speed(start), 1.7188435818993607, 1e-15);
    let lowest = (start.sin() / 3.0).asin();
    close(a_frame::reaction(start, lowest), a_frame::least_reaction(start), 1e-13);
}

#[test]
fn double_pendulum_table() {
    let field = |y: &[f64; 4]| {
        let [a, b] = double_pendulum::accelerations(0.5, 1.0, [y[0], y[1]], [y[2], y[3]]);
        [y[2], y[3], a, b]
    };
    let mut state = [0.0, std::f64::consts::PI - 0.1, 0.0, 0.0];
    for (_, printed) in double_pendulum::TABLE {
        for _ in 0..10_000 {
            state = runge_kutta(field, &state, 5e-4);
        }
        for (computed, printed) in state.iter().zip(printed) {
            // 8 digits are printed; Runge–Kutta at this step is off by less (halving it moves
            // 1e-10)
            assert!((computed - printed).abs() < 7e-9, "{computed} for {printed}");
        }
    }
}

#[test]
fn small_modes_of_the_double_pendulum() {
    for square in double_pendulum::modes(1.0, 1.0) {
        // M = [[4/3, 1/2], [1/2, 1/3]], K = diag(3/2, 1/2)
        let determinant = (1.5 - 4.0 / 3.0 * square) * (0.5 - square / 3.0) - 0.25 * square * square;
        assert!(determinant.abs() < 1e-14);
    }
}

#[test]
fn slip_angles_of_the_toppling_rod() {
    let slip = |mu| toppling_rod::slip_angle(mu).expect("a slip").to_degrees();
    close(slip(0.2), 15.519_254_335_380_932, 1e-13);
    close(slip(0.5), 51.977_855_451_506_29, 1e-13);
}

#[test]
fn bouncing_ball_of_four_fifths() {
    close(bouncing_ball::rest(0.8, 1.0, 1.0), 12.727_922_061_357_855, 1e-15);
}

/// The limit is printed with eight digits.
#[test]
fn folded_chain() {
    close(folded_chain::fall_time(), 0.847_213_08, 6e-9);
}

/// The tangential forces of a chimney are the derivative of its moment.
#[test]
fn moments_of_the_chimney_are_consistent() {
    let (theta, h) = (0.7, 1e-5);
    for part in [0.1, 1.0 / 3.0, 0.8] {
        let slope = chimney::moment(theta, part + h) - chimney::moment(theta, part - h);
        assert!((slope / (2.0 * h) - chimney::shear(theta, part)).abs() < 1e-10);
    }
}

/// Over a turn the steady crank takes no work on balance.
#[test]
fn torque_of_the_slider_crank_does_no_work() {
    let linkage = slider_crank::SliderCrank { masses: [1.0, 0.5, 2.0], crank: 0.1, rod: 0.3 };
    let torque = |phi| linkage.torque(phi, 3.0);
    let turn = std::f64::consts::TAU;
    assert!(crate::numerics::integral(torque, 0.0, turn).abs() < 1e-15);
    let (phi, h) = (0.9, 1e-5);
    let slope = (linkage.piston(phi + h)[0] - linkage.piston(phi - h)[0]) / (2.0 * h);
    assert!((slope - linkage.piston(phi)[1]).abs() < 1e-10);
}

#[test]
fn squeezer_as_published() {
    let [beta, theta, rest @ ..] = squeezer::accelerations(&squeezer::START);
    close(beta, squeezer::START_ACCELERATIONS[0], 1e-13);
    close(theta, squeezer::START_ACCELERATIONS[1], 1e-13);
    assert!(rest.iter().all(|a| a.abs() < 1e-9), "{rest:?}");
    let (coarse, fine) = (squeezer::state(0.03, 600), squeezer::state(0.03, 900));
    for (coarse, fine) in coarse.iter().zip(fine) {
        assert!((coarse - fine).abs() < 1e-9 * fine.abs());
    }
}
