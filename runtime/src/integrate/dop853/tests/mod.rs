mod order;

use super::Dop853;
use crate::integrate::{Counts, Progress, StepError, Stepper, Tolerance};
use crate::scalar::{DoubleDouble, Jet, Real, Scalar};

/// Kepler's problem with semi-major axis 1: x, y, x′, y′; period 2π.
fn kepler<S: Scalar>(s: &[S; 4]) -> [S; 4] {
    let square = s[0] * s[0] + s[1] * s[1];
    let cube = square * square.sqrt();
    [s[2], s[3], -(s[0] / cube), -(s[1] / cube)]
}

const ECCENTRICITY: f64 = 0.5;

/// The orbit by Kepler's equation E − e sin E = t, solved in double-double.
fn orbit(t: f64) -> [f64; 4] {
    let e = DoubleDouble::new(ECCENTRICITY, 0.0);
    let one = DoubleDouble::new(1.0, 0.0);
    let t = DoubleDouble::new(t, 0.0);
    let anomaly = (0..20).fold(t, |x, _| {
        let (sin, cos) = x.sin_cos();
        x - (x - e * sin - t) / (one - e * cos)
    });
    let (sin, cos) = anomaly.sin_cos();
    let (minor, rate) = ((one - e * e).sqrt(), one / (one - e * cos));
    [cos - e, minor * sin, -(sin * rate), minor * cos * rate].map(Scalar::to_f64)
}

fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn tolerance<const N: usize>(value: f64) -> Tolerance<N> {
    Tolerance::new(value, [value; N]).expect("a valid tolerance")
}

fn from<S: Scalar, const N: usize>(tol: f64, y0: [S; N]) -> Progress<S, N> {
    Progress::new(tolerance(tol), S::ZERO, y0)
}

/// Integrates to `end`; the largest error of the dense output on the way and at the end, and the work.
fn run(tol: f64, end: f64) -> (Counts, f64) {
    let mut solver = Dop853::new(&kepler, from(tol, orbit(0.0)).with_end(end));
    let mut worst: f64 = 0.0;
    while solver.progress().time() < end {
        solver.step().expect("a smooth orbit");
        let dense = solver.dense();
        for theta in [0.0, 0.3, 0.7, 1.0] {
            worst = worst.max(distance(dense.at(theta), orbit(dense.t0 + theta * dense.h)));
        }
        let end = dense.at(1.0);
        assert_eq!(end, *solver.progress().state());
    }
    assert_eq!(solver.progress().time(), end);
    (solver.progress().counts(), worst)
}

#[test]
fn error_follows_the_tolerance() {
    for tol in [1e-6, 1e-8, 1e-10, 1e-12] {
        let (counts, worst) = run(tol, 20.0);
        // Some hundred steps of error tol each, stretched along the orbit; SciPy's DOP853: 240 tol.
        assert!(worst < 1e3 * tol, "{worst:e} at {tol:e}");
        let spent = 2 + 15 * counts.accepted + 11 * counts.rejected;
        // A trial rejected for its end alone costs one more; here there is none.
        assert_eq!(counts.evaluations, spent);
    }
}

/// The same motion in units of time from 1e-9 to 1e9 takes the same steps.
#[test]
fn steps_do_not_depend_on_the_unit_of_time() {
    let accepted = |unit: f64| {
        let field = |s: &[f64; 2]| [s[1] / unit, -s[0].sin() / unit];
        let mut solver = Dop853::new(&field, from(1e-10, [1.0, 0.0]).with_end(10.0 * unit));
        while solver.progress().time() < 10.0 * unit {
            solver.step().expect("a pendulum");
        }
        solver.progress().counts()
    };
    let one = accepted(1.0);
    assert_eq!(accepted(1024f64.powi(-3)), one);
    assert_eq!(accepted(1024f64.powi(3)), one);
    assert!(one.rejected <= 1, "first step: {one:?}");
}

/// Steps until one fails.
fn failure<S: Scalar, const N: usize>(solver: &mut Dop853<S, N>) -> StepError {
    loop {
        if let Err(failure) = solver.step() {
            return failure;
        }
    }
}

#[test]
fn a_pole_is_a_step_at_its_floor() {
    let field = |y: &[f64; 1]| [y[0] * y[0]];
    let mut solver = Dop853::new(&field, from(1e-10, [1.0]));
    let failure = failure(&mut solver);
    assert!(matches!(failure, StepError::Floor { .. } | StepError::NotFinite { .. }));
    // y = 1/(1 − t).
    let progress = solver.progress();
    assert!((progress.time() - 1.0).abs() < 1e-9 && progress.state()[0] > 1e9, "{failure}");
}

#[test]
fn the_edge_of_a_domain_is_not_finite() {
    let field = |y: &[f64; 1]| [-(y[0] - 0.5).sqrt() - 0.1];
    let mut solver = Dop853::new(&field, from(1e-8, [1.0]));
    let failure = failure(&mut solver);
    assert!(matches!(failure, StepError::NotFinite { .. }), "{failure}");
    assert!((solver.progress().state()[0] - 0.5).abs() < 1e-6, "{failure}");
    let same = |y: &[f64; 1]| *y;
    let mut broken = Dop853::new(&same, from(1e-8, [f64::NAN]));
    assert_eq!(broken.step().err(), Some(StepError::NotFinite { t: 0.0 }));
    assert_eq!(broken.progress().counts().evaluations, 1);
}

#[test]
fn an_equilibrium_costs_no_time() {
    let field = |y: &[f64; 1]| [-y[0]];
    let mut solver = Dop853::new(&field, from(1e-8, [0.0]).with_end(1e6));
    solver.step().expect("an equilibrium");
    assert_eq!((solver.progress().time(), *solver.progress().state()), (1e6, [0.0]));
    assert_eq!(solver.step().err(), Some(StepError::AtEnd { t: 1e6 }));
}

#[test]
fn a_projected_end_is_met_by_the_dense_output() {
    let mut solver = Dop853::new(&kepler, from(1e-8, orbit(0.0)));
    solver.step().expect("a smooth orbit");
    let planned = solver.progress().next_step();
    let projected = solver.progress().state().map(|x| x * (1.0 + 1e-9));
    solver.amend(projected).expect("finite");
    let dense = solver.dense();
    assert_eq!(dense.at(1.0), projected);
    // Rounding of h · k₁₃ against a rise of order 1.
    assert!(distance(dense.rate(1.0), kepler(&projected)) < 1e-14 / dense.h);
    assert_eq!((solver.progress().state(), solver.progress().next_step()), (&projected, planned));
    solver.step().expect("a smooth orbit");
    assert_eq!(solver.dense().at(0.0), projected);
}

/// ∂y/∂y₀ by jets of the initial state, and the other scalars.
#[test]
fn other_scalars_take_the_same_steps() {
    fn last<S: Scalar>(y0: S) -> S {
        let field = |y: &[S; 1]| [-(y[0] * y[0])];
        let end = S::ratio(1, 1);
        let mut solver = Dop853::new(&field, from(1e-6, [y0]).with_end(end));
        while solver.progress().time() < end {
            solver.step().expect("1/(1/y₀ + t)");
        }
        solver.progress().state()[0]
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
