//! Clutches that a condition on their own motion would let come and go without end.

use liftoff::RunCause;
use liftoff::prelude::*;

/// A flywheel that a couple speeds up, held by a slowing shaft while it is fast.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[point(O = AB, at = l / 2)]
#[pin(O = (0, 0))]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[couple(AB = c)]
#[drive(phi = w * t - a * t * t, while("phi' > v"))]
struct Held {
    m: f64,
    l: f64,
    c: f64,
    w: f64,
    a: f64,
    v: f64,
}

/// Let go at w − 2 a t = v the wheel would be sped up at once, and held again.
#[test]
fn a_clutch_that_its_own_motion_closes_again_is_refused_by_name() {
    let held = Held { m: 1.0, l: 1.0, c: 1.0, w: 1.0, a: 0.5, v: 0.5 };
    let made = Simulation::new(&held)
        .unwrap()
        .start(Pose::new("phi", 0.0).with("phi'", 1.0))
        .unwrap()
        .limit(5.0)
        .run();
    let error = made.map(|_| ()).unwrap_err();
    assert!(
        matches!(error.cause(), RunCause::Chatter { t, of, .. } if (t - 0.5).abs() < 1e-10 && of == "drive phi"),
        "{error}"
    );
}

/// Slowed by its couple too it is let go for good: φ' = v + (c/J)(t − t_0).
#[test]
fn a_clutch_that_its_own_motion_keeps_open_lets_go_once() {
    let held = Held { m: 1.0, l: 1.0, c: -1.0, w: 1.0, a: 0.5, v: 0.5 };
    let run = Simulation::new(&held)
        .unwrap()
        .start(Pose::new("phi", 0.0).with("phi'", 1.0))
        .unwrap()
        .limit(1.0)
        .run();
    let run = run.unwrap_or_else(|error| panic!("{error}"));
    let kinds: Vec<EventKind> = run.events().iter().map(|event| event.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Disarm, EventKind::End], "{:?}", run.events());
    assert!((run.events()[2]["phi'"] - (0.5 - 12.0 * 0.5)).abs() < 1e-10, "{}", run.events()[2]);
}
