//! What every method does: with tolerances and units, at poles, edges, equilibria and ends.

pub(super) mod fields;
mod growth;
pub(super) mod jets;
pub(super) mod orders;

use super::{Dop853, Gauss, Radau, StepError, StepState, Stepper, Taylor, Tolerance, Tsit5};
use crate::scalar::Scalar;
use fields::{Decay, Edge, Field, Kepler, Pendulum, Pole, distance, kepler, orbit};
use jets::Jets;

/// A start at time 0.
pub(super) fn from<S: Scalar, const N: usize>(tol: f64, y0: [S; N]) -> StepState<S, N> {
    StepState::new(Tolerance::new(tol, [tol; N]).expect("a valid tolerance"), S::ZERO, y0)
}

/// Shows an integration by each method, with the method's name.
fn with_each<const N: usize>(
    field: &impl Field<N>,
    step_state: &StepState<f64, N>,
    mut check: impl FnMut(&str, &mut dyn Stepper<f64, N>),
) {
    let f = |y: &[f64; N]| field.rates(y);
    check("dop853", &mut Dop853::new(&f, step_state.clone()));
    check("taylor", &mut Taylor::new(Jets::new(field), step_state.clone()));
    check("tsit5", &mut Tsit5::new(&f, step_state.clone()));
    check("gauss", &mut Gauss::new(&f, step_state.clone()));
    check("radau", &mut Radau::new(&f, |y: &[f64; N]| field.jacobian(y), step_state.clone()));
}

/// Steps until one fails.
fn failure<const N: usize>(solver: &mut dyn Stepper<f64, N>) -> StepError {
    loop {
        if let Err(failure) = solver.step() {
            return failure;
        }
    }
}

/// Three turns of an eccentric orbit: hundred steps and more, each with an error of the tolerance
/// that the orbit stretches some ten times; so also the dense output, which meets the states at
/// both ends.
#[test]
fn errors_follow_the_tolerance() {
    for tol in [1e-5, 1e-7, 1e-9] {
        with_each(&Kepler, &from(tol, orbit(0.0)).with_end(20.0), |name, solver| {
            let (mut end, mut inside): (f64, f64) = (0.0, 0.0);
            while solver.step_state().time() < 20.0 {
                solver.step().expect("a smooth orbit");
                let (t, y) = (solver.step_state().time(), *solver.step_state().state());
                end = end.max(distance(y, orbit(t)));
                let dense = solver.dense();
                assert_eq!(dense.interpolate(1.0), y);
                for theta in [0.0, 0.3, 0.7] {
                    inside =
                        inside.max(distance(dense.interpolate(theta), orbit(dense.t0 + theta * dense.h)));
                }
            }
            assert_eq!(solver.step_state().time(), 20.0);

            assert!(end < 2e3 * tol && inside < 2e3 * tol, "{name}: {end:e}, {inside:e} at {tol:e}");
        });
    }
}

/// The same motion in units of time from 1e-9 to 1e9 takes the same steps.
#[test]
fn steps_do_not_depend_on_the_unit_of_time() {
    let counts = |unit: f64| {
        let mut counts = Vec::new();
        with_each(&Pendulum { unit }, &from(1e-8, [1.0, 0.0]).with_end(10.0 * unit), |_, solver| {
            assert_eq!(failure(solver), StepError::AtEnd { t: 10.0 * unit });
            counts.push(solver.step_state().counts());
        });
        counts
    };
    let one = counts(1.0);
    assert_eq!(counts(1024f64.powi(-3)), one);
    assert_eq!(counts(1024f64.powi(3)), one);
}

#[test]
fn a_pole_is_a_step_at_its_floor() {
    with_each(&Pole, &from(1e-8, [1.0]), |name, solver| {
        let failure = failure(solver);
        assert!(
            matches!(
                failure,
                StepError::Floor { .. } | StepError::Iteration { .. } | StepError::NotFinite { .. }
            ),
            "{name}: {failure}"
        );
        // y = 1/(1 − t): the pole is moved by errors as they were while y was of order 1, 1e-8 and
        // some.
        let step_state = solver.step_state();
        let (t, y) = (step_state.time(), step_state.state()[0]);
        assert!((t - 1.0).abs() < 1e-6 && y > 1e6, "{name}: {failure}, y = {y:e} at {t}");
    });
}

