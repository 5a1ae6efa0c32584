//! The scenes that other solvers run, written by hand as their users would: m = l = 1, g = 9.81.

use std::f64::consts::FRAC_PI_2;

/// Gravity.
pub const G: f64 = 9.81;

/// The double pendulum starts from rest at (2, 1).
pub const PENDULUM_START: [f64; 4] = [2.0, 1.0, 0.0, 0.0];
/// Its angles and rates after 10 s: a Taylor method of order 40 in 36 digits (mpmath).
pub const PENDULUM_END: [f64; 4] =
    [0.993_000_786_578_872_8, -20.132_258_527_267_324, 2.256_176_956_178_453, -5.672_984_065_020_073];
/// The falling pair starts from rest at φ = 0.1.
pub const PAIR_START: [f64; 2] = [0.1, 0.0];
/// It lifts off and ends at these times, by quadrature in 120 digits (mpmath).
pub const LIFT_OFF: f64 = 0.829_361_847_228_260_3;
/// See [`LIFT_OFF`].
pub const PAIR_END: f64 = 1.244_461_483_164_527;
/// Natural time.
pub const TIME: f64 = 0.319_275_428_407_050_5;

/// Two bars, absolute angles from the downward vertical, then their rates.
pub fn pendulum(y: &[f64], slope: &mut [f64]) {
    let (a, b, u, v) = (y[0], y[1], y[2], y[3]);
    let (sin, cos) = (a - b).sin_cos();
    let first = -0.5 * sin * v * v - 1.5 * G * a.sin();
    let second = 0.5 * sin * u * u - 0.5 * G * b.sin();
    let coupling = 0.5 * cos;
    let inverse = 1.0 / (4.0 / 9.0 - coupling * coupling);
    slope[0] = u;
    slope[1] = v;
    slope[2] = (first / 3.0 - coupling * second) * inverse;
    slope[3] = (4.0 / 3.0 * second - coupling * first) * inverse;
}

/// φ and φ̇ on the corners:
/// `(4/3 + sec⁴φ − 2 sec φ) φ̈ + sin φ sec²φ (2 sec³φ − 1) φ̇² = 2g (sec²φ − cos φ)`.
pub fn on_corners(y: &[f64], slope: &mut [f64]) {
    let (sin, cos) = y[0].sin_cos();
    let sec = 1.0 / cos;
    let sec2 = sec * sec;
    let inertia = 4.0 / 3.0 + sec2 * sec2 - 2.0 * sec;
    let velocity = sin * sec2 * (2.0 * sec2 * sec - 1.0) * y[1] * y[1];
    slope[0] = y[1];
    slope[1] = (2.0 * G * (sec2 - cos) - velocity) / inertia;
}

/// What the corners bear, up to a positive factor: g less the acceleration of the centre of mass, ½
/// (tan φ − sin φ) below the corners.
pub fn reaction(y: &[f64]) -> f64 {
    let mut slope = [0.0; 2];
    on_corners(y, &mut slope);
    let (sin, cos) = y[0].sin_cos();
    let sec2 = 1.0 / (cos * cos);
    G - 0.5 * ((sec2 - cos) * slope[1] + (2.0 * sec2 * sin / cos + sin) * y[1] * y[1])
}

/// The free pair, φ and the depth y of the hinge, then their rates, as it leaves the corners.
pub fn released(y: &[f64]) -> [f64; 4] {
    let cos = y[0].cos();
    [y[0], 0.5 * y[0].tan(), y[1], 0.5 * y[1] / (cos * cos)]
}

/// `(4/3) φ̈ − cos φ ÿ = −g cos φ` and `2 ÿ − cos φ φ̈ = 2g − sin φ φ̇²`, l = 1.
pub fn in_flight(y: &[f64], slope: &mut [f64]) {
    let (sin, cos) = y[0].sin_cos();
    let inverse = 1.0 / (4.0 / 3.0 - cos * cos);
    let (turning, falling) = (-G * cos, 2.0 * G - sin * y[2] * y[2]);
    slope[0] = y[2];
    slope[1] = y[3];
    slope[2] = (2.0 * turning + cos * falling) * inverse;
    slope[3] = (2.0 / 3.0 * falling + cos * turning) * inverse;
}

/// Zero as the bars meet.
pub fn meeting(y: &[f64]) -> f64 {
    y[0] - FRAC_PI_2
}

/// Of the pendulum's final state: largest deviation in natural units, relative to the largest
/// entry.
pub fn state_error(end: &[f64]) -> f64 {
    let units = [1.0, 1.0, 1.0 / TIME, 1.0 / TIME];
    let largest = (0..4).map(|i| (PENDULUM_END[i] / units[i]).abs()).fold(1.0, f64::max);
    let apart = (0..4).map(|i| (end[i] - PENDULUM_END[i]).abs() / units[i]);
    apart.fold(0.0, f64::max) / largest
}

/// Of the pair's times: the larger relative error.
pub fn event_error([lift_off, end]: [f64; 2]) -> f64 {
    ((lift_off - LIFT_OFF) / LIFT_OFF).abs().max(((end - PAIR_END) / PAIR_END).abs())
}
