//! Loads that grow from zero: what hinges do at the start is told by how the forces begin.

use liftoff::prelude::*;

use crate::friction::run;

/// A flywheel that is pressed on its pin and turned ever more.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[point(O = AB, at = l / 2)]
#[pin(O = (0, 0))]
#[pin(O, friction = mu, radius = r)]
#[force(O = (f * t, 0))]
#[couple(AB = c * t)]
#[coordinate(phi = angle(AB), from = right)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
struct Wheel {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    f: f64,
    c: f64,
}

/// J φ̈ = (c ∓ μ r f) t where |c| > μ r f, else rest.
#[test]
fn a_flywheel_turns_from_the_start_or_never() {
    let (m, l, mu, r, f) = (1.0, 1.0, 0.3, 0.1, 1.0);
    let most = mu * r * f;
    for c in [1.0, 0.04, 0.031, 0.029, 0.01, -0.02, -0.029, -0.031, -0.5_f64] {
        let wheel = Wheel { m, l, mu, r, f, c };
        let record = run(Simulation::new(&wheel).unwrap().start(Pose::new("phi", 0.0)).unwrap().limit(2.0));
        let kinds: Vec<EventKind> = record.events().iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [EventKind::Start, EventKind::End], "{c}");
        let couple = (c.abs() - most).max(0.0) * c.signum();
        let turned = couple * 8.0 / 6.0 / (m * l * l / 12.0);
        let phi = record.final_state()[0];
        assert!((phi - turned).abs() < 1e-10 * turned.abs().max(1.0), "{c} {phi} {turned}");
    }
}

/// A slider-crank without weight, turned ever more.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = p, length = k)]
#[pin(O = (0, 0))]
#[slider(B = horizontal(0), friction = mu)]
#[hinge(O, friction = nu, radius = r)]
#[hinge(A, friction = nu, radius = r)]
#[couple(OA = c * t)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (l / 2, sqrt(3) * l / 2), B = (l / 2 + sqrt(k * k - 3 * l * l / 4), 0))]
struct Crank {
    m: f64,
    p: f64,
    l: f64,
    k: f64,
    mu: f64,
    nu: f64,
    r: f64,
    c: f64,
}

/// The work of the couple is ∫ c t dφ = c t φ − c ∫ φ dt.
#[test]
fn a_crank_without_weight_begins_as_its_couple_grows() {
    for c in [1.0, -1.0, 0.1, 7.0] {
        for phi in [-2.5, -0.4, 1.0, 2.0] {
            let crank = Crank { m: 1.0, p: 0.7, l: 0.3, k: 0.8, mu: 0.2, nu: 0.3, r: 0.02, c };
            let start = Pose::new("phi", phi).with("phi'", 0.0);
            let record = run(Simulation::new(&crank).unwrap().start(start).unwrap().limit(1.0));
            let [angle, energy] = ["phi", "E + D"].map(|text| record.function(text).unwrap());
            assert!(c * (angle(1e-3) - phi) > 0.0, "{c} {phi}");
            let count = 2000;
            let weight = |i: i32| if i == 0 || i == count { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            let area: f64 = (0..=count).map(|i| weight(i) * angle(f64::from(i) / f64::from(count))).sum();
            let work = c * (angle(1.0) - area / f64::from(3 * count));
            let gained = energy(1.0) - energy(0.0);
            assert!((gained - work).abs() < 1e-6 * work.abs().max(1.0), "{c} {phi} {gained} {work}");
        }
    }
}
