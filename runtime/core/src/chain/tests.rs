//! The two ways to the accelerations against each other; the oracle of the tests crate has no part in either.

use super::Chain;
use crate::scalar::{DoubleDouble, Real, Scalar};

fn chain<S: Real>() -> Chain<S> {
    Chain::new(S::from_f64(0.7), S::from_f64(1.3), S::from_f64(0.2), [S::from_f64(9.81), S::from_f64(-1.5)])
}

fn state<S: Real, const N: usize>(spread: f64) -> ([S; N], [S; N]) {
    let value = |i: usize| spread * (((i + 1) as f64 * 0.618_034).fract() - 0.5);
    (core::array::from_fn(|i| S::from_f64(value(i))), core::array::from_fn(|i| S::from_f64(value(i + N))))
}

/// |M ω̇ − f| over Σ |M ω̇| + |f|, the largest of all rows.
fn residual<S: Scalar, const N: usize>(spread: f64) -> f64 {
    let chain = chain::<S>();
    let (angles, rates) = state::<S, N>(spread);
    let accelerations = chain.accelerations(&angles, &rates);
    let (mass, forces) = (chain.mass_matrix(&angles), chain.forces(&angles, &rates));
    let row = |k: usize| {
        let (mut sum, mut size) = (-forces[k], forces[k].abs());
        for j in 0..N {
            let term = mass[k][j] * accelerations[j];
            (sum, size) = (sum + term, size + term.abs());
        }
        (sum.abs() / size).to_f64()
    };
    (0..N).map(row).fold(0.0, f64::max)
}

fn residuals<S: Scalar>(spread: f64) -> f64 {
    let few = residual::<S, 1>(spread).max(residual::<S, 2>(spread)).max(residual::<S, 3>(spread));
    few.max(residual::<S, 4>(spread)).max(residual::<S, 17>(spread)).max(residual::<S, 64>(spread))
}

/// The condition of the forces in the joints grows with the square of the number of bars: 64² roundings.
#[test]
fn solves_the_dense_equations() {
    for spread in [6.0, 0.1] {
        assert!(residuals::<f64>(spread) < 4096.0 * f64::EPSILON, "{spread}: {:e}", residuals::<f64>(spread));
        let fine = residuals::<DoubleDouble>(spread);
        assert!(fine < 4096.0 * DoubleDouble::EPSILON.to_f64(), "{spread}: {fine:e}");
    }
}

/// Hanging at rest, every joint bears what hangs from it.
#[test]
fn rest_bears_the_weight() {
    let chain = Chain::new(0.7, 1.3, 0.2, [9.81, 0.0]);
    let forces = chain.joint_forces(&[0.0; 9], &[0.0; 9]);
    for (k, force) in forces.iter().enumerate() {
        let weight = 0.7 * 9.81 * (9 - k) as f64;
        // Nine bars: 9² roundings.
        assert!(
            (force[0] + weight).abs() < 81.0 * f64::EPSILON * weight && force[1] == 0.0,
            "{k}: {force:?}"
        );
    }
}
