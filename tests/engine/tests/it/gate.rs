//! A motion of a damped model that does not follow its equations, and is found out while it runs.

use liftoff::method::{Dop853, Method, MethodId, Problem, StartedStepper};
use liftoff::prelude::*;
use liftoff::{Quantity, RunCause};
use liftoff_fixtures::SpringPendulum;

/// Dormand and Prince's method at a tolerance of its own.
struct Careless(f64);

impl Method for Careless {
    fn name(&self) -> &'static str {
        "careless"
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        let mut careless = *problem;
        careless.problem.relative = self.0;
        Dop853.begin(&careless)
    }
}

/// A damped pendulum on a spring, drawn out and let go.
fn damped(tolerance: f64) -> Simulation {
    let model = SpringPendulum { m: 1.0, l: 1.0, k: 50.0, c: 0.5, g: 9.81 };
    let run = Simulation::new(&model).unwrap().tolerance(tolerance).limit(4.0);
    run.start(Pose::new("x", 0.8).with("y", 0.9)).unwrap()
}

#[test]
fn energy_that_damping_does_not_explain_is_refused() {
    let error = damped(1e-10).method(Careless(1e-3)).run().unwrap_err();
    let RunCause::Invariant(finding) = error.cause() else { panic!("{error}") };
    assert!(finding.quantity == Quantity::Energy && finding.value > finding.bound, "{finding}");
    assert!(error.trajectory().end_time() > 0.0);
}

/// Methods whose dense output is of lower order too.
#[test]
fn right_motions_pass_at_all_tolerances() {
    for tolerance in [1e-3, 1e-5, 1e-8, 1e-11, 1e-13] {
        for method in [MethodId::Auto, MethodId::Dop853, MethodId::Tsit5, MethodId::Radau, MethodId::Gauss] {
            let run = damped(tolerance).method(method).run();
            let run = run.unwrap_or_else(|error| panic!("{method:?} {tolerance:e}: {error}"));
            // Observed, nothing but the end of the phase is kept.
            let seen = damped(tolerance).method(method).observe(&mut ()).unwrap();
            assert_eq!(run.final_state(), seen.final_state());
        }
    }
}
