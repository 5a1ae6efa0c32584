//! One bar on a pin with friction.

use liftoff::prelude::*;

use crate::friction::run;

/// A bar that hangs from a pin.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = mu, static = mu_s, radius = r)]
#[coordinate(phi = angle(AB), from = down)]
#[figure(B = (l / 5, -l * sqrt(24) / 5))]
struct Pendulum {
    m: f64,
    l: f64,
    mu: f64,
    mu_s: f64,
    r: f64,
    g: f64,
}

const BAR: Pendulum = Pendulum { m: 1.3, l: 0.8, mu: 0.4, mu_s: 0.5, r: 0.05, g: 9.81 };

/// φ̈ while it turns with the sense σ, and |F|: `J φ̈ = −m g (l/2) sin φ − σ μ r |F|` with
/// `|F|² = (m (l/2) φ̈ + m g sin φ)² + (m (l/2) φ̇² + m g cos φ)²`, a quadratic in |F|.
fn turning(bar: &Pendulum, [phi, rate]: [f64; 2], sense: f64) -> [f64; 2] {
    let Pendulum { m, l, mu, r, g, .. } = *bar;
    let (half, inertia) = (0.5 * l, m * l * l / 3.0);
    let free = -m * g * half * phi.sin() / inertia;
    let per_force = -sense * mu * r / inertia;
    let (across, slope) = (m * half * free + m * g * phi.sin(), m * half * per_force);
    let along = m * half * rate * rate + m * g * phi.cos();
    // s² (1 − slope²) − 2 across slope s − across² − along² = 0
    let (a, b, c) = (1.0 - slope * slope, across * slope, across * across + along * along);
    let force = (b + (b * b + a * c).sqrt()) / a;
    [free + per_force * force, force]
}

