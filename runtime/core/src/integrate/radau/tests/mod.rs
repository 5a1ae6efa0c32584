//! Coefficients, orders, and the linear algebra; [`stiff`] springs.

mod stiff;

use nalgebra::{Complex, SMatrix};

use super::coefficients::{BACK, DEFECT, FORWARD, GAMMA, NODES, transform};
use super::full::Full;
use super::lu::Lu;
use super::system::{NewtonSystem, Solved};
use super::{dense, factors::NewtonFactors};
use crate::integrate::tests::fields::{Field, Kepler, distance, kepler, orbit};
use crate::integrate::tests::from;
use crate::integrate::tests::orders::step_orders;
use crate::integrate::{Dense, Tolerance};

/// Collocation: Σ (A⁻¹)ᵢⱼ cⱼᵏ = k cᵢᵏ⁻¹, with A⁻¹ as T and its blocks make it. Rounding of entries
/// up to 10 times 15.
#[test]
fn the_transformation_is_that_of_collocation() {
    let identity = transform(&FORWARD, &BACK);
    for i in 0..3 {
        for j in 0..3 {
            assert!((identity[i][j] - f64::from(u8::from(i == j))).abs() < 1e-14);
        }
    }
    let inverse = Full::<1>::new().inverse;
    for (k, order) in [(1, 1.0), (2, 2.0), (3, 3.0)] {
        let sums = inverse.map(|row| (0..3).map(|j| row[j] * NODES[j].powi(k)).sum::<f64>());
        for (sum, c) in sums.iter().zip(NODES) {
            assert!((sum - order * c.powi(k - 1)).abs() < 1e-13, "k = {k}: {sum}");
        }
        let slope = -DEFECT.iter().zip(NODES).map(|(e, c)| e * c.powi(k)).sum::<f64>();
        assert!((slope - f64::from(u8::from(k == 1))).abs() < 1e-13, "p′(0), k = {k}: {slope}");
    }
    // γ³ − 9 γ² + 36 γ − 60 = 0 (Hairer & Wanner II, IV.5, the denominator of the (2,3)-Padé
    // approximation).
    assert!((((GAMMA - 9.0) * GAMMA + 36.0) * GAMMA - 60.0).abs() < 1e-13);
}

/// Against nalgebra, with a zero where the first pivot would be.
#[test]
fn elimination_pivots() {
    let entry = |i: usize, j: usize| {
        if i + j == 0 { 0.0 } else { ((1 + 2 * i + 3 * i * j + 7 * j * j) as f64).sin() }
    };
    let a: [[f64; 5]; 5] = core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)));
    let right = [1.0, -2.0, 0.5, 3.0, -0.25];
    let matrix = SMatrix::<f64, 5, 5>::from_fn(|i, j| a[i][j]);
    let expected = matrix.lu().solve(&SMatrix::<f64, 5, 1>::from(right)).expect("a regular matrix");
    let x = Lu::new(a, &[1.0; 5]).expect("a regular matrix").solve(&right);
    // Rounding times a condition of some hundred.
    assert!(distance(x, <[f64; 5]>::from(expected)) < 1e-12 * expected.amax());
    let turned = a.map(|row| row.map(|x| Complex::new(x, x * x)));
    let x = Lu::new(turned, &[1.0; 5]).expect("a regular matrix").solve(&right.map(Complex::from));
    let back = SMatrix::<Complex<f64>, 5, 5>::from_fn(|i, j| turned[i][j]) * SMatrix::<_, 5, 1>::from(x);
    assert!(back.iter().zip(right).all(|(a, b)| (a - b).norm() < 1e-12));
    assert!(
        Lu::new([[1.0, 2.0], [2.0, 4.0]], &[1.0; 2]).is_none() && Lu::new([[f64::NAN]], &[1.0]).is_none()
    );
}

/// y in other units, powers of two apart: A becomes D A D⁻¹, its solution D x, digit by digit.
#[test]
fn elimination_is_the_same_in_other_units() {
    let a: [[f64; 4]; 4] =
        core::array::from_fn(|i| core::array::from_fn(|j| ((1 + 5 * i + 3 * j * j) as f64).sin()));
    let (right, unit) = ([1.0, -2.0, 0.5, 3.0], [1.0, 1024.0, 2f64.powi(-20), 2f64.powi(30)]);
    let turned = core::array::from_fn(|i| core::array::from_fn(|j| a[i][j] * unit[i] / unit[j]));
    let loads = core::array::from_fn(|i| right[i] * unit[i]);
    let x = Lu::new(a, &[1.0; 4]).expect("a regular matrix").solve(&right);
    let scaled = Lu::new(turned, &unit).expect("a regular matrix").solve(&loads);
    assert_eq!(scaled, core::array::from_fn(|i| x[i] * unit[i]));
    let full = |unit: [f64; 4], jacobian: [[f64; 4]; 4]| {
        let (y, z) = (unit, [unit; 3]);
        Full::new().change(&|_| jacobian, (&y, 0.5, &unit), &[unit; 3], &z).expect("regular")
    };
    let (one, other) = (full([1.0; 4], a), full(unit, turned));
    assert_eq!(other, one.map(|stage| core::array::from_fn(|i| stage[i] * unit[i])));
}

/// With one Jacobian for all stages, Newton's own step is the simplified one.
#[test]
fn both_iterations_are_one_for_a_linear_system() {
    let j = [[0.0, 1.0], [-1e4, -20.0]];
    let f = |y: &[f64; 2]| [y[1], -1e4 * y[0] - 20.0 * y[1]];
    let (y, h) = ([1.0, -3.0], 0.07);
    let z = [[0.1, 0.2], [0.3, -0.4], [-0.5, 0.6]];
    let slopes = z.map(|z| f(&[y[0] + z[0], y[1] + z[1]]));
    let simplified = NewtonFactors::new(h, &j, &[1.0; 2]).expect("regular").change(h, &slopes, &z);
    let full = Full::new().change(&|_| j, (&y, h, &[1.0; 2]), &slopes, &z).expect("regular");
    for (a, b) in simplified.iter().zip(full) {
        // Rounding times ‖J‖ h.
        assert!(distance(*a, b) < 1e-12 * 700.0);
    }
}

/// One step of length `h` from the orbit at time 3.
fn single(h: f64) -> Dense<f64, 4> {
    let mut step_state = from(1e-12, orbit(3.0));
    let mut system = NewtonSystem::new(|y: &[f64; 4]| Kepler.jacobian(y));
    let tolerance = Tolerance::new(1e-12, [1e-12; 4]).expect("a valid tolerance");
    let y0 = *step_state.state();
    system.update_jacobian(&mut step_state, h);
    let Ok(Solved { z, .. }) = system.solve(&kepler, &mut step_state, &tolerance, (h, [[0.0; 4]; 3])) else {
        panic!("no stages for h = {h}")
    };
    let defect = system.defect(h, &kepler(&y0), &z).map(|x| GAMMA * x);
    let y1 = core::array::from_fn(|i| y0[i] + z[2][i]);
    let mut step = Dense::with_room(5);
    step.set_alternating([3.0, 3.0 + h], y1, dense::coefficients(&y0, &z, &defect));
    step
}

/// A global error of order p shows as p + 1 in one step; 0.2 for the next term of the expansion.
#[test]
fn observed_orders() {
    let [p, q] = step_orders(single, 0.05);
    assert!(p > 5.8, "step: {p}");
    assert!(q > 4.8, "dense output: {q}");
}
