//! Contacts that are there while a condition holds.

use liftoff::prelude::*;
use liftoff::{ModelError, Quantity, StartError};

/// A ball that falls on a floor while it is to the right of x = 1, and through it elsewhere.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e, while("x > a"))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (2, 1))]
struct Ledge {
    m: f64,
    g: f64,
    e: f64,
    a: f64,
}

fn ledge(pose: &[(&str, f64)], a: f64) -> Trajectory {
    let ledge = Ledge { m: 1.0, g: 2.0, e: 0.5, a };
    let pose = pose.iter().fold(Pose::nominal(), |pose, (name, value)| pose.with(name, *value));
    let simulation = Simulation::new(&ledge).unwrap().start(pose).unwrap().limit(4.0).tolerance(1e-10);
    simulation.run().unwrap_or_else(|error| panic!("{error} {:?}", error.trajectory().events()))
}

fn kinds(record: &Trajectory) -> Vec<EventKind> {
    record.events().iter().map(|event| event.kind).collect()
}

/// It moves left with unit speed from x = 2.5 and y = 1: it strikes at t = 1, is at the ledge's end
/// x = 1 at t = 1.5 and falls past it.
#[test]
fn a_ball_bounces_off_a_ledge() {
    let record = ledge(&[("x", 2.5), ("y", 1.0), ("x'", -1.0), ("y'", 0.0)], 1.0);
    use EventKind::{Disarm, End, Impact, Start};
    assert_eq!(kinds(&record), [Start, Impact, Disarm, End]);
    let times: Vec<f64> = record.events().iter().map(|event| event.t).collect();
    assert!((times[1] - 1.0).abs() < 1e-10 && (times[2] - 1.5).abs() < 1e-10, "{times:?}");
    // After the impact it rises with e·2 = 1 from t = 1.
    let end = record.events().last().unwrap();
    assert!((end["y"] - (3.0 - 9.0)).abs() < 1e-9, "{end}");
}

/// Lying on the ledge and sliding off it: what it lay on is gone.
#[test]
fn a_ball_slides_off_a_ledge() {
    let record = ledge(&[("x", 2.0), ("y", 0.0), ("x'", -1.0), ("y'", 0.0)], 1.0);
    use EventKind::{Disarm, End, Start};
    assert_eq!(kinds(&record), [Start, Disarm, End], "{:?}", record.events());
    assert!((record.events()[1].t - 1.0).abs() < 1e-10);
    assert!((record.events()[2]["y"] + 9.0).abs() < 1e-9);
}

/// Below the floor, where it is not there, and moving right: it is armed at t = ½ below its ground
/// and is no contact as long as it is there; thrown up it comes back from above and is struck.
#[test]
fn a_contact_armed_below_its_ground_waits() {
    let record = ledge(&[("x", 0.0), ("y", -0.9), ("x'", 2.0), ("y'", 2.0)], 1.0);
    use EventKind::{Arm, End, Impact, Start};
    let kinds = kinds(&record);
    assert_eq!(kinds[..3], [Start, Arm, Impact], "{:?}", record.events());
    assert_eq!(*kinds.last().unwrap(), End);
    assert!((record.events()[1].t - 0.5).abs() < 1e-10);
    // y = −0.9 + 2t − t².
    let struck = 1.0 + 0.1_f64.sqrt();
    assert!((record.events()[2].t - struck).abs() < 1e-9, "{}", record.events()[2]);
    assert!(record.audit().is_clean(), "{:?}", record.audit());
}

/// It comes up at t = 1 − √0.1: from there on it is looked at.
#[test]
fn a_contact_armed_below_its_ground_is_audited_once_it_has_come_up() {
    let pose = Pose::new("x", 0.0).with("y", -0.9).with("x'", 2.0).with("y'", 2.0);
    for (limit, is_seen) in [(0.6, false), (1.2, true)] {
        let ledge = Simulation::new(&Ledge { m: 1.0, g: 2.0, e: 0.5, a: 1.0 }).unwrap();
        let audit = ledge.start(pose.clone()).unwrap().limit(limit).run().unwrap().audit();
        let seen = audit.worst().iter().any(|finding| finding.quantity == Quantity::Penetration);
        assert!(seen == is_seen && audit.is_clean(), "{limit} {audit}");
    }
}

#[test]
fn a_start_agrees_with_the_condition() {
    let ledge = |x: f64| {
        let ledge = Ledge { m: 1.0, g: 2.0, e: 0.5, a: 1.0 };
        Simulation::new(&ledge).unwrap().start(Pose::new("x", x).with("y", -0.5)).map(|_| ())
    };
    assert!(ledge(0.0).is_ok());
    assert!(matches!(ledge(2.0), Err(StartError::Penetrates { .. })));
}

/// A misspelt name in the condition.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, while("z > 0"))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (2, 1))]
struct Misspelt {
    m: f64,
    g: f64,
}

#[test]
fn a_condition_that_is_none_is_reported() {
    let error = Simulation::new(&Misspelt { m: 1.0, g: 1.0 }).map(|_| ()).unwrap_err();
    assert!(matches!(&error, ModelError::Switch { of, .. } if of == "P"), "{error}");
    assert!(error.to_string().contains('z'), "{error}");
}

/// A particle that slides from x = 2 at unit speed.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (2, 1))]
struct Sliding {
    m: f64,
    g: f64,
}

/// Its steps end where it is at x = 1: a comparison that comes to hold there is met there.
#[test]
fn a_condition_met_at_the_end_of_a_step_counts() {
    for condition in ["x < 1", "1 > x", "x = 1", "x + 0*y < 1"] {
        let pose = Pose::new("x", 2.0).with("y", 0.0).with("x'", -1.0).with("y'", 0.0);
        let simulation = Simulation::new(&Sliding { m: 1.0, g: 2.0 }).unwrap().start(pose).unwrap();
        let record = simulation.limit(4.0).tolerance(1e-10).until(condition).unwrap().run().unwrap();
        let last = record.events().last().unwrap();
        assert!(last.kind == EventKind::Stop && (last.t - 1.0).abs() < 1e-12, "{condition}: {last}");
    }
}
