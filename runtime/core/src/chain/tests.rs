//! The ways to the accelerations against the dense equations; the oracle of the tests crate has no
//! part in either.

use super::Chain;
use crate::scalar::{DoubleDouble, Real, Scalar};

fn chain<S: Real>() -> Chain<S> {
    Chain::new(S::from_f64(0.7), S::from_f64(1.3), S::from_f64(0.2), [S::from_f64(9.81), S::from_f64(-1.5)])
}

fn state<S: Real, const N: usize>(spread: f64) -> ([S; N], [S; N]) {
    let value = |i: usize| spread * (((i + 1) as f64 * 0.618_034).fract() - 0.5);
    (core::array::from_fn(|i| S::from_f64(value(i))), core::array::from_fn(|i| S::from_f64(value(i + N))))
}

/// |M ω̇ − f| over Σ |M ω̇| + |f|, the largest of all rows, of both ways.
fn residual<S: Scalar, const N: usize>(spread: f64) -> f64 {
    let chain = chain::<S>();
    let (angles, rates) = state::<S, N>(spread);
    let both = [chain.accelerations(&angles, &rates), chain.articulated(&angles, &rates)];
    both.map(|found| missed(&chain, (&angles, &rates), &found)).into_iter().fold(0.0, f64::max)
}

fn missed<S: Scalar, const N: usize>(
    chain: &Chain<S>,
    (angles, rates): (&[S; N], &[S; N]),
    accelerations: &[S; N],
) -> f64 {
    let (mass, forces) = (chain.mass_matrix(angles), chain.forces(angles, rates));
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

/// The condition of the forces in the joints grows with the square of the number of bars: 64²
/// roundings.
#[test]
fn solves_the_dense_equations() {
    for spread in [6.0, 0.1] {
        assert!(residuals::<f64>(spread) < 4096.0 * f64::EPSILON, "{spread}: {:e}", residuals::<f64>(spread));
        let fine = residuals::<DoubleDouble>(spread);
        assert!(fine < 4096.0 * DoubleDouble::EPSILON.to_f64(), "{spread}: {fine:e}");
    }
}

/// Of bars whose mass is all but at their middle.
#[test]
fn small_inertia_costs_no_digits() {
    let (angles, rates) = state::<f64, 17>(6.0);
    for inertia in [1e-3, 1e-6, 1e-9] {
        let chain = Chain::new(0.7, 1.3, inertia, [9.81, -1.5]);
        let error = missed(&chain, (&angles, &rates), &chain.articulated(&angles, &rates));
        assert!(error < 4096.0 * f64::EPSILON, "{inertia}: {error:e}");
    }
}

/// States side by side take the other way, each with its own bits.
#[cfg(feature = "std")]
#[test]
fn states_side_by_side_are_as_one_alone() {
    use crate::scalar::Lanes;
    let states = |lane: usize| state::<f64, 9>(0.5 + lane as f64);
    let of =
        |part: fn(usize) -> [f64; 9]| core::array::from_fn(|k| Lanes::<2>::from_fn(|lane| part(lane)[k]));
    let [angles, rates] = [of(|lane| state(0.5 + lane as f64).0), of(|lane| state(0.5 + lane as f64).1)];
    let together = chain::<Lanes<2>>().accelerations(&angles, &rates);
    for lane in 0..Lanes::<2>::COUNT {
        let (angles, rates) = states(lane);
        let alone = chain::<f64>().articulated(&angles, &rates);
        assert_eq!(together.map(|turn| turn.lane(lane)), alone, "{lane}");
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

/// T = ½ ωᵀ M ω, and without rates f = −∂V/∂θ; central differences of V err by h²/6 of the third
/// derivative.
#[test]
fn masses_and_forces_follow_from_the_energy() {
    const H: f64 = 1e-5;
    let chain = chain::<f64>();
    let (angles, rates) = state::<f64, 7>(2.0);
    let (mass, energy) = (chain.mass_matrix(&angles), chain.energy(&angles, &rates));
    let kinetic: f64 =
        (0..7).map(|k| (0..7).map(|j| 0.5 * rates[k] * mass[k][j] * rates[j]).sum::<f64>()).sum();
    assert!((energy.kinetic - kinetic).abs() < 1e-13 * kinetic, "{} {kinetic}", energy.kinetic);
    let forces = chain.forces(&angles, &[0.0; 7]);
    for k in 0..7 {
        let potential = |by: f64| {
            let mut angles = angles;
            angles[k] += by;
            chain.energy(&angles, &[0.0; 7]).potential
        };
        let slope = (potential(H) - potential(-H)) / (2.0 * H);
        assert!((forces[k] + slope).abs() < 1e-8 * (1.0 + slope.abs()), "{k}: {} {slope}", forces[k]);
    }
}

/// Every bar's end is a length from the one before.
#[test]
fn ends_are_a_length_apart() {
    let (angles, _) = state::<f64, 5>(3.0);
    let ends = chain::<f64>().positions(&angles);
    let starts = core::iter::once([0.0, 0.0]).chain(ends);
    for ((from, to), angle) in starts.zip(ends).zip(angles) {
        let span = [to[0] - from[0] - 1.3 * angle.cos(), to[1] - from[1] - 1.3 * angle.sin()];
        assert!(span.iter().all(|part| part.abs() < 1e-14), "{span:?}");
    }
}

/// Both ends of a pair are computed as one alone is.
#[test]
fn pairs_compute_as_their_halves() {
    use super::two_ended::TwoEnded;
    let pair = |a: f64, b: f64| TwoEnded([a, b]);
    let (x, y) = (pair(0.25, 2.0), pair(3.0, -0.5));
    assert_eq!(x.sqrt().0, [0.5, 2f64.sqrt()]);
    assert_eq!(x.mul_add(y, pair(1.0, 1.0)).0, [0.25f64.mul_add(3.0, 1.0), 2f64.mul_add(-0.5, 1.0)]);
    assert_eq!(
        (<TwoEnded<f64>>::ratio(1, 3).0, <TwoEnded<f64>>::from_f64(0.1).0),
        ([1.0 / 3.0; 2], [0.1; 2])
    );
    let (sin, cos) = y.sin_cos();
    assert_eq!((sin.0, cos.0), ([3f64.sin(), (-0.5f64).sin()], [3f64.cos(), (-0.5f64).cos()]));
}
