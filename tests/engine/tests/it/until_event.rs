//! Runs that end with an event.

use liftoff::LoggedDecision;
use liftoff::prelude::*;
use liftoff_fixtures::Particle;

/// A ball that falls from 1 to the floor, from rest, with e = ½.
fn ball() -> Simulation {
    Simulation::new(&Particle { m: 1.0, g: 1.0, e: 0.5 }).unwrap().limit(100.0)
}

#[test]
fn a_run_ends_with_the_event_and_has_the_values_after_it() {
    let run = ball().until_event(EventKind::Impact, None).unwrap().run().unwrap();
    let kinds: Vec<_> = run.events().iter().map(|event| event.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Impact]);
    assert!((run.end_time() - 2f64.sqrt()).abs() < 1e-12);
    // It leaves with half the speed √2 that it came with.
    let speed = Output::parse(Particle::LAYOUT, "y'").unwrap();
    assert!((run.value(&speed, run.end_time()) - 0.5 * 2f64.sqrt()).abs() < 1e-12);
}

#[test]
fn of_several_events_each_must_have_happened() {
    let run = ball().until_event(EventKind::Impact, Particle::P).unwrap();
    let run = run.until_event(EventKind::Settle, None).unwrap().run().unwrap();
    // The flights last √2 · (1, 1, ½, ¼, …).
    assert!((run.end_time() - 3.0 * 2f64.sqrt()).abs() < 1e-9, "{}", run.end_time());
}

#[test]
fn a_support_that_is_none_is_reported() {
    let Err(error) = ball().until_event(EventKind::Impact, "Q") else { panic!("there is no Q") };
    assert_eq!(error.to_string(), "no support `Q`; known: P");
}

/// A mass on a spring.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[particle(P, mass = 1)]
#[slider(P = horizontal(0))]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = 1)]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
struct Oscillator;

/// Its place is cos t: it comes near to a condition within the error bound, and does not meet it.
/// That is told.
#[test]
fn a_condition_that_is_only_nearly_met_is_undecided() {
    for method in liftoff::method::MethodId::ALL {
        let run = Simulation::new(&Oscillator).unwrap().start(Pose::new("x", 1.0)).unwrap().method(method);
        let run = run.until("x = -1.000000000001").unwrap().limit(8.0).run().unwrap();
        assert_eq!(run.end_time(), 8.0, "{method:?}");
        let log = run.log().iter();
        let undecided = log.filter(|entry| entry.decision == LoggedDecision::ConditionUndecided).count();
        assert_eq!(undecided, 1, "{method:?}");
    }
}
