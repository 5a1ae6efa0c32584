//! What grows from below the tolerance.

use nalgebra::SMatrix;

use crate::integrate::dop853::DormandPrince;
use crate::integrate::explicit::Pair;
use crate::integrate::growth::compute_growth;
use crate::integrate::tsit5::Tsitouras;
use crate::integrate::{Dop853, Radau, StepState, Stepper, Tolerance, Tsit5};

/// The largest real part of the eigenvalues by nalgebra, or zero.
fn find_by_nalgebra<const N: usize>(a: &[[f64; N]; N]) -> f64 {
    let matrix = nalgebra::DMatrix::from_fn(N, N, |i, j| a[i][j]);
    matrix.complex_eigenvalues().iter().fold(0.0, |most, value| most.max(value.re))
}

fn check_random<const N: usize>(seed: &mut u64) {
    let mut draw = || {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let a: [[f64; N]; N] = core::array::from_fn(|_| core::array::from_fn(|_| draw()));
    // Those of random matrices are well conditioned.
    let (found, expected) = (compute_growth(&a, &[1.0; N]), find_by_nalgebra(&a));
    assert!((found - expected).abs() < 1e-11, "{a:?}: {found}, not {expected}");
}

#[test]
fn growth_is_the_largest_real_part() {
    let mut seed = 7;
    for _ in 0..200 {
        check_random::<1>(&mut seed);
        check_random::<2>(&mut seed);
        check_random::<3>(&mut seed);
        check_random::<6>(&mut seed);
        check_random::<16>(&mut seed);
    }
    check_random::<64>(&mut seed);
}

/// A rotation of axes, whose eigenvalues all have one modulus, needs an unusual shift.
#[test]
fn growth_of_a_cycle() {
    let cycle: [[f64; 6]; 6] =
        core::array::from_fn(|i| core::array::from_fn(|j| f64::from(u8::from((i + 1) % 6 == j))));
    assert!((compute_growth(&cycle, &[1.0; 6]) - 1.0).abs() < 1e-12);
}

/// Of coordinates and their rates, M q″ = K q: growth and vibrations of very different rates, with
/// zeros on the diagonal and roundings elsewhere.
#[test]
fn growth_among_vibrations() {
    fn check<const N: usize>(seed: &mut u64) {
        let mut draw = || {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let n = N / 2;
        let stiffness: [f64; N] =
            core::array::from_fn(|i| if i == 0 { 1.0 } else { -10f64.powf(9.0 * draw()) });
        let unit: [f64; N] = core::array::from_fn(|_| 10f64.powf(6.0 * draw()));
        let mut a = [[0.0; N]; N];
        for i in 0..n {
            a[i][n + i] = 1.0;
            a[n + i][i] = stiffness[i] * (1.0 + 1e-8 * draw());
        }
        let found = compute_growth(&a, &unit);
        assert!((found - 1.0).abs() < 1e-6, "{a:?}, {unit:?}: {found}");
    }
    let mut seed = 3;
    for _ in 0..2000 {
        check::<4>(&mut seed);
        check::<6>(&mut seed);
        check::<10>(&mut seed);
    }
}

/// In other units, with entries that only fill up.
#[test]
fn growth_is_the_same_in_other_units() {
    let a = SMatrix::<f64, 4, 4>::from_row_slice(&[
        0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 4.0, 0.5, 0.0, 0.0, 0.25, -1e4, 0.0, -3.0,
    ]);
    let unit = [1e-3, 1e-3, 1e6, 1e6];
    let mut wide = [[0.0; 6]; 6];
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        wide[i][j] = a[(i, j)] * unit[i] / unit[j];
    }
    let [x, v] = [1e-3, 1e6];
    let found = compute_growth(&wide, &[x, x, v, v, f64::INFINITY, f64::INFINITY]);
    let rows: [[f64; 4]; 4] = core::array::from_fn(|i| core::array::from_fn(|j| a[(i, j)]));
    assert!((found - find_by_nalgebra(&rows)).abs() < 1e-9, "{found}");
}

/// y″ = y from 1e-15 at rest, with a tolerance far above, beside what moves at the rate `speed` or
/// swings 100 times as slowly: cosh t to the tolerance in each step.
#[test]
fn growth_from_below_the_tolerance_is_followed() {
    const DELTA: f64 = 1e-15;
    for (relative, speed) in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12].into_iter().flat_map(|r| [(r, 0.0), (r, 1.0)]) {
        let tolerance = Tolerance::new(relative, [1e-4 * relative; 4]).expect("a valid tolerance");
        let stiffness = if speed == 0.0 { 1e-4 } else { 0.0 };
        let f = |&[y, z, v, w]: &[f64; 4]| [v, w, y, -stiffness * z];
        let mut jacobian = [[0.0; 4]; 4];
        (jacobian[0][2], jacobian[1][3], jacobian[2][0], jacobian[3][1]) = (1.0, 1.0, 1.0, -stiffness);
        let step_state = StepState::new(tolerance, 0.0, [DELTA, 1.0, 0.0, speed]).with_end(30.0);
        let check = |name: &str, solver: &mut dyn Stepper<f64, 4>| {
            while solver.step_state().time() < 30.0 {
                solver.step().expect("a smooth motion");
            }
            let error = solver.step_state().state()[0] / (DELTA * 30f64.cosh()) - 1.0;
            let bound = 1.5 * relative.max(4e-8) * solver.step_state().counts().accepted as f64;
            assert!(error.abs() < bound + 1e-10, "{name} at {relative:e}, {speed}: {error:e}");
        };
        check("radau", &mut Radau::new(f, |_: &[f64; 4]| jacobian, step_state.clone()));
        check("tsit5", &mut Tsit5::new(f, step_state.clone()));
        check("dop853", &mut Dop853::new(f, step_state));
    }
}

/// R(z) of a step of y′ = y.
#[test]
fn error_constants_are_those_of_the_tableaux() {
    fn compute_ratio<P: Pair<L>, const L: usize>() -> f64 {
        let trial = P::trial(&|y: &[f64; 1]| *y, &[1.0], [1.0], 1.0);
        (1f64.exp() - trial.y1[0]).abs() / P::ERROR_CONSTANT
    }
    // Three digits of a constant.
    let ratios = [compute_ratio::<Tsitouras, 7>(), compute_ratio::<DormandPrince, 13>()];
    assert!(ratios.iter().all(|ratio| (ratio - 1.0).abs() < 1e-2), "{ratios:?}");
}

/// y″ = y/s from s = 1e-12 on, s′ = 1: a step that the last Jacobian keeps short is not kept short
/// by it for good.
#[test]
fn growth_that_is_gone_keeps_no_step_short() {
    let tolerance = Tolerance::new(1e-5, [1e-9; 3]).expect("a valid tolerance");
    let f = |&[y, v, s]: &[f64; 3]| [v, y / s, 1.0];
    let jacobian = |&[y, _, s]: &[f64; 3]| [[0.0, 1.0, 0.0], [1.0 / s, 0.0, -y / (s * s)], [0.0, 0.0, 0.0]];
    let step_state = StepState::new(tolerance, 0.0, [0.0, 0.0, 1e-12]).with_end(1.0);
    let mut solver = Radau::new(f, jacobian, step_state);
    while solver.step_state().time() < 1.0 {
        solver.step().expect("a smooth motion");
        assert!(solver.step_state().counts().accepted < 100);
    }
}
