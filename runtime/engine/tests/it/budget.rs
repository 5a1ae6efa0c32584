//! Runs that take more than they may, or no time at all.

use liftoff::prelude::*;
use liftoff::{Budget, Exhausted, RunCause};
use liftoff_fixtures::Particle;

/// An elastic ball would bounce on for ever.
fn bouncing(budget: Budget) -> RunError {
    let run = Simulation::new(&Particle { m: 1.0, g: 1.0, e: 1.0 }).unwrap().limit(1e6);
    run.budget(budget).run().unwrap_err()
}

#[test]
fn a_run_stops_at_its_budget_with_its_motion_so_far() {
    let budgets = [
        (Budget { steps: 20, ..Budget::UNLIMITED }, Exhausted::Steps(20)),
        (Budget { events: 20, ..Budget::UNLIMITED }, Exhausted::Events(20)),
        (Budget { memory: 20_000, ..Budget::UNLIMITED }, Exhausted::Memory(20_000)),
    ];
    for (budget, expected) in budgets {
        let error = bouncing(budget);
        let &RunCause::Budget { t, of } = error.cause() else { panic!("{error}") };
        let run = error.trajectory();
        assert!(of == expected && t == run.end_time() && t > 2.0, "{of} {t}");
        // Every top is as high as the drop.
        assert!((run.state(2.0 * 2f64.sqrt())[1] - 1.0).abs() < 1e-10);
    }
}

#[test]
fn a_run_that_ends_at_once_has_the_values_of_its_start() {
    let run = Simulation::new(&Particle { m: 1.0, g: 1.0, e: 0.5 }).unwrap().stop_at_impacts();
    let run = run.start(Pose::at("y", 0.0).with("y'", -2.0)).unwrap().run().unwrap();
    let value = |text: &str| run.value(&run.output(text).unwrap(), 0.0);
    assert_eq!([value("y"), value("y'"), value("T")], [0.0, -2.0, 2.0]);
}
