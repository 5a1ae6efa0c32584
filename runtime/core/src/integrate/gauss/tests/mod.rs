//! Coefficients, orders and long runs.

mod long;

use super::Gauss;
use super::dense::{Fine, TERMS};
use super::legendre::{FINE, STAGES};
use super::stages::{CollocationEquations, Sum};
use super::tableau::Tableau;
use crate::integrate::tests::fields::{distance, kepler, orbit};
use crate::integrate::tests::orders::step_orders;
use crate::integrate::{Dense, StepState, Stepper, Tolerance};

/// The order conditions of collocation at Gauss's nodes: Σ bⱼ cⱼᵏ = 1/(k + 1) for k < 2s and Σ aᵢⱼ
/// cⱼᵏ = cᵢᵏ⁺¹/(k + 1) for k < s; rounding of sums of up to twelve.
fn collocates<const S: usize>() {
    let tableau = Tableau::<S>::new();
    let c = tableau.nodes.map(|x| 0.5 * (1.0 + x));
    let sum = |row: [f64; S], k: usize| (0..S).map(|j| row[j] * c[j].powi(k as i32)).sum::<f64>();
    for k in 0..2 * S {
        let moment = sum(tableau.weights, k);
        assert!((moment * (k + 1) as f64 - 1.0).abs() < 1e-14, "b, k = {k}: {moment}");
    }
    for (i, mu) in tableau.mu.iter().enumerate() {
        let row = core::array::from_fn(|j| mu[j] * tableau.weights[j]);
        for k in 0..S {
            let moment = sum(row, k) * (k + 1) as f64;
            assert!((moment - c[i].powi(k as i32 + 1)).abs() < 4e-15, "a, i = {i}, k = {k}: {moment}");
        }
    }
}

#[test]
fn coefficients_are_those_of_collocation() {
    collocates::<STAGES>();
    collocates::<FINE>();
}

/// μᵢⱼ + μⱼᵢ = 1 and the mirror images of the nodes, without any rounding.
#[test]
fn coefficients_are_symplectic_and_symmetric() {
    let Tableau { mu, weights, .. } = Tableau::<STAGES>::new();
    for i in 0..STAGES {
        assert_eq!(weights[i], weights[STAGES - 1 - i]);
        for j in 0..STAGES {
            assert_eq!(mu[i][j] + mu[j][i], 1.0);
            assert_eq!(mu[i][j], mu[STAGES - 1 - j][STAGES - 1 - i]);
        }
    }
}

/// The continued slopes of a cubic motion are its slopes: weights up to 300 times rounding.
#[test]
fn a_polynomial_is_continued() {
    let tableau = Tableau::<STAGES>::new();
    let at = |t: f64| 1.0 + t * (2.0 - t * t);
    let slopes = |start: f64, h: f64| {
        core::array::from_fn::<_, STAGES, _>(|j| {
            [h * tableau.weights[j] * at(start + 0.5 * h * (1.0 + tableau.nodes[j]))]
        })
    };
    for ratio in [1.0, 0.3, 1.7] {
        let next = tableau.continuation(&slopes(0.0, 0.5), ratio).map(|[l]| l);
        assert!(distance(next, slopes(0.5, 0.5 * ratio).map(|[l]| l)) < 1e-12, "{ratio}: {next:?}");
    }
    let again = tableau.of_modes(&tableau.modes(&slopes(0.0, 0.5)));
    assert!(distance(again.map(|[l]| l), slopes(0.0, 0.5).map(|[l]| l)) < 1e-14);
}

/// One step of length `h` from the orbit at time 3.
fn single(h: f64) -> Dense<f64, 4> {
    let (tableau, y0) = (Tableau::<STAGES>::new(), orbit(3.0));
    let equations = CollocationEquations { f: &kepler, tableau: &tableau, pairs: 2 };
    let start = Sum::new(y0);
    let mut l = tableau.constant(h, &kepler(&y0));
    assert!(equations.solve((&start, h), &mut l, [&[0.0; 4]; 2], &mut 0).is_ok());
    let y1 = start.advance(&l).high;
    let modes = tableau.modes(&l);
    let terms = Fine::new().coefficients((&kepler, 2), (&y0, h), (&modes, &[0.0; 4]), &mut 0);
    let mut step = Dense::with_room(TERMS);
    step.set_alternating([3.0, 3.0 + h], y1, terms);
    step
}

/// A global error of order p shows as p + 1 in one step; half a unit for the next terms of the
/// expansion at steps so long that the error is above rounding.
#[test]
fn observed_orders() {
    let [p, q] = step_orders(single, 0.7);
    assert!(p > 12.5, "step: {p}");
    assert!(q > 12.5, "dense output: {q}");
}

/// The polynomial has the right slopes at both ends, and the step's end.
#[test]
fn dense_output_is_smooth() {
    let step = single(0.4);
    // Rounding of coefficients of order 1, divided by h.
    assert!(distance(step.rate(0.0), kepler(&orbit(3.0))) < 1e-13);
    assert!(distance(step.rate(1.0), kepler(step.end())) < 1e-13);
    assert!(distance(step.interpolate(1.0 - 1e-16), *step.end()) < 1e-14);
}

/// Slopes that are even about the middle of a step have no odd modes: the even ones foretell the
/// error, that of the quadrature h ∫ cos(a x) dx/2 = h sin(a)/a over x from −1 to 1.
#[test]
fn errors_are_predicted_by_either_parity() {
    let tableau = Tableau::<STAGES>::new();
    let tolerance = Tolerance::new(1e-9, [1e-9]).unwrap();
    let gauss = Gauss::new(|_: &[f64; 1]| [1.0], StepState::new(tolerance, 0.0, [0.0]));
    for (a, shift) in [(3.0, 0.0), (5.0, 0.0), (3.0, 0.5), (5.0, 1.5)] {
        let slope = |x: f64| (a * x + shift).cos();
        let l = core::array::from_fn(|j| [tableau.weights[j] * slope(tableau.nodes[j])]);
        let exact = a.sin() * shift.cos() / a;
        let error = (l.iter().map(|[l]| l).sum::<f64>() - exact).abs();
        let [last, foretold] = gauss.last_modes(&l, &[1.0]);
        assert_eq!(shift == 0.0, last < 1e-14, "{a} {shift}: {last}");
        assert!(foretold > error && foretold < 1e5 * error, "{a} {shift}: {error} {foretold}");
    }
}

/// y₁′ = 2, as the time of a system that rests: no step leaves anything out.
#[test]
fn uniform_motion_takes_long_steps() {
    for tolerance in [1e-3, 1e-9] {
        let tolerance = Tolerance::new(tolerance, [1e-12; 2]).unwrap();
        let step_state = StepState::new(tolerance, 0.0, [0.0, 1.0]).with_end(50.0);
        let mut solver = Gauss::new(|_: &[f64; 2]| [2.0, 0.0], step_state);
        let mut steps = 0;
        while solver.step_state().time() < 50.0 {
            solver.step().expect("a uniform motion");
            steps += 1;
        }
        assert!(steps <= 4, "{steps}");
        assert!((solver.step_state().state()[0] - 100.0).abs() < 1e-13 * 100.0);
    }
}
