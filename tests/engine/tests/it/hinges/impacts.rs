//! Impacts of what hinges on a pin with friction.

use liftoff::prelude::*;

use crate::friction::run;

/// A bar on a pin, whose end strikes a wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = mu, radius = r)]
#[support(B = wall(0), facing = right, restitution = e)]
#[coordinate(phi = angle(AB), from = down)]
#[figure(B = (l / 5, -l * sqrt(24) / 5))]
struct Gate {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    e: f64,
    g: f64,
}

/// Upright over the wall's foot, at φ = 0, with ω⁻ < 0 and ω⁺ = −e ω⁻: with Q = −r μ |P| (friction
/// against ω⁺), `J (ω⁺ − ω⁻) = l P_B + Q` and the pin's impulse `P = m (l/2)(ω⁺ − ω⁻) − P_B`, along
/// the wall's normal.
#[test]
fn a_journal_takes_its_share_of_an_impact() {
    let gate = Gate { m: 1.5, l: 0.7, mu: 0.5, r: 0.06, e: 0.6, g: 9.81 };
    let start = Pose::new("phi", 0.8).with("phi'", 0.0);
    let record = run(Simulation::new(&gate).unwrap().start(start).unwrap().limit(0.6));
    let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    let after = impact["phi'"];
    let (change, inertia) = (after + after / gate.e, gate.m * gate.l * gate.l / 3.0);
    let couple = |p: f64| inertia * change - gate.l * p;
    // The pin's impulse for P_B = J Δω/l is −m l Δω/6 + …; it is found by halving.
    let pin = |p: f64| gate.m * 0.5 * gate.l * change - p;
    let excess = |p: f64| couple(p) + gate.r * gate.mu * pin(p).abs();
    let (mut low, mut high) = (0.0, 10.0 * inertia * change / gate.l);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        *if excess(middle) > 0.0 { &mut low } else { &mut high } = middle;
    }
    let impulse = |name: &str| impact.impulses.iter().find(|of| of.label == name).map(|of| of.value);
    assert!((impulse("B").unwrap() - low).abs() < 1e-9 * low, "{impact:?} {low}");
}

/// However fast, and in whatever unit of time: what hinges pass on is of the impulses alone.
#[test]
fn a_gate_bounces_at_any_speed_in_any_unit() {
    for k in 0..60 {
        let unit = 2.0_f64.powi(-k);
        for speed in [1.0, 23.0, 300.0] {
            let gate = Gate { m: 1.5, l: 0.7, mu: 0.6, r: 0.06, e: 0.6, g: 9.81 * unit * unit };
            let start = Pose::new("phi", 0.57).with("phi'", -speed * unit);
            let record =
                run(Simulation::new(&gate).unwrap().start(start).unwrap().limit(0.8 / (speed * unit)));
            let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
            let before = record.function("phi'").unwrap()(impact.t * (1.0 - 1e-12));
            assert!(
                (impact["phi'"] + gate.e * before).abs() < 1e-9 * before.abs(),
                "{k} {speed} {impact} {before}"
            );
        }
    }
}

/// What strikes from outside would have to be known body by body.
#[test]
fn impulses_from_outside_are_refused_beside_hinges() {
    let gate = Gate { m: 1.5, l: 0.7, mu: 0.5, r: 0.06, e: 0.6, g: 9.81 };
    let error = Simulation::new(&gate).unwrap().impulse("B", [1.0, 0.0], 0.1).err().unwrap();
    assert!(matches!(error, liftoff::ScheduleError::HingeFriction), "{error}");
}
