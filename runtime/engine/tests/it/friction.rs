//! Contacts with Coulomb friction against closed forms.

use core::f64::consts::PI;

use liftoff::method::MethodId;
use liftoff::prelude::*;

/// A block on a slope.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = slope(alpha), friction = mu, static = mu_s)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
struct Block {
    m: f64,
    g: f64,
    alpha: f64,
    mu: f64,
    mu_s: f64,
}

/// A mass on a rough floor that a spring pulls at.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k)]
#[support(P = floor, friction = mu)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (1, 0))]
struct Oscillator {
    m: f64,
    g: f64,
    k: f64,
    mu: f64,
}

/// A rod that topples from the upright about its rough foot.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = up)]
#[figure(A = (0, 0), B = (0.1, 1))]
struct Toppling {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
}

fn run(simulation: Simulation) -> Trajectory {
    simulation.run().unwrap_or_else(|error| panic!("{error}"))
}

/// Up a slope with the speed v it stops after v²/2g(sin α + μ cos α), and slides back where tan α > μₛ.
#[test]
fn a_block_slides_up_stops_and_slides_back_or_stays() {
    let (g, v) = (9.81, 2.0);
    for (alpha, mu, mu_s) in [(0.3_f64, 0.2, 0.25), (0.5, 0.2, 0.3), (0.3, 0.4, 0.5)] {
        let block = Block { m: 1.3, g, alpha, mu, mu_s };
        let pose = Pose::at("x", 0.0).with("x'", v * alpha.cos());
        let record = run(Simulation::new(&block).unwrap().start(pose).unwrap().limit(2.0).tolerance(1e-10));
        let deceleration = g * (alpha.sin() + mu * alpha.cos());
        let event = &record.events()[1];
        assert!((event.t - v / deceleration).abs() < 1e-10, "{event}");
        let way = v * v / (2.0 * deceleration);
        assert!((event["x"] - way * alpha.cos()).abs() < 1e-10);
        if alpha.tan() > mu_s {
            assert_eq!(event.kind, EventKind::Reverse);
            let (t, a) = (2.0 - event.t, g * (alpha.sin() - mu * alpha.cos()));
            let end = record.events().last().unwrap();
            assert!((end["x"] - (way - 0.5 * a * t * t) * alpha.cos()).abs() < 1e-9);
        } else {
            assert_eq!(event.kind, EventKind::Stick);
        }
    }
}

/// Eight turning points, each amplitude less by 2μg m/k, rest at 15 − √205 after atan(6/13) + 7π (Leine and Nijmeijer).
#[test]
fn the_friction_oscillator_comes_to_rest() {
    let oscillator = Oscillator { m: 1.0, g: 10.0, k: 1.0, mu: 0.1 };
    let pose = Pose::at("x", 12.0).with("x'", 6.0);
    for method in MethodId::ALL {
        let simulation = Simulation::new(&oscillator).unwrap().start(pose.clone()).unwrap();
        let record = run(simulation.limit(40.0).tolerance(1e-10).method(method));
        let kinds: Vec<EventKind> = record.events().iter().map(|event| event.kind).collect();
        assert_eq!(
            kinds.iter().filter(|kind| **kind == EventKind::Reverse).count(),
            7,
            "{}: {kinds:?}",
            method.name()
        );
        let rest = record.events().iter().find(|event| event.kind == EventKind::Stick).expect("rest");
        assert!((rest.t - (6.0_f64 / 13.0).atan() - 7.0 * PI).abs() < 1e-8, "{}: {rest}", method.name());
        assert!((rest["x"] - 15.0 + 205.0_f64.sqrt()).abs() < 1e-8, "{}: {rest}", method.name());
        assert_eq!(record.events().last().unwrap().kind, EventKind::End);
    }
}

/// Angles at which it slips, computed by other codes.
#[test]
fn a_toppling_rod_slips_at_known_angles() {
    let angles = [
        (0.1, 7.66367746273318),
        (0.2, 15.519254335380932),
        (0.3, 24.165715024631548),
        (0.35, 29.812809570843069),
        (0.4, 51.422928484361589),
        (0.5, 51.977855451506285),
        (1.0, 54.047854471404076),
        (10.0, 62.197657220704101),
    ];
    for (mu, degrees) in angles {
        let rod = Toppling { m: 1.0, l: 1.0, g: 1.0, mu };
        let start = 1e-3_f64;
        let pose = Pose::at("theta", start)
            .with("x'", 0.0)
            .with("theta'", (6.0 * (0.5 * start).sin().powi(2)).sqrt());
        let record = run(Simulation::new(&rod).unwrap().start(pose).unwrap().limit(60.0).tolerance(1e-12));
        let slip = record.events().iter().find(|event| event.kind == EventKind::Slip).expect("a slip");
        assert!((slip["theta"].to_degrees() - degrees).abs() < 1e-6, "{mu}: {slip}");
    }
}