#[test]
fn the_edge_of_a_domain_is_not_finite() {
    with_each(&Edge, &from(1e-8, [1.0]), |name, solver| {
        let failure = failure(solver);
        assert!(matches!(failure, StepError::NotFinite { .. }), "{name}: {failure}");
        let y = solver.step_state().state()[0];
        assert!((y - 0.5).abs() < 1e-6, "{name}: {failure}, y = {y}");
    });
    with_each(&Decay, &from(1e-8, [f64::NAN]), |name, solver| {
        assert_eq!(solver.step().err(), Some(StepError::NotFinite { t: 0.0 }), "{name}");
        assert_eq!(solver.step_state().counts().evaluations, 1, "{name}");
    });
}

#[test]
fn an_equilibrium_costs_no_time() {
    with_each(&Decay, &from(1e-8, [0.0]).with_end(1e6), |name, solver| {
        solver.step().expect("an equilibrium");
        assert_eq!((solver.step_state().time(), *solver.step_state().state()), (1e6, [0.0]), "{name}");
        assert_eq!(solver.step().err(), Some(StepError::AtEnd { t: 1e6 }), "{name}");
    });
}

#[test]
fn a_projected_end_is_met_by_the_dense_output() {
    with_each(&Kepler, &from(1e-8, orbit(0.0)), |name, solver| {
        solver.step().expect("a smooth orbit");
        let planned = solver.step_state().next_step();
        let projected = solver.step_state().state().map(|x| x * (1.0 + 1e-9));
        solver.replace_end(projected).expect("finite");
        assert_eq!(
            (solver.step_state().state(), solver.step_state().next_step()),
            (&projected, planned),
            "{name}"
        );
        let dense = solver.dense();
        assert_eq!(dense.interpolate(1.0), projected, "{name}");
        // The rate is that of the projected state but for what the projection moved and the order
        // leaves: 1e-9/h, and the tolerance.
        let defect = distance(dense.rate(1.0), kepler(&projected));
        assert!(defect < 2e-8 / dense.h, "{name}: {defect:e}");
        solver.step().expect("a smooth orbit");
        assert_eq!(solver.dense().interpolate(0.0), projected, "{name}");
    });
}

/// A jump is a new start: of the old f, Jacobian and polynomial nothing is kept.
#[test]
fn a_jump_is_a_new_start() {
    with_each(&Kepler, &from(1e-9, orbit(0.0)).with_end(20.0), |name, solver| {
        solver.step().expect("a smooth orbit");
        solver.step_state_mut().jump(10.0, orbit(10.0), 1e-3);
        solver.step_state_mut().set_end(12.0);
        assert_eq!(failure(solver), StepError::AtEnd { t: 12.0 });
        let error = distance(*solver.step_state().state(), orbit(12.0));
        // As over any two units of time.
        assert!(error < 1e-7, "{name}: {error:e}");
    });
}

/// From s = ½ on v is driven across zero wherever it is: a stage has no fixed point, however short
/// the step.
#[test]
fn an_iteration_that_never_converges_is_reported_with_what_to_use() {
    let f = |&[s, v]: &[f64; 2]| {
        let across = if v < 0.0 { 1e12 } else { -1e12 };
        [1.0, if s < 0.5 { 0.0 } else { across }]
    };
    let failure = failure(&mut Gauss::new(f, from(1e-8, [0.0, 0.0]).with_end(1.0)));
    assert!(matches!(failure, StepError::Iteration { t, .. } if (t - 0.5).abs() < 1e-6), "{failure}");
    assert!(failure.to_string().contains("radau"), "{failure}");
}

/// A fall past a centre at a distance of 1e-4, y″ = −y/(y² + 1e-8)^(3/2): the step there would
/// serve for all the rest.
#[test]
fn a_step_that_becomes_far_too_short_for_a_run_is_reported() {
    let f = |&[y, v]: &[f64; 2]| [v, -y * (y * y + 1e-8).powf(-1.5)];
    let failure = failure(&mut Gauss::new(f, from(1e-9, [1.0, 0.0]).with_end(10.0)));
    assert!(
        matches!(failure, StepError::Constant { t, h, .. } if (1.0..2.0).contains(&t) && h < 1e-5),
        "{failure}"
    );
}
