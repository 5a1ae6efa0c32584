//! Points against bars that move, against closed forms.

use liftoff::prelude::*;
use liftoff_core::model::Layout;

fn run(simulation: Simulation) -> Trajectory {
    simulation.run().unwrap_or_else(|error| panic!("{error}"))
}

fn value(record: &Trajectory, layout: &'static Layout, text: &str, t: f64) -> f64 {
    record.value(&Output::parse(layout, text).unwrap(), t)
}

/// A bead before a bar that a drive turns.
#[derive(BarSystem)]
#[bar(OB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[particle(P, mass = m)]
#[support(P = bar(OB))]
#[drive(angle(OB) = w * t)]
#[coordinate(phi = angle(OB), from = right)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(B = (l, 0), P = (l / 2, l / 4))]
struct Swept {
    m: f64,
    l: f64,
    w: f64,
}

/// Along the bar r̈ = ω² r, so that r = r₀ cosh ωt; across it N = 2 m ω ṙ; at r = l it leaves the
/// bar.
#[test]
fn a_turning_bar_flings_a_bead_off_its_end() {
    let (m, l, w) = (1.3, 2.0, 1.5);
    let pose = Pose::new("phi", 0.0).with("x", 0.5).with("y", 0.0).with("x'", 0.0).with("y'", 0.5 * w);
    let simulation = Simulation::new(&Swept { m, l, w }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(2.0).tolerance(1e-12));
    let end = (l / 0.5).acosh() / w;
    let t = 0.7 * end;
    let at = |text: &str| value(&record, Swept::LAYOUT, text, t);
    let r = 0.5 * (w * t).cosh();
    assert!((at("x") - r * (w * t).cos()).abs() < 1e-10 && (at("y") - r * (w * t).sin()).abs() < 1e-10);
    let push = 2.0 * m * w * 0.5 * w * (w * t).sinh();
    assert!((at("N(P)") - push).abs() < 1e-9 * push, "{}", at("N(P)"));
    // The drive turns the bar against the push at r.
    assert!((at("drive(angle(OB))") - push * r).abs() < 1e-9, "{}", at("drive(angle(OB))"));
    // The pin bears the push and holds the bar's centre on its circle.
    let [inwards, across] =
        [0.5 * m * w * w * l, push].map(|force| [force * (w * t).cos(), force * (w * t).sin()]);
    assert!((at("fx(O)") + inwards[0] + across[1]).abs() < 1e-9, "{}", at("fx(O)"));
    assert!((at("fy(O)") + inwards[1] - across[0]).abs() < 1e-9, "{}", at("fy(O)"));
    let left = record.events().iter().find(|event| event.kind == EventKind::SlideOff).expect("an end");
    assert!((left.t - end).abs() < 1e-10, "{left}");
}

/// A particle that strikes a free rod.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[particle(P, mass = p)]
#[support(P = bar(AB), restitution = e)]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(u = x(A))]
#[coordinate(v = y(A))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(A = (0, 0), B = (l, 0), P = (l / 3, l))]
struct Struck {
    m: f64,
    p: f64,
    l: f64,
    e: f64,
}

/// At s from the middle the impulse is (1 + e) v/(1/p + 1/m + s²/I); momenta stay.
#[test]
fn a_particle_strikes_a_free_rod_and_both_go_on() {
    let (m, p, l, e, v) = (2.0, 0.7, 1.5, 0.6, 3.0);
    let struck = Struck { m, p, l, e };
    let pose = ["phi", "u", "v", "phi'", "u'", "v'", "x'"]
        .iter()
        .fold(Pose::new("y'", -v), |pose, name| pose.with(*name, 0.0));
    let pose = pose.with("x", 1.2).with("y", 0.9);
    let record = run(Simulation::new(&struck).unwrap().start(pose).unwrap().limit(1.0).tolerance(1e-12));
    let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).expect("an impact");
    assert!((impact.t - 0.3).abs() < 1e-12, "{impact}");
    let s = 1.2 - l / 2.0;
    let impulse = (1.0 + e) * v / (1.0 / p + 1.0 / m + s * s / (m * l * l / 12.0));
    assert!((impact.impulses[0].value - impulse).abs() < 1e-11, "{impact}");
    for (name, expected) in [("px", 0.0), ("py", -p * v), ("Lz", -1.2 * p * v)] {
        for t in [0.1, 0.5, 0.9] {
            let found = value(&record, Struck::LAYOUT, name, t);
            assert!((found - expected).abs() < 1e-10, "{name} at {t}: {found}");
        }
    }
    let lost = (1.0 - e * e) * v * v / 2.0 / (1.0 / p + 1.0 / m + s * s / (m * l * l / 12.0));
    let energy = |t: f64| value(&record, Struck::LAYOUT, "E", t);
    assert!((energy(0.1) - energy(0.9) - lost).abs() < 1e-11);
}

