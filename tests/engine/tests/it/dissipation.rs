//! The energy lost to friction, dampers and impacts.

use core::f64::consts::PI;

use liftoff::OutputError;
use liftoff::prelude::*;
use liftoff_fixtures::Belt;

fn value(run: &Trajectory, output: &str, t: f64) -> f64 {
    run.value(&run.output(output).unwrap(), t)
}

/// Along the way of the friction oscillator: turning points 15.42…, 13.42…, at last 15 − √205, each
/// F nearer to the middle.
#[test]
fn friction_takes_its_force_times_the_way() {
    let oscillator = Belt { m: 1.0, g: 10.0, k: 1.0, mu: 0.1, mu_s: 0.1, w: 0.0 };
    let start = Pose::new("x", 12.0).with("x'", 6.0);
    let run = Simulation::new(&oscillator).unwrap().start(start).unwrap().limit(40.0).tolerance(1e-12).run();
    let run = run.unwrap();
    let turn = 205.0_f64.sqrt() - 1.0;
    let turns = (0..8).map(|k| turn - 2.0 * f64::from(k));
    let way: f64 = turn - 12.0 + turns.clone().zip(turns.skip(1)).map(|(a, b)| a + b).sum::<f64>();
    let rest = run.events().iter().find(|event| event.kind == EventKind::Stick).unwrap();
    assert!((rest["x"].abs() - (turn - 14.0).abs()).abs() < 1e-9, "{rest}");
    assert!((value(&run, "D", 40.0) - way).abs() < 1e-8, "{} {way}", value(&run, "D", 40.0));
    let quarter = 0.5 * (6.0_f64 / 13.0).atan();
    assert!((value(&run, "D", quarter) - (value(&run, "x", quarter) - 12.0)).abs() < 1e-11);
    let [_, most] = run.range(&run.output("D").unwrap()).unwrap();
    assert_eq!(most, value(&run, "D", 40.0));
}

/// A block without a spring is carried along: the slip v₀ of its start takes ½ m v₀², whatever the
/// speed of the belt, which does the work m v₀ w on it.
#[test]
fn a_moving_surface_does_work() {
    for w in [-0.7, 0.0, 1.5] {
        let belt = Belt { m: 2.0, g: 10.0, k: 0.0, mu: 0.3, mu_s: 0.3, w };
        let slip = 1.2;
        let start = Pose::new("x", 2.0).with("x'", w - slip);
        let run =
            Simulation::new(&belt).unwrap().start(start).unwrap().limit(1.0).tolerance(1e-12).run().unwrap();
        assert!((value(&run, "D", 1.0) - slip * slip).abs() < 1e-10);
        let gained = value(&run, "E", 1.0) - value(&run, "E", 0.0);
        let given = 2.0 * slip * w;
        assert!((gained + value(&run, "D", 1.0) - given).abs() < 1e-10, "{w}: {gained} {given}");
    }
}

/// Thrown onto the belt, with the impulses P and −μ P: P |w_n|/2 and μ P times the mean slip are
/// lost.
#[test]
fn an_impact_takes_what_its_impulses_do_along_the_slip() {
    let belt = Belt { m: 2.0, g: 10.0, k: 0.0, mu: 0.2, mu_s: 0.2, w: 0.5 };
    let thrown = Pose::new("x", 3.0).with("y", 0.1).with("x'", 3.0).with("y'", -3.0);
    let run =
        Simulation::new(&belt).unwrap().start(thrown).unwrap().limit(0.1).tolerance(1e-12).run().unwrap();
    let impact = run.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    let (speed, slip) = (11.0_f64.sqrt(), 2.5);
    let lost = 2.0 * speed * (0.5 * speed + 0.2 * (slip - 0.1 * speed));
    let jump = value(&run, "D", impact.t) - value(&run, "D", impact.t.next_down());
    assert!((jump - lost).abs() < 1e-9, "{jump} {lost}");
}

/// A mass between two dampers and springs with the same ends, pushed, and a bar on a damped hinge.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0))]
#[ground(O = (0, 0))]
#[spring(soft = O -> P, stiffness = k, length = l)]
#[spring(hard = O -> P, damping = c, stiffness = 3 * k, length = l)]
#[spring(dashpot = O -> P, damping = 2 * c)]
#[force(P = (f, 0))]
#[bar(QA, mass = m, length = l)]
#[pin(Q = (0, 2 * l))]
#[torsion(QA, stiffness = k * l * l, angle = pi / 2, damping = c * l * l)]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(phi = angle(QA), from = right)]
struct Damped {
    m: f64,
    l: f64,
    k: f64,
    c: f64,
    f: f64,
}

/// What the load gives, less what is still there; and ∫ c φ̇² dt of the bar alone.
#[test]
fn dampers_take_what_loads_give() {
    let damped = Damped { m: 2.0, l: 1.0, k: 26.0, c: 1.5, f: 5.0 };
    let start = Pose::new("x", 1.3).with("phi", 0.5 * PI + 0.2).with("phi'", 1.0);
    let run =
        Simulation::new(&damped).unwrap().start(start).unwrap().limit(2.0).tolerance(1e-12).run().unwrap();
    for t in [0.01, 0.3, 1.0, 2.0] {
        let change = |output: &str| value(&run, output, t) - value(&run, output, 0.0);
        let (given, kept) = (5.0 * change("x"), change("E"));
        assert!((change("D") - given + kept).abs() < 1e-10, "{t}: {} {given} {kept}", change("D"));
        assert!(change("D") > 1e-3);
    }
}

/// Only what was recorded has it: no condition can, nor a run that is only observed.
#[test]
fn what_was_lost_is_known_of_recorded_motions_only() {
    let belt = Belt { m: 2.0, g: 10.0, k: 0.0, mu: 0.3, mu_s: 0.3, w: 0.0 };
    let simulation = || {
        let start = Pose::new("x", 1.0).with("x'", 1.0);
        Simulation::new(&belt).unwrap().start(start).unwrap().limit(1.0)
    };
    let error = liftoff::Condition::parse(Belt::LAYOUT, "2 * D = 1").unwrap_err();
    assert_eq!(error, OutputError::History { condition: "2 * D = 1".into() });
    assert!(simulation().until("abs(D) > 1").is_err());
    let observed = simulation().observe(&mut ()).unwrap();
    assert!(value(&observed, "D", 1.0).is_nan() && value(&observed, "E", 1.0) < 1e-12);
    assert!((value(&simulation().run().unwrap(), "E + D", 0.4) - 1.0).abs() < 1e-12);
}
