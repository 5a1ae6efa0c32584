//! Loops whose hinges have friction, and hinges beside supports with friction.

use liftoff::LoggedDecision;
use liftoff::prelude::*;

use crate::friction::run;

/// A crank, a coupler and a rocker, friction at all four hinges.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = sqrt(10) * l)]
#[bar(QB, mass = m, length = 2 * l)]
#[pin(O = (0, 0))]
#[pin(Q = (3 * l, 0))]
#[hinge(O, friction = mu, radius = r)]
#[hinge(A, friction = mu, radius = r)]
#[hinge(B, friction = mu, radius = r)]
#[hinge(Q, friction = mu, radius = r)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0, l), B = (3 * l, 2 * l))]
struct FourBar {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    g: f64,
}

/// It comes to rest, all hinges sticking, with what it had taken by friction.
#[test]
fn a_linkage_comes_to_rest() {
    let linkage = FourBar { m: 0.8, l: 0.3, mu: 0.3, r: 0.02, g: 9.81 };
    let start = Pose::new("phi", 1.4).with("phi'", 15.0);
    let record = run(Simulation::new(&linkage).unwrap().start(start).unwrap().limit(30.0));
    let energy = record.function("E + D").unwrap();
    for k in 0..=30 {
        let t = f64::from(k);
        assert!((energy(t) - energy(0.0)).abs() < 1e-8, "{t} {}", energy(t) - energy(0.0));
    }
    let rate = record.function("phi'").unwrap();
    assert!(rate(30.0).abs() < 1e-9, "{}", rate(30.0));
    assert!(record.events().iter().any(|event| event.kind == EventKind::Reverse));
    assert_eq!(record.events().iter().rev().nth(1).unwrap().kind, EventKind::Stick);
}

/// Two bars, hinged with friction, on a floor with friction.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = p, length = l)]
#[hinge(B, friction = mu, radius = r)]
#[support(A = floor, friction = nu)]
#[support(C = floor, friction = nu)]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(psi = angle(BC), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[figure(A = (-3 * l / 5, 0), B = (0, 4 * l / 5), C = (3 * l / 5, 0))]
struct Trestle {
    m: f64,
    p: f64,
    l: f64,
    mu: f64,
    nu: f64,
    r: f64,
    g: f64,
}

/// The legs spread where friction of the feet and of the hinge do not hold them: with equal legs at
/// the angle α to the floor they bear m g each, the feet slide at ν m g, and the hinge's couple is
/// r μ H, H the force between the legs, horizontal and larger than that of the floor.
#[test]
fn a_trestle_stands_or_spreads() {
    let trestle = Trestle { m: 1.0, p: 1.0, l: 1.0, mu: 0.4, nu: 0.3, r: 0.1, g: 9.81 };
    // About B: m g (l/2) cos α − m g l cos α + H l sin α + r μ H = 0 at the limit, with H = ν m g
    // of the floor.
    let holds = |alpha: f64| {
        let needed = 0.5 * alpha.cos() - trestle.nu * alpha.sin();
        needed <= trestle.mu * trestle.r * trestle.nu
    };
    for alpha in [0.5, 0.9, 0.95, 1.0, 1.02, 1.04, 1.1, 1.3_f64] {
        let start = Pose::new("phi", alpha).with("psi", -alpha).with("x", 0.0).with("y", 0.0);
        let start = start.with("phi'", 0.0).with("psi'", 0.0).with("x'", 0.0).with("y'", 0.0);
        let record = Simulation::new(&trestle).unwrap().start(start).unwrap().limit(0.02).run().unwrap();
        let rests = record.log().iter().any(|entry| entry.decision == LoggedDecision::StartRests);
        let moved = record.function("phi'").unwrap()(0.02);
        assert_eq!((rests, rests), (holds(alpha), moved >= 0.0), "{alpha} {moved}");
        let energy = record.function("E + D").unwrap();
        assert!((energy(0.02) - energy(0.0)).abs() < 1e-10);
    }
}

/// At random rates there is a motion, with friction of supports and of the hinge at once, impacts
/// among it.
#[test]
fn a_thrown_trestle_has_a_motion() {
    let trestle = Trestle { m: 1.0, p: 0.7, l: 1.0, mu: 0.4, nu: 0.3, r: 0.05, g: 9.81 };
    for (u, w, lift) in [(2.0, -1.0, 0.2), (-3.0, 2.0, 0.1), (0.0, 4.0, 0.3), (5.0, 5.0, 0.05)] {
        let start = Pose::new("phi", 1.0).with("psi", -0.9).with("x", 0.0).with("y", 0.3 + lift);
        let start = start.with("phi'", u).with("psi'", w).with("x'", 0.5).with("y'", -1.0);
        let made = Simulation::new(&trestle).unwrap().start(start).unwrap().limit(0.4).run();
        let record = made.unwrap_or_else(|error| panic!("{u} {w}: {error}"));
        let energy = record.function("E + D").unwrap();
        for t in [0.1, 0.2, 0.3, 0.4] {
            assert!((energy(t) - energy(0.0)).abs() < 1e-8, "{u} {w} {t} {}", energy(t) - energy(0.0));
        }
        assert!(record.events().iter().any(|event| event.kind == EventKind::Impact));
    }
}