/// A block on a wedge that stands on a smooth floor; the wedge is a bar that keeps its direction.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[weld(AB, angle = a)]
#[slider(A = horizontal(0))]
#[particle(P, mass = p)]
#[support(P = bar(AB), friction = mu)]
#[coordinate(u = x(A))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(A = (0, 0), B = (l * cos(a), l * sin(a)), P = (0, l))]
struct Wedge {
    m: f64,
    p: f64,
    l: f64,
    g: f64,
    a: f64,
    mu: f64,
}

/// With N across the wedge and R = ±μ N along it the block has ẍ = −(N sin α − R cos α)/p, the
/// wedge ü = (N sin α − R cos α)/m; across the wedge they move together: (ẍ − ü) sin α = ÿ cos α.
#[test]
fn a_block_slides_down_a_wedge_that_gives_way() {
    let (m, p, l, g, a) = (3.0, 1.2, 4.0, 9.81, 0.6_f64);
    let (sin, cos) = a.sin_cos();
    for mu in [0.0, 0.2, 0.9] {
        let wedge = Wedge { m, p, l, g, a, mu };
        let pose = Pose::new("u", 0.0).with("x", 3.0 * cos).with("y", 3.0 * sin);
        let pose = pose.with("u'", 0.4).with("x'", 0.4).with("y'", 0.0);
        let record = run(Simulation::new(&wedge).unwrap().start(pose).unwrap().limit(0.5).tolerance(1e-11));
        let at = |text: &str| value(&record, Wedge::LAYOUT, text, 0.3);
        let (n, r) = if mu > a.tan() {
            (p * g * cos, p * g * sin)
        } else {
            let n = p * g * cos / (1.0 + p / m * sin * (sin - mu * cos));
            (n, mu * n)
        };
        let drift = (n * sin - r * cos) / m;
        assert!((at("N(P)") - n).abs() < 1e-9, "{mu}: {} for {n}", at("N(P)"));
        assert!((at("u") - 0.12 - 0.5 * drift * 0.09).abs() < 1e-9, "{mu}");
        let fall = 0.5 * 0.09 * (g - (n * cos + r * sin) / p);
        assert!((3.0 * sin - at("y") - fall).abs() < 1e-9, "{mu}");
    }
}

/// A bead on a bar that a drive turns, between the bar's ends.
#[derive(BarSystem)]
#[bar(OB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[particle(P, mass = m)]
#[slider(P = bar(OB), stops, restitution = e)]
#[drive(angle(OB) = w * t)]
#[coordinate(phi = angle(OB), from = right)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(B = (l, 0), P = (l / 2, 0))]
struct Bead {
    m: f64,
    l: f64,
    w: f64,
    e: f64,
}

/// From rest on the bar r = r₀ cosh ωt; at r = l it is thrown back with e of its rate, after which
/// r = l cosh ωτ − e √(l² − r₀²) sinh ωτ.
#[test]
fn a_bead_is_stopped_at_the_end_of_its_bar() {
    let (l, w, e, r) = (2.0_f64, 1.5, 0.6, 0.5_f64);
    let pose = Pose::new("phi", 0.0).with("x", r).with("y", 0.0).with("x'", 0.0).with("y'", r * w);
    let simulation = Simulation::new(&Bead { m: 1.3, l, w, e }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(2.0).tolerance(1e-12));
    let struck = (l / r).acosh() / w;
    let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).expect("an end");
    assert!((impact.t - struck).abs() < 1e-10 && impact.to_string().contains("P_B"), "{impact}");
    let rate = w * (l * l - r * r).sqrt();
    assert!((impact.impulses[0].value - (1.0 + e) * 1.3 * rate).abs() < 1e-9, "{impact}");
    let after = 0.3;
    let at = |text: &str| value(&record, Bead::LAYOUT, text, struck + after);
    let expected = l * (w * after).cosh() - e * rate / w * (w * after).sinh();
    assert!((at("x").hypot(at("y")) - expected).abs() < 1e-9, "{} for {expected}", at("x").hypot(at("y")));
}
