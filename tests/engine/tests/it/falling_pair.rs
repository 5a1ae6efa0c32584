//! Fig. 1a from start to landing, equations written by hand. Reference numbers:
//! `models/data/references.json`.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_fixtures::FallingPair;

const LIFT_OFF: f64 = 0.8149116630275752;

fn unit() -> FallingPair {
    FallingPair { m: 1.0, l: 1.0, g: 1.0 }
}

fn fall(form: Form, tolerance: f64) -> Trajectory {
    Simulation::new(&FallingPair { m: 1.0, l: 1.0, g: 9.81 })
        .unwrap()
        .tolerance(tolerance)
        .form(form)
        .start(Pose::new("phi", 0.1))
        .unwrap()
        .on_energy_of(Pose::new("phi", 0.0))
        .unwrap()
        .until("phi = pi/2")
        .unwrap()
        .run()
        .unwrap()
}

#[test]
fn lifts_off_on_the_limiting_energy_level() {
    for (form, tolerance, close) in
        [(Form::Reduced, 1e-12, 1e-10), (Form::Reduced, 1e-14, 1e-12), (Form::Multipliers, 1e-12, 1e-10)]
    {
        let run = fall(form, tolerance);
        let [start, open, stop] = run.events() else { panic!("{:?}", run.events()) };
        assert_eq!([start.kind, open.kind, stop.kind], [EventKind::Start, EventKind::Open, EventKind::Stop]);
        assert_eq!(open.supports, ["P", "Q"]);
        let alpha = run.value(&Output::parse(FallingPair::LAYOUT, "phi''").unwrap(), open.t);
        println!("{form:?} {tolerance:e} {:?}", run.statistics());
        let time = (1.0f64 / 9.81).sqrt();
        for (name, computed, reference) in [
            ("phi", open.state[0], LIFT_OFF),
            ("omega", open.state[2], 2.110611706382307),
            ("alpha", alpha, -2.5769416429961285),
            ("flight", (stop.t - open.t) / time, 1.2999565994264501),
            ("landing", stop.state[2] * time, 0.542084529149169),
        ] {
            let error = (computed / reference - 1.0).abs();
            println!("  {name} {computed} {error:e}");
            assert!(error < close, "{form:?} {tolerance:e} {name}: {computed} for {reference}");
        }
    }
}

#[test]
fn starts_from_rest() {
    // The times grow as 1/√φ₀, and with them the accumulated error.
    for (start, phi, t, close) in [
        (0.1, 0.815453099591302, 2.5976375675578, 1e-11),
        (1e-2, 0.814912203729558, 9.377697720538645, 1e-11),
        (1e-4, 0.814911663028116, 98.6120609142667, 1e-10),
    ] {
        let run = Simulation::new(&unit()).unwrap().start(Pose::new("phi", start)).unwrap();
        let run = run.until("gap(P) > 0.01").unwrap().run().unwrap();
        let open = &run.events()[1];
        println!("{start} {} {} {:?}", open.state[0] - phi, open.t - t, run.statistics());
        assert_eq!(open.kind, EventKind::Open);
        assert!((open.state[0] - phi).abs() < 1e-12 && (open.t / t - 1.0).abs() < close, "{open}");
        assert_eq!(run.events()[2].kind, EventKind::Stop);
    }
}

#[test]
fn degenerate_equilibrium_is_said() {
    let error = Simulation::new(&unit()).unwrap().run().unwrap_err();
    assert_eq!(*error.cause(), liftoff::RunCause::Start(liftoff::StartError::Equilibrium));
    // φ₀ = 1e-12 does move, after a million natural times.
    let run =
        Simulation::new(&unit()).unwrap().start(Pose::new("phi", 1e-12)).unwrap().limit(10.0).run().unwrap();
    assert_eq!(run.events().last().unwrap().kind, EventKind::End);
}

#[test]
fn forms_agree_through_the_lift_off() {
    let [closed, projected] = [Form::Reduced, Form::Multipliers].map(|form| fall(form, 1e-13));
    let end = closed.end_time();
    for k in 0..=20 {
        let t = end * f64::from(k) / 20.0;
        for (a, b) in closed.state(t).iter().zip(projected.state(t)) {
            assert!((a - b).abs() < 1e-11, "{t}: {a} {b}");
        }
    }
}

#[test]
fn held_corners_pull() {
    let run = Simulation::new(&unit()).unwrap().start(Pose::new("phi", 0.1)).unwrap();
    let run = run.hold("Q").unwrap().until("phi = 1").unwrap().run().unwrap();
    assert_eq!(run.events().len(), 2);
    let reaction = Output::parse(FallingPair::LAYOUT, "N(Q)").unwrap();
    let share = run.value(&reaction, run.end_time());
    assert!(share < -0.1);
    let told = &run.events()[1].reactions;
    assert!(told.iter().all(|r| (r.value - share).abs() < 1e-14) && told.len() == 2, "{told:?}");
    let energy = Output::parse(FallingPair::LAYOUT, "E").unwrap();
    let drift = run.value(&energy, run.end_time()) - run.value(&energy, 0.0);
    assert!(drift.abs() < 1e-11, "{drift:e}");
}

#[test]
fn slides_off_its_bar() {
    let run = Simulation::new(&unit()).unwrap().start(Pose::new("phi", 0.1)).unwrap();
    let run = run.hold("P").unwrap().until("phi = 7 * pi / 16").unwrap().run().unwrap();
    let [_, off, stop] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!((off.kind, &off.supports[..]), (EventKind::SlideOff, &["P", "Q"][..]));
    // The foot is at (l/2)/cos φ from D.
    assert!((off.state[0] - FRAC_PI_3).abs() < 1e-11);
    // The motion goes on free of the corners: its first integral is the paper's (3.8).
    assert_eq!((stop.kind, off.reactions[0].value), (EventKind::Stop, 0.0));
    let integral = |state: &[f64]| state[2].powi(2) * (2.0 / 3.0 - 0.5 * state[0].cos().powi(2));
    assert!((integral(&stop.state) / integral(&off.state) - 1.0).abs() < 1e-11);
}

/// Where a foot is at the end of its bar the gap is zero, and opens by rounding alone in some of
/// these runs: that is no bounce.
#[test]
fn a_foot_that_has_slid_off_does_not_settle() {
    for rate in 1..=60 {
        let start = Pose::new("phi", 0.0).with("phi'", -10.0 * f64::from(rate));
        let run = Simulation::new(&unit()).unwrap().tolerance(1e-11).start(start).unwrap();
        let run = run.method(MethodId::Dop853).limit(1.0).run().unwrap();
        let kinds: Vec<EventKind> = run.events().iter().map(|event| event.kind).collect();
        let off = kinds.iter().filter(|kind| **kind == EventKind::SlideOff).count();
        assert!(off == 1 && !kinds.contains(&EventKind::Settle), "{rate}: {kinds:?}");
    }
}

#[test]
fn free_start_closes() {
    let run = Simulation::new(&unit()).unwrap().start(Pose::new("phi", 0.3).with("y", 0.2)).unwrap();
    let run = run.stop_at_impacts().run().unwrap();
    let last = run.events().last().unwrap();
    assert_eq!(last.kind, EventKind::Close);
    let gap = Output::parse(FallingPair::LAYOUT, "gap(P)").unwrap();
    assert!(run.value(&gap, last.t).abs() < 1e-14);
    assert!(last.state[0] < FRAC_PI_2);
}
