//! Friction forces and slip velocities as outputs, in conditions and at events.

use liftoff::prelude::*;
use liftoff::{Budget, Note, OutputError};
use liftoff_fixtures::Belt;

const BELT: Belt = Belt { m: 2.0, g: 10.0, k: 4.0, mu: 0.2, mu_s: 0.5, w: 0.5 };

fn carried() -> Simulation {
    let start = Pose::new("x", 0.0).with("x'", BELT.w);
    Simulation::new(&BELT).unwrap().start(start).unwrap().tolerance(1e-12).limit(20.0)
}

/// While it sticks R = k w t; it slips at R = μₛ m g = 10.
#[test]
fn a_run_ends_where_a_friction_force_or_a_slip_velocity_has_a_value() {
    let until = |condition: &str| carried().until(condition).unwrap().run().unwrap();
    assert!((until("R(P) = 7").end_time() - 3.5).abs() < 1e-10);
    assert!((until("ratio(P) = 0.35").end_time() - 3.5).abs() < 1e-10);
    // Sliding about x_m = μ m g/k = 1 with ω = √2, from 1.5 beyond at w: v = ẋ − w.
    let run = until("v(P) = -1");
    let rate = |t: f64| {
        let turned = 2.0_f64.sqrt() * (t - 5.0);
        BELT.w * turned.cos() - 1.5 * 2.0_f64.sqrt() * turned.sin()
    };
    assert!((rate(run.end_time()) - BELT.w + 1.0).abs() < 1e-9, "{}", run.end_time());
    let [slip, coefficient, force] =
        ["v(P)", "mu(P)", "R(P)"].map(|output| run.value(&run.output(output).unwrap(), run.end_time()));
    assert!((slip + 1.0).abs() < 1e-10 && coefficient == BELT.mu && (force - 4.0).abs() < 1e-12);
    assert_eq!(run.value(&run.output("mu(P)").unwrap(), 1.0), BELT.mu_s);
}

/// The friction force follows its contact in the reactions of events: μₛ m g before a slip and μ m
/// g behind it.
#[test]
fn events_have_friction_forces() {
    let run = carried().run().unwrap();
    let slip = run.events().iter().find(|event| event.kind == EventKind::Slip).unwrap();
    assert!((slip.reactions[0].friction.unwrap() - 4.0).abs() < 1e-12, "{:?}", slip.reactions);
    let before = run.value(&run.output("R(P)").unwrap(), slip.t.next_down());
    assert!((before - 10.0).abs() < 1e-9, "{before}");
}

/// An event tells the limit that was reached, μₛ = ½ with which it leaves the belt, and the limit
/// that holds it when it comes back.
#[test]
fn events_tell_the_limit_that_decided_them() {
    let run = carried().run().unwrap();
    let event = |kind: EventKind| run.events().iter().find(|event| event.kind == kind).unwrap();
    let [slip, stick] = [EventKind::Slip, EventKind::Stick].map(|kind| match &event(kind).note {
        Some(Note::Friction(states)) => states[0].clone(),
        note => panic!("{note:?}"),
    });
    assert_eq!((slip.limit, slip.slides), (BELT.mu_s, true));
    assert!((slip.force / slip.normal - BELT.mu).abs() < 1e-12, "{slip:?}");
    assert!(event(EventKind::Slip).to_string().ends_with("(|R|/N reached 0.5 at P, now 0.2000)"));
    assert_eq!((stick.limit, stick.slides, stick.undecided), (BELT.mu_s, false, false));
    assert!((stick.force / stick.normal).abs() < BELT.mu_s, "{stick:?}");
}

/// Without kinetic friction it comes back to the velocity of the belt where its force is at the
/// static limit again, but for rounding: that it sticks there is said to be undecided.
#[test]
fn what_comes_to_rest_at_its_limit_is_undecided() {
    let model = Belt { mu: 0.0, ..BELT };
    let rests = [1e-7, 1e-8, 1e-9, 1e-10, 1e-11].into_iter().flat_map(|tolerance| {
        let start = Pose::new("x", 0.0).with("x'", BELT.w);
        let run = Simulation::new(&model).unwrap().start(start).unwrap();
        let run = run.tolerance(tolerance).limit(20.0).run().unwrap();
        run.events().iter().find(|event| event.kind == EventKind::Stick).map(|event| event.is_undecided())
    });
    let rests: Vec<bool> = rests.collect();
    assert!(!rests.is_empty() && rests.iter().all(|is_undecided| *is_undecided), "{rests:?}");
}

/// Thrown onto a floor at 45°, it keeps v − μ (1 + e) |w|: the impulses are (1 + e) m |w| and μ of
/// that, against the slip.
#[test]
fn impacts_have_friction_impulses() {
    let thrown = Pose::new("x", 3.0).with("y", 0.1).with("x'", 3.0).with("y'", -3.0);
    let smooth = Belt { k: 0.0, w: 0.0, mu_s: 0.2, ..BELT };
    let run = Simulation::new(&smooth).unwrap().start(thrown).unwrap().limit(0.1).run().unwrap();
    let impact = run.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    let [impulse] = &impact.impulses[..] else { panic!("{:?}", impact.impulses) };
    let speed = (9.0_f64 + 2.0 * 10.0 * 0.1).sqrt();
    assert!((impulse.value - 2.0 * speed).abs() < 1e-9, "{impulse:?}");
    assert!((impulse.friction.unwrap() + 0.2 * impulse.value).abs() < 1e-9, "{impulse:?}");
    assert!((impact["x'"] - 3.0 + 0.2 * speed).abs() < 1e-9);
}

/// A block on a smooth floor.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor)]
#[figure(P = (0, 0))]
struct Smooth {
    m: f64,
    g: f64,
}

#[test]
fn errors_say_how_to_declare_friction() {
    for output in ["R(P)", "v(P)", "mu(P)", "ratio(P)"] {
        let error = Output::parse(Smooth::LAYOUT, output).unwrap_err();
        assert_eq!(error, OutputError::Smooth { contact: "P".into() });
        assert!(error.to_string().contains("`friction = mu`"), "{error}");
    }
}

/// A block on a slope whose friction grows with its speed.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = slope(alpha), friction = mu + k * abs(v))]
#[force(pull = (p * sin(t), 0), at = P)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Viscous {
    m: f64,
    alpha: f64,
    mu: f64,
    k: f64,
    p: f64,
    g: f64,
}

/// While it sticks |v| is zero and stays so: it has no kink that steps end at.
#[test]
fn friction_by_speed_takes_no_more_steps_while_it_sticks() {
    let block = Viscous { m: 1.0, alpha: 0.25, mu: 0.3, k: 0.1, p: 0.2, g: 9.81 };
    let budget = Budget { steps: 500, ..Budget::UNLIMITED };
    let run = Simulation::new(&block).unwrap().budget(budget).limit(10.0).run().unwrap();
    assert_eq!(run.events().len(), 2, "{:?}", run.events());
    assert!(run.final_state()[..2].iter().all(|x| x.abs() < 1e-12), "{:?}", run.final_state());
}
