//! Beads on wires, bars and hoops, and starts beside a guide.

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

/// N = d − c t, so that m v̇ = −μ |d − c t|: the side changes at d/c, and the bead stops where μ ∫
/// |N| dt = m v₀.
#[test]
fn a_bead_slows_on_both_sides_of_its_wire() {
    let Bead { m, mu, c, d } = Bead { m: 1.3, mu: 0.3, c: 2.0, d: 1.5 };
    let (v, half) = (1.0, d * d / (2.0 * c));
    let start = Pose::new("x", 0.0).with("x'", v);
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

/// A bead on a bar that turns steadily, without gravity.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[particle(P, mass = m)]
#[slider(P = bar(OA), friction = mu)]
#[drive(phi = omega * t)]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(A = (l, 0), P = (l / 4, 0))]
struct Turning {
    m: f64,
    l: f64,
    mu: f64,
    omega: f64,
}

/// N = 2 m ω ṙ and r̈ = ω² r − 2 μ ω |ṙ|: outwards r̈ + 2 μ ω ṙ − ω² r = 0.
#[test]
fn a_bead_is_flung_along_a_turning_bar() {
    let (mu, omega, r) = (0.4_f64, 1.5, 0.25);
    let model = Turning { m: 1.0, l: 1.0, mu, omega };
    let start = Pose::new("x", r).with("y", 0.0).with("x'", 0.0);
    let record = run(Simulation::new(&model).unwrap().start(start).unwrap().limit(1.2));
    let root = (1.0 + mu * mu).sqrt();
    let [fast, slow] = [omega * (root - mu), -omega * (root + mu)];
    let at = |t: f64| r * (fast * (slow * t).exp() - slow * (fast * t).exp()) / (fast - slow);
    let rate = |t: f64| r * fast * slow * ((slow * t).exp() - (fast * t).exp()) / (fast - slow);
    let [x, y, normal] = ["x", "y", "N(P)"].map(|text| record.function(text).unwrap());
    for t in [0.2, 0.6, 1.0, 1.2] {
        assert!((x(t).hypot(y(t)) - at(t)).abs() < 1e-10, "{t} {} {}", x(t).hypot(y(t)), at(t));
        assert!((normal(t) - 2.0 * omega * rate(t)).abs() < 1e-9, "{t} {}", normal(t));
    }
}

/// Poses off a guide and rates across it are refused, by its name.
#[test]
fn starts_beside_a_guide_are_refused() {
    let bead = Bead { m: 1.0, mu: 0.3, c: 1.0, d: 1.0 };
    let refused =
        |pose: Pose| Simulation::new(&bead).unwrap().start(pose).err().map(|error| error.to_string());
    let off = refused(Pose::new("x", 0.0).with("y", 0.1)).unwrap();
    assert!(off.contains("slider P"), "{off}");
    let across = refused(Pose::new("x", 0.0).with("y'", 0.1)).unwrap();
    assert!(across.contains("slider P"), "{across}");
    assert_eq!(refused(Pose::new("x", 0.0).with("x'", 0.1)), None);
}

/// A guide that is taken away lets go.
#[test]
fn a_released_guide_lets_go() {
    let bead = Bead { m: 1.0, mu: 0.3, c: 0.0, d: 2.0 };
    let start = Pose::new("x", 0.0).with("x'", 1.0);
    let simulation = Simulation::new(&bead).unwrap().start(start).unwrap().limit(1.0);
    let record = run(simulation.release("P", 0.5).unwrap());
    let [x, y] = ["x'", "y"].map(|text| record.function(text).unwrap()(1.0));
    assert!((x - (1.0 - 0.3 * 2.0 * 0.5)).abs() < 1e-10 && (y + 2.0 * 0.125).abs() < 1e-10, "{x} {y}");
}

/// A bead in a hoop.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = circle((0, 0), r), friction = mu)]
#[figure(P = (0, -r))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Hoop {
    m: f64,
    r: f64,
    mu: f64,
}

