//! Sequences of impacts, their accumulation among them (catalogue 8).

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_fixtures::Particle;

fn drop(e: f64) -> Simulation {
    Simulation::new(&Particle { m: 1.0, g: 1.0, e }).unwrap()
}

/// At rest at √2 (1 + e)/(1 − e) from h = g = 1; for e = 0.8 at 12.727922061357855.
#[test]
fn a_bouncing_point_comes_to_rest() {
    for (e, rest) in [
        (0.8, 12.727922061357855),
        (0.5, 3.0 * 2f64.sqrt()),
        (0.2, 1.5 * 2f64.sqrt()),
        (0.95, 39.0 * 2f64.sqrt()),
    ] {
        let run = drop(e).limit(60.0).run().unwrap();
        let events = run.events();
        let settle = events.iter().find(|event| event.kind == EventKind::Settle).unwrap();
        assert!((settle.t - rest).abs() < 1e-10, "{e}: {settle}");
        assert_eq!((&settle.supports[..], settle.state[3]), (&["P"][..], 0.0));
        assert!(settle.state[1].abs() < 1e-15);
        assert!((settle.reactions[0].value - 1.0).abs() < 1e-15);
        let first = &events[1];
        assert_eq!(first.kind, EventKind::Impact);
        assert!((first.impulses[0].value - (1.0 + e) * 2f64.sqrt()).abs() < 1e-13, "{first:?}");
        assert!((first.state[3] - e * 2f64.sqrt()).abs() < 1e-13);
        assert_eq!(events.last().unwrap().kind, EventKind::End);
        assert!(run.final_state()[1].abs() < 1e-15 && run.final_state()[3] == 0.0);
    }
}

#[test]
fn restitution_is_checked() {
    for value in [-0.1, 1.1] {
        let refused = Simulation::new(&Particle { m: 1.0, g: 1.0, e: value }).err();
        assert_eq!(refused, Some(liftoff::ModelError::Restitution { contact: "P".to_owned(), value }));
    }
}

#[test]
fn a_plastic_point_stays() {
    let run = drop(0.0).limit(3.0).run().unwrap();
    let kinds: Vec<_> = run.events().iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Impact, EventKind::End]);
    assert!((run.events()[1].t - 2f64.sqrt()).abs() < 1e-13);
}

#[test]
fn an_elastic_point_bounces_until_the_limit() {
    let run = drop(1.0).limit(100.0).run().unwrap();
    let impacts: Vec<_> = run.events().iter().filter(|e| e.kind == EventKind::Impact).collect();
    assert_eq!(impacts.len(), 35);
    for (k, impact) in impacts.iter().enumerate() {
        assert!((impact.t - (2 * k + 1) as f64 * 2f64.sqrt()).abs() < 1e-11 * (k + 1) as f64, "{impact}");
    }
    let energy = Output::parse(Particle::LAYOUT, "E").unwrap();
    assert!((run.value(&energy, 100.0) - 1.0).abs() < 1e-12);
}

/// A flight is a parabola, one polynomial from impact to impact, also where it lasts many natural
/// times; the drop begins with a step of one.
#[test]
fn a_flight_is_one_step_of_taylors_method() {
    for e in [1.0, 0.9] {
        let run = drop(e).method(MethodId::Taylor).tolerance(1e-12).limit(20.0).run().unwrap();
        let impacts = run.events().iter().filter(|event| event.kind == EventKind::Impact).count() as u64;
        assert!(impacts > 5 && run.statistics().steps <= impacts + 3, "{impacts} {:?}", run.statistics());
    }
}

/// Rates that drive a closed contact into its support are an impact at t = 0.
#[test]
fn a_start_may_be_an_impact() {
    let start = Pose::new("y", 0.0).with("y'", -1.0);
    let run = drop(0.5).start(start.clone()).unwrap().limit(0.5).run().unwrap();
    let [begin, impact, _] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!((begin.kind, begin.state[3]), (EventKind::Start, -1.0));
    assert_eq!((impact.kind, impact.t, impact.state[3]), (EventKind::Impact, 0.0, 0.5));
    assert_eq!(impact.impulses[0].value, 1.5);
    let run = drop(0.5).start(start).unwrap().stop_at_impacts().run().unwrap();
    let kinds: Vec<_> = run.events().iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Close]);
}

/// A sequence that begins below what can be followed ends by the contact's own restitution; a
/// flight of no height that loses nothing has no end.
#[test]
fn tiny_flights() {
    let start = |v: f64| Pose::new("y", 0.0).with("y'", -v);
    let run = drop(0.5).start(start(1e-9)).unwrap().limit(1.0).run().unwrap();
    let settle = &run.events()[2];
    assert_eq!(settle.kind, EventKind::Settle);
    assert!((settle.t - 2e-9).abs() < 1e-20, "{settle}");
    let error = drop(1.0).start(start(1e-9)).unwrap().limit(1.0).run().unwrap_err();
    assert!(matches!(error.cause(), liftoff::RunCause::Accumulation { t: 0.0, .. }), "{error}");
    assert_eq!(error.trajectory().events().len(), 2);
}

#[test]
fn stops_before_the_impact() {
    let run = drop(0.5).stop_at_impacts().run().unwrap();
    let last = run.events().last().unwrap();
    assert_eq!(last.kind, EventKind::Close);
    assert!((last.state[3] + 2f64.sqrt()).abs() < 1e-13);
    let run = drop(0.5).until("y = 0").unwrap().run().unwrap();
    assert_eq!(run.events().last().unwrap().kind, EventKind::Stop);
    assert!(run.final_state()[3] < 0.0);
}
