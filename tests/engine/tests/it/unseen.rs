//! Loads and drives that a step may pass over without a value of them, or with none that says
//! anything.

use core::f64::consts::PI;

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff::{LoggedDecision, RunCause};

macro_rules! pushed {
    ($name:ident, $force:expr) => {
        #[derive(BarSystem)]
        #[liftoff(dimensionless)]
        #[particle(P, mass = 1)]
        #[slider(P = horizontal(0))]
        #[force(P = ($force, 0))]
        #[coordinate(x = x(P))]
        #[figure(P = (0, 0))]
        struct $name {
            w: f64,
        }
    };
}

pushed!(Blow, w / (1 + (w * (t - 2)).powi(8)));
pushed!(Barrier, -w / (1 + (w * (x - 2)).powi(8)));
pushed!(Comb, w * sin(t).powi(32));
pushed!(Rooted, w / ((1 + (w * (t - 2)).powi(2)) * sqrt(1 + (w * (t - 2)).powi(2))));

/// ∫ du/(1 + u⁸) over all u.
fn impulse() -> f64 {
    PI / 4.0 / (PI / 8.0).sin()
}

fn rate<M: BarSystem>(model: &M, start: f64, limit: f64, method: MethodId) -> f64 {
    let simulation = Simulation::new(model).unwrap().tolerance(1e-9).method(method);
    let run = simulation.start(Pose::new("x", 0.0).with("x'", start)).unwrap().limit(limit).run().unwrap();
    run.value(&run.output("x'").unwrap(), limit)
}

/// Gauss's constant steps are as short as the blow, to the end of the run.
fn is_patient(method: MethodId, w: f64) -> bool {
    method != MethodId::Gauss || w <= 1e4
}

#[test]
fn a_blow_is_seen_however_short() {
    for method in MethodId::ALL {
        for w in [10.0, 1e3, 1e4, 1e6].into_iter().filter(|w| is_patient(method, *w)) {
            // The tails outside of the run are (7/w⁷)(1/1.3⁷ + 1/2⁷) at most.
            let found = rate(&Blow { w }, 0.0, 3.3, method);
            assert!((found - impulse()).abs() < 3e-7, "{} at {w}: {found}", method.name());
        }
    }
}

/// Its roots have no kinks: ∫ du/(1 + u²)^(3/2) = u/√(1 + u²).
#[test]
fn a_blow_with_a_root_is_seen() {
    for method in MethodId::ALL {
        for w in [10.0, 1e3, 1e4].into_iter().filter(|w| is_patient(method, *w)) {
            let part = |u: f64| u / (1.0 + u * u).sqrt();
            let (found, expected) = (rate(&Rooted { w }, 0.0, 3.3, method), part(1.3 * w) - part(-2.0 * w));
            assert!((found - expected).abs() < 1e-6, "{} at {w}: {found}, not {expected}", method.name());
        }
    }
}

#[test]
fn a_barrier_slows_what_passes_it() {
    let after = (2.5_f64.powi(2) - 2.0 * impulse()).sqrt();
    for method in MethodId::ALL {
        for w in [100.0, 1e3, 1e4].into_iter().filter(|w| is_patient(method, *w)) {
            let found = rate(&Barrier { w }, 2.5, 3.0, method);
            assert!((found - after).abs() < 1e-6, "{} at {w}: {found}", method.name());
        }
    }
}

/// ∫ sin³²t dt over a period of π is π (31!!/32!!).
#[test]
fn a_force_whose_first_31_derivatives_vanish_acts() {
    let period: f64 = (1..=16).map(|k| f64::from(2 * k - 1) / f64::from(2 * k)).product::<f64>() * PI;
    for method in MethodId::ALL {
        let found = rate(&Comb { w: 1.0 }, 0.0, 10.0 * PI, method);
        assert!((found - 10.0 * period).abs() < 1e-6, "{}: {found}", method.name());
    }
}

macro_rules! driven {
    ($name:ident, $value:expr) => {
        #[derive(BarSystem)]
        #[liftoff(dimensionless)]
        #[particle(P, mass = 2)]
        #[slider(P = horizontal(0))]
        #[drive(x = $value)]
        #[coordinate(x = x(P))]
        #[figure(P = (1, 0))]
        struct $name {
            at: f64,
        }
    };
}