/// One step of the classical method of order 4.
fn step(bar: &Pendulum, y: [f64; 2], sense: f64, h: f64) -> [f64; 2] {
    let f = |y: [f64; 2]| [y[1], turning(bar, y, sense)[0]];
    let along = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
    let k1 = f(y);
    let k2 = f(along(k1, 0.5 * h));
    let k3 = f(along(k2, 0.5 * h));
    let k4 = f(along(k3, h));
    core::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

/// The times and angles at which it stands still, up to the one at which it sticks.
fn stops(bar: &Pendulum, phi: f64) -> Vec<[f64; 2]> {
    let (h, mut t, mut y, mut stops) = (1e-4, 0.0, [phi, 0.0], Vec::new());
    // It moves where the couple of its weight is beyond that of friction at rest, where |F| = m g.
    let moves = |phi: f64| 0.5 * bar.l * phi.sin().abs() > bar.mu_s * bar.r;
    while moves(y[0]) {
        let sense = -y[0].signum();
        loop {
            let next = step(bar, y, sense, h);
            if next[1] * sense < 0.0 {
                break;
            }
            (t, y) = (t + h, next);
        }
        let mut part = 0.0;
        for _ in 0..20 {
            let [_, rate] = step(bar, y, sense, part);
            part -= rate / turning(bar, step(bar, y, sense, part), sense)[0];
        }
        (t, y) = (t + part, [step(bar, y, sense, part)[0], 0.0]);
        stops.push([t, y[0]]);
    }
    stops
}

/// It swings ever less, turns back at once where it stands still, and sticks in the band of its
/// friction.
#[test]
fn a_pendulum_comes_to_rest_on_its_pin() {
    let expected = stops(&BAR, 1.0);
    assert!(expected.len() > 4, "{expected:?}");
    let record = run(Simulation::new(&BAR).unwrap().start(Pose::new("phi", 1.0)).unwrap().limit(8.0));
    let turned = |event: &&Event| matches!(event.kind, EventKind::Reverse | EventKind::Stick);
    let found: Vec<&Event> = record.events().iter().filter(turned).collect();
    assert_eq!(found.len(), expected.len(), "{:?}", record.events());
    for (event, [t, phi]) in found.iter().zip(&expected) {
        assert!((event.t - t).abs() < 1e-9 && (event["phi"] - phi).abs() < 1e-9, "{event} {t} {phi}");
    }
    let kinds: Vec<EventKind> = found.iter().map(|event| event.kind).collect();
    let (last, others) = kinds.split_last().unwrap();
    assert!(*last == EventKind::Stick && others.iter().all(|kind| *kind == EventKind::Reverse), "{kinds:?}");
    let end = found[found.len() - 1].t;
    let value = |text: &str, t: f64| record.function(text).unwrap()(t);
    // At rest R holds the weight's couple.
    let held = BAR.m * BAR.g * 0.5 * BAR.l * value("phi", 8.0).sin() / BAR.r;
    assert!((value("R(A)", 8.0) - held).abs() < 1e-9 && (value("N(A)", 8.0) - BAR.m * BAR.g).abs() < 1e-9);
    assert!((value("phi", 8.0) - value("phi", end)).abs() < 1e-12);
    let energy = record.function("E + D").unwrap();
    for k in 0..=40 {
        let t = 0.2 * f64::from(k);
        assert!((energy(t) - energy(0.0)).abs() < 1e-9, "{t} {}", energy(t) - energy(0.0));
    }
}

/// Forces and accelerations are those of the quadratic, at states of either sense.
#[test]
fn friction_of_a_pin_follows_the_length_of_its_force() {
    for (phi, rate) in [(0.3, 2.0), (-1.0, 5.0), (2.5, -3.0), (-2.0, -0.1), (0.0, 8.0)] {
        let start = Pose::new("phi", phi).with("phi'", rate);
        let record = run(Simulation::new(&BAR).unwrap().start(start).unwrap().limit(1e-3));
        let value = |text: &str| record.function(text).unwrap()(0.0);
        let [acceleration, force] = turning(&BAR, [phi, rate], rate.signum());
        assert!((value("phi''") - acceleration).abs() < 1e-11 * acceleration.abs().max(1.0));
        assert!((value("N(A)") - force).abs() < 1e-11 * force);
        assert!((value("R(A)") + rate.signum() * BAR.mu * force).abs() < 1e-11 * force);
        assert!((value("v(A)") - BAR.r * rate).abs() < 1e-14 && value("mu(A)") == BAR.mu);
        assert!((value("ratio(A)") + rate.signum() * BAR.mu).abs() < 1e-11);
        let force_of_pin = value("fx(A, AB)").hypot(value("fy(A, AB)"));
        assert!((force_of_pin - force).abs() < 1e-11 * force);
    }
}

/// It starts to move where the couple of its weight is beyond its static friction, and not before.
#[test]
fn a_pendulum_rests_within_its_band() {
    let band = (2.0 * BAR.mu_s * BAR.r / BAR.l).asin();
    for (phi, moves) in [(0.999 * band, false), (1.001 * band, true)] {
        let run = Simulation::new(&BAR).unwrap().start(Pose::new("phi", phi)).unwrap().limit(0.1).run();
        match moves {
            // With the smaller friction of what slides it could move as well.
            false => assert!(run.unwrap().function("phi'").unwrap()(0.1) == 0.0),
            true => {
                let rate = run.unwrap().function("phi'").unwrap()(0.1);
                assert!(rate < 0.0, "{rate}");
            }
        }
    }
}

/// A flywheel pressed on its pin.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[point(O = AB, at = l / 2)]
#[pin(O = (0, 0))]
#[pin(O, friction = mu, radius = r)]
#[force(O = (f, 0))]
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

/// J φ̈ = −μ r f: it stops after J ω/(μ r f), and stays.
#[test]
fn a_pressed_wheel_slows_steadily() {
    let wheel = Wheel { m: 2.0, l: 0.6, mu: 0.2, r: 0.03, f: 40.0, c: 0.0 };
    let (omega, inertia) = (3.0, wheel.m * wheel.l * wheel.l / 12.0);
    let start = Pose::new("phi", 0.0).with("phi'", omega);
    let record = run(Simulation::new(&wheel).unwrap().start(start).unwrap().limit(2.0));
    let slowing = wheel.mu * wheel.r * wheel.f / inertia;
    let stick = record.events().iter().find(|event| event.kind == EventKind::Stick).unwrap();
    assert!((stick.t - omega / slowing).abs() < 1e-10, "{stick}");
    assert!((stick["phi"] - 0.5 * omega * omega / slowing).abs() < 1e-10);
    assert!((record.function("D").unwrap()(2.0) - 0.5 * inertia * omega * omega).abs() < 1e-10);
}

/// From rest it slips when the couple c t reaches μ r f, then turns with φ̈ = (c t − μ r f)/J.
#[test]
fn a_growing_couple_breaks_a_hinge_loose() {
    let wheel = Wheel { m: 2.0, l: 0.6, mu: 0.2, r: 0.03, f: 40.0, c: 0.5 };
    let inertia = wheel.m * wheel.l * wheel.l / 12.0;
    let record = run(Simulation::new(&wheel).unwrap().start(Pose::new("phi", 0.0)).unwrap().limit(1.5));
    let slip = record.events().iter().find(|event| event.kind == EventKind::Slip).unwrap();
    let loose = wheel.mu * wheel.r * wheel.f / wheel.c;
    assert!((slip.t - loose).abs() < 1e-10, "{slip} {loose}");
    let rate = wheel.c * (1.5 - loose).powi(2) / (2.0 * inertia);
    assert!((record.function("phi'").unwrap()(1.5) - rate).abs() < 1e-9, "{rate}");
}

/// A journal so large that its couple turns back on its own force leaves no motion, or several: it
/// is named.
#[test]
fn a_journal_too_large_is_refused() {
    let bar = Pendulum { r: 2.0, mu: 1.0, mu_s: 1.0, ..BAR };
    let start = Pose::new("phi", 1.0).with("phi'", 1.0);
    let error = Simulation::new(&bar).unwrap().start(start).unwrap().limit(1.0).run().unwrap_err();
    assert!(error.to_string().contains("friction at A"), "{error}");
    let none = Pendulum { r: 0.0, ..BAR };
    let error = Simulation::new(&none).err().map(|error| error.to_string()).unwrap();
    assert!(error.contains("radius of hinge A"), "{error}");
    let negative = Pendulum { mu: -0.1, ..BAR };
    assert!(Simulation::new(&negative).is_err());
    assert!(Simulation::new(&Pendulum { mu_s: 0.3, ..BAR }).is_err());
}
