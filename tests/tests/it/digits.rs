//! Fig. 1a at small angles: force and energy keep their digits where the plain formulas lose all of
//! them.
//!
//! The reference is the closed form in double-double arithmetic (31 digits), written by hand; 1e-13
//! is the promise, some 450 roundings.

use approx::assert_relative_eq;
use liftoff::prelude::*;
use liftoff_compiled::FallingPair;
use liftoff_core::scalar::{DoubleDouble, Real, Scalar};

const PROMISE: f64 = 1e-13;

/// `sec²φ − cos φ` and `tan φ − sin φ`, with `1 − cos φ = 2 sin² ½φ`.
fn reference(phi: f64) -> [f64; 2] {
    let exact = DoubleDouble::from_f64;
    let (sin, cos) = exact(phi).sin_cos();
    let (half, _) = (exact(phi) * DoubleDouble::ratio(1, 2)).sin_cos();
    let vers = exact(2.0) * half * half;
    let force = vers * (exact(1.0) + cos + cos * cos) / (cos * cos);
    [force.to_f64(), (sin * vers / cos).to_f64()]
}

#[test]
fn force_and_energy_from_a_tenth_to_a_trillionth() {
    let (m, l, g) = (1.3, 0.7, 9.81);
    let model = FallingPair { m, l, g };
    let phase = model.phase(&["P", "Q"]).unwrap();
    for exponent in 1..=12 {
        let phi = 10.0_f64.powi(-exponent);
        let state = [phi, 0.5 * l * phi.tan(), 0.0, 0.0];
        let [force, fall] = reference(phi);
        let derived = phase.reduced_accelerations(&state)[0] * phase.mass_matrix(&state)[0][0];
        assert_relative_eq!(derived, m * g * l * force, max_relative = PROMISE);
        assert_relative_eq!(phase.energy(&state).potential, -m * g * l * fall, max_relative = PROMISE);
    }
}