/// v̇ = −μ v²/r: v = v₀/(1 + μ v₀ t/r).
#[test]
fn a_bead_slows_in_a_hoop() {
    let (m, r, mu, v) = (0.7, 0.5, 0.3, 3.0);
    for v in [v, -v] {
        let start = Pose::new("x", 0.0).with("y", -r).with("x'", v);
        let record = run(Simulation::new(&Hoop { m, r, mu }).unwrap().start(start).unwrap().limit(3.0));
        assert_eq!(record.events().len(), 2, "{:?}", record.events());
        let [slip, normal, friction] = ["v(P)", "N(P)", "R(P)"].map(|text| record.function(text).unwrap());
        for t in [0.5_f64, 1.0, 2.9] {
            let speed = v / (1.0 + mu * v.abs() * t / r);
            assert!((slip(t) - speed).abs() < 1e-10, "{t} {}", slip(t));
            assert!((normal(t) - m * speed * speed / r).abs() < 1e-9, "{t} {}", normal(t));
            assert!((friction(t) + mu * normal(t) * v.signum()).abs() < 1e-12);
        }
    }
}

/// A bead held by friction on a wire, with forces along and across it.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = line(alpha), friction = mu, static = mu_s)]
#[force(P = (f * cos(alpha) - (c * t - d) * sin(alpha), f * sin(alpha) + (c * t - d) * cos(alpha)))]
#[coordinate(x = x(P))]
#[figure(P = (0, 0))]
struct Held {
    m: f64,
    alpha: f64,
    mu: f64,
    mu_s: f64,
    f: f64,
    c: f64,
    d: f64,
}

/// With nothing along the wire it stays, and its side changes with N. A force f along it lets it
/// slip where μₛ N = f; then m v̇ = f − μ |N|, N = d − c t. Without any force N is zero throughout,
/// and nothing happens.
#[test]
fn a_held_bead_changes_its_side_at_rest_or_slips() {
    let (m, mu, mu_s, c, d) = (0.8, 0.4, 0.6, 3.0, 2.0);
    for alpha in [0.0, 0.7, -2.0_f64] {
        let of = |f: f64, c: f64, d: f64, v: f64| {
            let start = Pose::new("x", 0.0).with("x'", v * alpha.cos());
            let simulation =
                Simulation::new(&Held { m, alpha, mu, mu_s, f, c, d }).unwrap().start(start).unwrap();
            run(simulation.impulse("P", [0.0, 0.0], 1.9).unwrap().limit(2.0))
        };
        let happened = |run: &Trajectory| {
            let seen = run.events().iter().filter(|event| event.kind != EventKind::Impulse);
            seen.map(|event| (event.kind, event.t)).collect::<Vec<_>>()
        };
        let rest = happened(&of(0.0, c, d, 0.0));
        assert!(
            rest.len() == 3 && rest[1].0 == EventKind::Side && (rest[1].1 - d / c).abs() < 1e-10,
            "{rest:?}"
        );
        let none = of(0.0, 0.0, 0.0, 1.0);
        assert_eq!(happened(&none).len(), 2, "{:?}", happened(&none));
        let f = 0.3;
        let record = of(f, c, d, 0.0);
        let seen = happened(&record);
        let expected = [EventKind::Start, EventKind::Slip, EventKind::Side, EventKind::Stick, EventKind::End];
        assert_eq!(seen.iter().map(|(kind, _)| *kind).collect::<Vec<_>>(), expected);
        let slip = (d - f / mu_s) / c;
        assert!((seen[1].1 - slip).abs() < 1e-10 && (seen[2].1 - d / c).abs() < 1e-10, "{seen:?}");
        // m v(t) = f (t − t₁) − μ (N₁² ± N²)/2c with − before and + after N changes its sign.
        let velocity = |t: f64| {
            let normal = d - c * t;
            let lost = mu * ((f / mu_s).powi(2) - normal * normal.abs()) / (2.0 * c);
            (f * (t - slip) - lost) / m
        };
        let slides = record.function("v(P)").unwrap();
        for t in [slip, d / c, seen[3].1] {
            assert!((slides(t) - velocity(t)).abs() < 1e-10, "{t} {} {}", slides(t), velocity(t));
        }
    }
}
