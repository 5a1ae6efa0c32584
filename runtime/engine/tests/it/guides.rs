//! Guides with Coulomb friction against closed forms.

use liftoff::prelude::*;

use crate::friction::run;

/// A bead on a straight wire, with a force across it that changes its sign.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0), friction = mu)]
#[force(P = (0, c * t - d))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
struct Bead {
    m: f64,
    mu: f64,
    c: f64,
    d: f64,
}

/// N = d − c t, so that m v̇ = −μ |d − c t|: the side changes at d/c, and the bead stops where μ ∫ |N| dt = m v₀.
#[test]
fn a_bead_slows_on_both_sides_of_its_wire() {
    let Bead { m, mu, c, d } = Bead { m: 1.3, mu: 0.3, c: 2.0, d: 1.5 };
    let (v, half) = (1.0, d * d / (2.0 * c));
    let start = Pose::at("x", 0.0).with("x'", v);
    let record = run(Simulation::new(&Bead { m, mu, c, d }).unwrap().start(start).unwrap().limit(4.0));
    let kinds: Vec<EventKind> = record.events().iter().map(|event| event.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Side, EventKind::Stick, EventKind::End]);
    let [side, stick] = [1, 2].map(|k| &record.events()[k]);
    assert!((side.t - d / c).abs() < 1e-10, "{side}");
    assert!((side["x'"] - (v - mu * half / m)).abs() < 1e-10);
    let stop = (d + (2.0 * c * (m * v / mu - half)).sqrt()) / c;
    assert!((stick.t - stop).abs() < 1e-10, "{stick} {stop}");
    let normal = record.function("N(P)").unwrap();
    for t in [0.1, 0.5, 1.0, 2.0, 3.0] {
        assert!((normal(t) - (d - c * t)).abs() < 1e-10);
    }
    let lost = record.function("T + D").unwrap();
    assert!((lost(4.0) - 0.5 * m * v * v).abs() < 1e-10);
}
