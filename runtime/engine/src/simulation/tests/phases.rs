//! How phases end, and what is told of them.

use liftoff_fixtures::{AFrame, Bob, Particle};

use super::given::*;
use crate::event::EventKind;
use crate::prelude::*;
use crate::trajectory::LoggedDecision;
use crate::trajectory::observe::{Observer, Step};

fn kinds(run: &Trajectory) -> Vec<EventKind> {
    run.events().iter().map(|event| event.kind).collect()
}

/// What closes at the end of a run but for what counts as zero closes in the run.
#[test]
fn an_impact_within_its_bound_of_the_end_belongs_to_the_run() {
    let ball = Simulation::new(&Particle { m: 1.0, g: 10.0, e: 0.5 }).unwrap();
    let falling = ball.start(Pose::new("y", 5.0)).unwrap();
    let falls = |limit: f64| kinds(&falling.clone().limit(limit).run().unwrap());
    assert_eq!(falls(1.0 - 1e-12), [EventKind::Start, EventKind::Impact, EventKind::End]);
    assert_eq!(falls(1.0 - 1e-9), [EventKind::Start, EventKind::End]);
}

/// The state at an event within a step satisfies the closed contacts, however loose the tolerance.
#[test]
fn a_phase_with_multipliers_ends_on_its_contacts() {
    let bob = Simulation::new(&Bob { m: 2.0, l: 1.0, g: 1.0 }).unwrap().tolerance(1e-5);
    let bob = bob.start(Pose::new("x", -1.0).with("y", 0.0)).unwrap().form(Form::Multipliers);
    let run = bob.until("x = 0.1").unwrap().run().unwrap();
    let [x, y, u, v] = run.final_state()[..] else { panic!() };
    assert!((x * x + y * y - 1.0).abs() < 1e-15 && (x * u + y * v).abs() < 1e-15, "{x} {y} {u} {v}");
}

/// An observer of the times of events.
#[derive(Default)]
struct Times(Vec<f64>);

impl Observer for Times {
    fn event(&mut self, t: f64) {
        self.0.push(t);
    }

    fn step(&mut self, _: &dyn Step) {}
}

/// A reaction that touches zero is an event that observers are told of as of any other.
#[test]
fn observers_are_reported_when_a_guard_touches_zero() {
    let s = 80f64.to_radians();
    let pose = Pose::new("phi", s).with("phi'", -(3.0 * (1.0 - s.sin())).sqrt());
    let frame = Simulation::new(&AFrame { m: 1.0, l: 1.0, g: 1.0 }).unwrap().start(pose).unwrap();
    let mut told = Times::default();
    let run = frame.until("h = 0.1").unwrap().observe(&mut told).unwrap();
    assert_eq!(kinds(&run), [EventKind::Start, EventKind::Touch, EventKind::Stop]);
    assert_eq!(told.0, run.events().iter().map(|event| event.t).collect::<Vec<_>>());
}

/// A step that comes to a small pivot is made with multipliers.
#[test]
fn a_phase_leaves_its_reduced_form_where_a_pivot_is_small() {
    let (sin, cos) = 1.3f64.sin_cos();
    let pose = Pose::new("theta", 1.3).with("theta'", 1.0).with("x", -0.5 * cos).with("y", -0.5 * sin);
    let bar = Simulation::new(&Overhang { m: 1.0, l: 1.0, g: 1.0 }).unwrap();
    let bar = bar.start(pose.with("x'", 0.5 * sin)).unwrap();
    let left = |limit: f64| -> Vec<f64> {
        let run = bar.clone().limit(limit).run().unwrap();
        let small = run.log().iter().filter(|entry| entry.decision == LoggedDecision::SmallPivot);
        small.map(|entry| entry.t).collect()
    };
    assert!(matches!(left(0.15)[..], [t] if t < 0.15), "{:?}", left(0.15));
    // cos θ is 0.26 there.
    assert!(left(0.01).is_empty());
}

/// A particle that falls at once, with a fan that is there while it does.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[force(P = (0, -r), while("y' < 0"))]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Fanned {
    m: f64,
    g: f64,
    r: f64,
}

/// A condition that becomes true at the start of a phase ends it at once: nothing of it is kept.
#[test]
fn a_phase_of_no_duration_is_not_kept() {
    let fanned = Simulation::new(&Fanned { m: 1.0, g: 1.0, r: 2.0 }).unwrap();
    let run = fanned.start(Pose::new("y", 1.0)).unwrap().limit(2.0).run().unwrap();
    assert_eq!(kinds(&run), [EventKind::Start, EventKind::Arm, EventKind::End]);
    assert_eq!((run.events()[1].t, run.segments().len()), (0.0, 1));
    assert!((run.final_state()[1] + 5.0).abs() < 1e-12);
}