driven!(Jumping, (t - at) / sqrt((t - at) * (t - at)));
driven!(Kinked, sqrt((t - at) * (t - at)));
driven!(Pole, 1 / (t - at));
driven!(Tangent, tan(t / at));
driven!(Smooth, sqrt((t - at) * (t - at) + at / 100) * sin(t) / (2 + cos(t)));

#[track_caller]
fn breaks<M: BarSystem>(model: &M, time: f64, expected: &str) {
    for method in MethodId::ALL {
        let error = Simulation::new(model).unwrap().method(method).limit(3.0).run().unwrap_err();
        let RunCause::Drive { t, what, .. } = error.cause() else { panic!("{}: {error}", method.name()) };
        assert!((t - time).abs() < 1e-6 && *what == expected, "{}: {error}", method.name());
        // The motion so far.
        assert!((error.trajectory().interval()[1] - time).abs() < 1e-5, "{}: {error}", method.name());
    }
}

#[test]
fn a_drive_that_breaks_is_refused_by_name() {
    for at in [1.0, 1.7] {
        breaks(&Jumping { at }, at, "jumps");
        breaks(&Kinked { at }, at, "has a kink");
        breaks(&Pole { at }, at, "has a pole");
        breaks(&Tangent { at }, at * PI / 2.0, "has a pole");
    }
}

/// A disc that is driven, at rest before its kink, and one that it touches.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[particle(P, mass = 1)]
#[particle(Q, mass = 1)]
#[slider(P = horizontal(0))]
#[slider(Q = horizontal(0))]
#[disc(P, radius = 0.5)]
#[disc(Q, radius = 0.5)]
#[support(P = disc(Q), restitution = 0.5)]
#[drive(x(P) = sqrt((t - at) * (t - at)) + t)]
#[coordinate(x = x(Q))]
#[figure(P = (1, 0), Q = (2.5, 0))]
struct Pushing {
    at: f64,
}

#[test]
fn a_kink_of_a_drive_that_pushes_is_refused_by_name() {
    for method in MethodId::ALL {
        let run = Simulation::new(&Pushing { at: 1.0 }).unwrap().method(method).start(Pose::new("x", 2.0));
        let error = run.unwrap().limit(3.0).run().unwrap_err();
        let RunCause::Drive { t, what, .. } = error.cause() else { panic!("{}: {error}", method.name()) };
        assert!((t - 1.0).abs() < 1e-6 && *what == "has a kink", "{}: {error}", method.name());
    }
}

/// A root of what comes near zero, a quotient.
#[test]
fn a_drive_that_only_looks_broken_runs() {
    for method in MethodId::ALL {
        let run = Simulation::new(&Smooth { at: 1.0 }).unwrap().method(method).limit(3.0).run();
        let run = run.unwrap_or_else(|error| panic!("{}: {error}", method.name()));
        assert!(run.log().iter().all(|entry| entry.decision != LoggedDecision::LoadUnresolved));
    }
}

#[allow(clippy::duplicated_attributes, reason = "two bars may be as heavy as each other")]
/// A parallelogram whose bars all lie on one line as it passes φ = 0, where one step goes across: a
/// blow falls within it.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(g)]
#[pin(O = (0, 0))]
#[pin(C = (2, 0))]
#[bar(OA, mass = 1, length = 1)]
#[bar(AB, mass = 1, length = 2)]
#[bar(CB, mass = 1, length = 1)]
#[force(A = (0, -a / (1 + (10000 * (t - b)).powi(8))))]
#[coordinate(phi = angle(OA))]
#[coordinate(psi = angle(CB))]
#[coordinate(th = angle(AB))]
#[figure(O = (0, 0), A = (0, -1), B = (2, -1), C = (2, 0))]
struct Parallelogram {
    g: f64,
    a: f64,
    b: f64,
}

#[test]
fn a_blow_within_the_step_across_a_singular_position_is_reported() {
    let told = |b: f64| {
        let start = Pose::new("phi", -PI / 2.0).with("phi'", 2.2);
        let run = Simulation::new(&Parallelogram { g: 1.0, a: 2000.0, b }).unwrap();
        let run = run.start(start).unwrap().limit(1.4).run().unwrap();
        run.log().iter().any(|entry| entry.decision == LoggedDecision::LoadUnresolved)
    };
    // It passes at t = 0.8032514516; a blow before is seen.
    assert!(told(0.803_251_451_6) && !told(0.5));
}
