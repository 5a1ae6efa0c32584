//! Runs that take more than they may, or no time at all.

use liftoff::__private::impulse::{Collision, CollisionError, Row};
use liftoff::prelude::*;
use liftoff::{Budget, Exhausted, RunCause};
use liftoff_core::model::Law;
use liftoff_fixtures::Particle;
use nalgebra::{DMatrix, DVector};
use std::time::Duration;

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
    let run = run.start(Pose::new("y", 0.0).with("y'", -2.0)).unwrap().run().unwrap();
    let value = |text: &str| run.value(&run.output(text).unwrap(), 0.0);
    assert_eq!([value("y"), value("y'"), value("T")], [0.0, -2.0, 2.0]);
}

/// With e = 0.99 flights last 0.02 natural times long before they are cut short.
#[test]
fn impacts_that_crowd_are_counted() {
    let run = Simulation::new(&Particle { m: 1.0, g: 1.0, e: 0.99 }).unwrap();
    let budget = Budget { impacts: 50, ..Budget::UNLIMITED };
    let error = run.limit(1e4).budget(budget).run().unwrap_err();
    let &RunCause::Budget { t, of: Exhausted::Impacts(50) } = error.cause() else { panic!("{error}") };
    // Flights of 2 v: fifty of them within one natural time where v is about 0.01, of the end at √2
    // (1 + e)/(1 − e).
    let end = 2f64.sqrt() * 1.99 / 0.01;
    assert!((end - 4.0..end).contains(&t), "{t} {end}");
}

#[test]
fn a_run_without_time_left_stops_where_it_is() {
    let budget = |time| Budget { time: Some(time), ..Budget::UNLIMITED };
    let error = bouncing(budget(Duration::ZERO));
    assert_eq!(*error.cause(), RunCause::Budget { t: 0.0, of: Exhausted::Time(Duration::ZERO) });
    assert_eq!(error.trajectory().events().len(), 1);
    let (time, began) = (Duration::from_millis(20), std::time::Instant::now());
    let error = bouncing(budget(time));
    assert!(matches!(error.cause(), RunCause::Budget { of: Exhausted::Time(_), .. }), "{error}");
    // A step takes some microseconds; ten seconds are for machines that do something else.
    assert!(began.elapsed() >= time && began.elapsed() < Duration::from_secs(10));
}

/// A rough contact that slips fast has no impulses: that is known once all sets have been tried.
#[test]
fn a_decision_tries_no_more_sets_than_it_may() {
    let contact = Row::Contact { restitution: 0.0, law: Law::Newton };
    let collision = Collision {
        mass: DMatrix::identity(2, 2),
        jacobian: DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.9, 1.0]),
        rates: DVector::from_row_slice(&[-1.0, -10.0]),
        prescribed_gap_rate: DVector::zeros(2),
        applied: DVector::zeros(2),
        rows: vec![contact, Row::Tangent { of: 0 }],
    };
    assert_eq!(collision.solve().unwrap_err(), CollisionError::Jammed);
    assert_eq!(collision.solve_within(0).unwrap_err(), CollisionError::Exhausted);
}
