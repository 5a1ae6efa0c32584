mod order;

use super::Dop853;
use crate::integrate::tests::fields::{distance, kepler, orbit};
use crate::integrate::tests::from;
use crate::integrate::{Counts, Stepper};
use crate::scalar::{DoubleDouble, Jet, Real, Scalar};

/// Integrates to `end`; the largest error of the dense output on the way and at the end, and the
/// work.
fn run(tol: f64, end: f64) -> (Counts, f64) {
    let mut solver = Dop853::new(&kepler, from(tol, orbit(0.0)).with_end(end));
    let mut worst: f64 = 0.0;
    while solver.step_state().time() < end {
        solver.step().expect("a smooth orbit");
        let dense = solver.dense();
        for theta in [0.0, 0.3, 0.7, 1.0] {
            worst = worst.max(distance(dense.interpolate(theta), orbit(dense.t0 + theta * dense.h)));
        }
        let end = dense.interpolate(1.0);
        assert_eq!(end, *solver.step_state().state());
    }
    assert_eq!(solver.step_state().time(), end);
    (solver.step_state().counts(), worst)
}

#[test]
fn error_follows_the_tolerance() {
    for tol in [1e-6, 1e-8, 1e-10, 1e-12] {
        let (counts, worst) = run(tol, 20.0);
        // Some hundred steps of error tol each, stretched along the orbit; SciPy's DOP853: 240 tol.
        assert!(worst < 1e3 * tol, "{worst:e} at {tol:e}");
        let spent = 2 + 15 * counts.accepted + 11 * counts.rejected;
        // A trial rejected for its end alone costs one more; here there is none. Where errors are
        // tiny growth is looked for, four evaluations each.
        let looked = counts.evaluations - spent;
        assert!(looked % 4 == 0 && looked < spent / 20, "{looked}");
    }
}

/// ∂y/∂y₀ by jets of the initial state, and the other scalars.
#[test]
fn other_scalars_take_the_same_steps() {
    fn last<S: Scalar>(y0: S) -> S {
        let field = |y: &[S; 1]| [-(y[0] * y[0])];
        let end = S::ratio(1, 1);
        let mut solver = Dop853::new(&field, from(1e-6, [y0]).with_end(end));
        while solver.step_state().time() < end {
            solver.step().expect("1/(1/y₀ + t)");
        }
        solver.step_state().state()[0]
    }
    let jet = last(Jet::new([2.0, 1.0]));
    let (value, slope) = (2.0 / 3.0, 1.0 / 9.0);
    assert!((last(2.0) - value).abs() < 1e-6);
    assert_eq!(jet.coefficient(0), last(2.0));
    assert!((jet.coefficient(1) - slope).abs() < 1e-6);
    // Six digits in single precision are some 20 roundings.
    assert!((last(2f32) - value as f32).abs() < 20.0 * f32::EPSILON);
    assert!((last(DoubleDouble::from_f64(2.0)).to_f64() - last(2.0)).abs() < 1e-14);
}
