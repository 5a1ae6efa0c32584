//! Discs, and circles that move, against closed forms.

use liftoff::prelude::*;
use liftoff_core::model::Layout;

fn run(simulation: Simulation) -> Trajectory {
    simulation.run().unwrap_or_else(|error| panic!("{error}"))
}

fn value(record: &Trajectory, layout: &'static Layout, text: &str, t: f64) -> f64 {
    record.value(&Output::parse(layout, text).unwrap(), t)
}

/// A uniform disc on a slope.
#[derive(BarSystem)]
#[gravity(g)]
#[body(wheel, points(A = (0, 0), B = (r, 0)), mass = m, inertia = m * r * r / 2, centre = (0, 0))]
#[disc(A, radius = r)]
#[support(A = slope(-a), friction = mu)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(phi = angle(wheel), from = right)]
#[figure(A = (0, 2 * r), B = (r, 2 * r))]
struct Rolling {
    m: f64,
    r: f64,
    g: f64,
    a: f64,
    mu: f64,
}

/// Down a slope that falls to the right a disc rolls with ⅔ g sin α where tan α < 3μ; else it
/// slides with g (sin α − μ cos α) and spins up with 2μ g cos α/r.
#[test]
fn a_disc_rolls_or_slides_down_a_slope() {
    let (r, g, a) = (0.4, 9.81, 0.5_f64);
    let (sin, cos) = a.sin_cos();
    for mu in [0.3, 0.1] {
        let wheel = Rolling { m: 1.7, r, g, a, mu };
        // The centre is r from the slope.
        let pose = Pose::new("x", r * sin).with("y", r * cos).with("phi", 0.0);
        let pose = pose.with("x'", 0.0).with("y'", 0.0).with("phi'", 0.0);
        let record = run(Simulation::new(&wheel).unwrap().start(pose).unwrap().limit(1.0).tolerance(1e-11));
        let at = |text: &str| value(&record, Rolling::LAYOUT, text, 0.8);
        let (along, spin) = if a.tan() < 3.0 * mu {
            (2.0 / 3.0 * g * sin, 2.0 / 3.0 * g * sin / r)
        } else {
            (g * (sin - mu * cos), 2.0 * mu * g * cos / r)
        };
        assert!((at("x") - r * sin - 0.32 * along * cos).abs() < 1e-9, "{mu}: {}", at("x"));
        assert!((at("phi") + 0.32 * spin).abs() < 1e-9, "{mu}: {}", at("phi"));
    }
}

/// x = v t − ½ g μ t² on a slope that is all but level: x is not what the contact determines, as (r
/// − y cos α)/sin α.
#[test]
fn a_disc_slides_on_a_level_slope() {
    let (r, g, mu, v) = (0.4, 9.81, 0.2, 2.0);
    for a in [0.0, 2e-10, -1e-8, 1e-6] {
        let wheel = Rolling { m: 1.7, r, g, a, mu };
        let pose = Pose::new("x", r * a.sin()).with("y", r * a.cos()).with("phi", 0.0);
        let pose = pose.with("x'", v).with("y'", -v * a.tan()).with("phi'", 0.0);
        let record = run(Simulation::new(&wheel).unwrap().start(pose).unwrap().limit(0.1).tolerance(1e-12));
        let x = r * a.sin() + 0.1 * v - 0.5 * g * (mu - a) * 0.01;
        let found = value(&record, Rolling::LAYOUT, "x", 0.1);
        // a² is left out.
        assert!((found - x).abs() < 1e-12, "{a}: {found:?}, not {x:?}");
        assert!(record.log().is_empty() && record.audit().is_clean(), "{a}: {:?}", record.log());
    }
}

/// A disc on a fixed one, from whose top it rolls.
#[derive(BarSystem)]
#[gravity(g)]
#[body(wheel, points(A = (0, 0), B = (r, 0)), mass = m, inertia = m * r * r / 2, centre = (0, 0))]
#[disc(A, radius = r)]
#[support(A = circle((0, 0), c), rough)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(phi = angle(wheel), from = right)]
#[figure(A = (0, c + r), B = (r, c + r))]
struct OnTop {
    m: f64,
    r: f64,
    c: f64,
    g: f64,
}

/// From rest at θ₀ a disc leaves where 7 cos θ = 4 cos θ₀, by v² = (4/3) g (R + r)(cos θ₀ − cos θ)
/// and N = 0; it has turned by θ (R + r)/r.
#[test]
fn a_disc_rolls_off_another() {
    let (r, c, start) = (0.3, 0.9, 0.2_f64);
    let reach = r + c;
    let pose = Pose::new("x", reach * start.sin()).with("y", reach * start.cos()).with("phi", 0.0);
    let pose = pose.with("x'", 0.0).with("y'", 0.0).with("phi'", 0.0);
    let simulation = Simulation::new(&OnTop { m: 1.1, r, c, g: 9.81 }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(2.0).tolerance(1e-12));
    let left = record.events().iter().find(|event| event.kind == EventKind::Open).expect("it leaves");
    let angle = (4.0 / 7.0 * start.cos()).acos();
    assert!((left["x"].atan2(left["y"]) - angle).abs() < 1e-9, "{left}");
    assert!((left["phi"] + (angle - start) * reach / r).abs() < 1e-9, "{left}");
}

/// A disc on a plank that is pulled over a smooth floor.
#[derive(BarSystem)]
#[gravity(g)]
#[body(wheel, points(A = (0, 0), B = (r, 0)), mass = m, inertia = m * r * r / 2, centre = (0, 0))]
#[disc(A, radius = r)]
#[bar(CD, mass = p, length = l)]
#[weld(CD, angle = 0)]
#[slider(C = horizontal(0))]
#[support(A = bar(CD), rough)]
#[force(C = (f, 0))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(u = x(C))]
#[coordinate(phi = angle(wheel), from = right)]
#[figure(A = (0, r), B = (r, r), C = (-l / 2, 0), D = (l / 2, 0))]
struct Plank {
    m: f64,
    p: f64,
    r: f64,
    l: f64,
    f: f64,
    g: f64,
}

/// The plank has ü = F/(p + m/3), the disc a third of it, and turns with 2/3 ü/r.
#[test]
fn a_disc_rolls_on_a_plank_that_is_pulled_away() {
    let (m, p, r, f) = (1.5, 2.0, 0.25, 3.0);
    let plank = Plank { m, p, r, l: 4.0, f, g: 9.81 };
    let pose = Pose::new("x", 0.0).with("y", r).with("u", -2.0).with("phi", 0.0);
    let pose = pose.with("x'", 0.0).with("y'", 0.0).with("u'", 0.0).with("phi'", 0.0);
    let record = run(Simulation::new(&plank).unwrap().start(pose).unwrap().limit(1.0).tolerance(1e-12));
    let at = |text: &str| value(&record, Plank::LAYOUT, text, 0.9);
    let pulled = f / (p + m / 3.0);
    assert!((at("u") + 2.0 - 0.405 * pulled).abs() < 1e-10, "{}", at("u"));
    assert!((at("x") - 0.405 * pulled / 3.0).abs() < 1e-10, "{}", at("x"));
    assert!((at("phi") - 0.405 * 2.0 / 3.0 * pulled / r).abs() < 1e-10, "{}", at("phi"));
    assert!((at("R(A)") - m * pulled / 3.0).abs() < 1e-9, "{}", at("R(A)"));
}

/// Two free discs that meet with friction.
#[derive(BarSystem)]
#[body(one, points(A = (0, 0), B = (r, 0)), mass = m, inertia = m * r * r / 2, centre = (0, 0))]
#[body(two, points(C = (0, 0), D = (c, 0)), mass = m, inertia = m * c * c / 2, centre = (0, 0))]
#[disc(A, radius = r)]
#[disc(C, radius = c)]
#[support(A = disc(C), friction = mu, restitution = e)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(u = x(C))]
#[coordinate(v = y(C))]
#[coordinate(phi = angle(one), from = right)]
#[coordinate(psi = angle(two), from = right)]
#[figure(A = (0, 0), B = (r, 0), C = (4, 0), D = (4 + c, 0))]
struct Curling {
    m: f64,
    r: f64,
    c: f64,
    mu: f64,
    e: f64,
}

/// A disc with the velocity v meets one at rest head-on and spins by ω: P = (1 + e) m v/2 along the
/// centres; across them, as it slips to the end, μ P, which turns both the same way by 2μP/mr and
/// 2μP/mc.
#[test]
fn spinning_discs_collide_with_friction() {
    let (m, r, c, mu, e, v, spin) = (1.3, 0.5, 0.8, 0.1, 0.7, 2.0, 20.0);
    let names = ["y", "u", "v", "phi", "psi", "y'", "u'", "v'", "psi'"];
    let pose = names.iter().fold(Pose::new("x'", v), |pose, name| pose.with(*name, 0.0));
    let pose = pose.with("x", -2.0).with("phi'", spin);
    let simulation = Simulation::new(&Curling { m, r, c, mu, e }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(1.0).tolerance(1e-12));
    let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).expect("an impact");
    assert!((impact.t - (2.0 - r - c) / v).abs() < 1e-12, "{impact}");
    let push = (1.0 + e) * m * v / 2.0;
    let at = |text: &str| value(&record, Curling::LAYOUT, text, 0.9);
    assert!((at("x'") - v + push / m).abs() < 1e-11 && (at("u'") - push / m).abs() < 1e-11);
    // The rim of A at the place of contact goes up, so that C is carried up, A down.
    assert!((at("y'") + mu * push / m).abs() < 1e-11 && (at("v'") - mu * push / m).abs() < 1e-11);
    assert!((at("phi'") - spin + 2.0 * mu * push / (m * r)).abs() < 1e-10, "{}", at("phi'"));
    assert!((at("psi'") + 2.0 * mu * push / (m * c)).abs() < 1e-10, "{}", at("psi'"));
    for name in ["px", "py", "Lz"] {
        let of = |t: f64| value(&record, Curling::LAYOUT, name, t);
        assert!((of(0.1) - of(0.9)).abs() < 1e-11, "{name}");
    }
}

/// Five equal balls in a row.
#[derive(BarSystem)]
#[particle(A, mass = m)]
#[particle(B, mass = m)]
#[particle(C, mass = m)]
#[particle(D, mass = m)]
#[particle(E, mass = m)]
#[disc(A, radius = r)]
#[disc(B, radius = r)]
#[disc(C, radius = r)]
#[disc(D, radius = r)]
#[disc(E, radius = r)]
#[slider(A = horizontal(0))]
#[slider(B = horizontal(0))]
#[slider(C = horizontal(0))]
#[slider(D = horizontal(0))]
#[slider(E = horizontal(0))]
#[support(A = disc(B), restitution = e)]
#[support(B = disc(C), restitution = e)]
#[support(C = disc(D), restitution = e)]
#[support(D = disc(E), restitution = e)]
#[coordinate(a = x(A))]
#[coordinate(b = x(B))]
#[coordinate(c = x(C))]
#[coordinate(d = x(D))]
#[coordinate(z = x(E))]
#[figure(A = (0, 0), B = (3 * r, 0), C = (6 * r, 0), D = (9 * r, 0), E = (12 * r, 0))]
struct Cradle {
    m: f64,
    r: f64,
    e: f64,
}

impl Cradle {
    /// Balls so far apart, the first with the velocity 1.
    fn run(&self, apart: f64) -> Trajectory {
        let names = ["b", "c", "d", "z"];
        let step = 2.0 * self.r + apart;
        let pose = Pose::new("a", -step).with("a'", 1.0);
        let pose = names.iter().zip(0..).fold(pose, |pose, (name, k)| {
            pose.with(*name, f64::from(k) * step).with(format!("{name}'"), 0.0)
        });
        run(Simulation::new(self).unwrap().start(pose).unwrap().limit(3.0).tolerance(1e-12))
    }

    fn velocities(record: &Trajectory) -> [f64; 5] {
        ["a'", "b'", "c'", "d'", "z'"].map(|name| value(record, Self::LAYOUT, name, 2.9))
    }
}

/// Balls apart from each other strike one after another: of e = 1 only the last moves; of any e the
/// last has ((1 + e)/2)⁴.
#[test]
fn a_cradle_with_gaps_passes_the_motion_on() {
    let record = Cradle { m: 0.4, r: 0.1, e: 1.0 }.run(1e-3);
    let velocities = Cradle::velocities(&record);
    let expected = [0.0, 0.0, 0.0, 0.0, 1.0];
    assert!(velocities.iter().zip(expected).all(|(v, x)| (v - x).abs() < 1e-10), "{velocities:?}");
    let impacts = record.events().iter().filter(|event| event.kind == EventKind::Impact);
    assert_eq!(impacts.count(), 4);
    let record = Cradle { m: 0.4, r: 0.1, e: 0.8 }.run(1e-3);
    assert!((Cradle::velocities(&record)[4] - 0.9_f64.powi(4)).abs() < 1e-10);
}

/// Balls that touch answer at once: the gap that closes gives back e of its rate, the others stay
/// closed, as the law of Newton has it for all contacts. The last four go on together: a = v − e
/// and a + 4 v = 1.
#[test]
fn a_cradle_without_gaps_answers_at_once() {
    for e in [1.0, 0.6, 0.0] {
        let velocities = Cradle::velocities(&Cradle { m: 0.4, r: 0.1, e }.run(0.0));
        let together = (1.0 + e) / 5.0;
        let expected = [together - e, together, together, together, together];
        assert!(velocities.iter().zip(expected).all(|(v, x)| (v - x).abs() < 1e-11), "{velocities:?}");
    }
}

/// A pin in a larger hole of a plate; both are free.
#[derive(BarSystem)]
#[body(plate, points(G = (0, 0), H = (l, 0)), mass = m, inertia = m * l * l, centre = (0, 0))]
#[particle(P, mass = p)]
#[disc(P, radius = r)]
#[support(P = bowl(G, c))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[coordinate(u = x(G))]
#[coordinate(v = y(G))]
#[figure(G = (0, 0), H = (l, 0), P = (0, 0))]
struct Clearance {
    m: f64,
    p: f64,
    l: f64,
    r: f64,
    c: f64,
}

/// Round the hole with the relative velocity w the pin goes at w/(c − r), pressed by the reduced
/// mass times w²/(c − r).
#[test]
fn a_pin_goes_round_a_hole_of_a_free_plate() {
    let (m, p, r, c, w) = (2.0, 0.5, 0.3, 0.5, 1.4);
    let play: f64 = c - r;
    let names = ["y", "u", "v", "x'", "u'", "v'"];
    let pose = names.iter().fold(Pose::new("x", play), |pose, name| pose.with(*name, 0.0)).with("y'", w);
    let simulation = Simulation::new(&Clearance { m, p, l: 1.0, r, c }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(3.0).tolerance(1e-12));
    let t = 2.7;
    let at = |text: &str| value(&record, Clearance::LAYOUT, text, t);
    let angle = w / play * t;
    assert!(
        (at("x - u") - play * angle.cos()).abs() < 1e-9 && (at("y - v") - play * angle.sin()).abs() < 1e-9
    );
    assert!((at("N(P)") - m * p / (m + p) * w * w / play).abs() < 1e-9, "{}", at("N(P)"));
    assert!((at("(m * u + p * x) / (m + p)") - p * play / (m + p)).abs() < 1e-11);
}

/// A bead on a circle, which holds it from both sides.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[slider(P = circle((c, 0), r))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (c, -r))]
struct Hoop {
    m: f64,
    r: f64,
    c: f64,
    g: f64,
}

/// With 2.25 g r as the square of its velocity at the bottom it passes the level of the centre and
/// is held from outside where v² < −g r cos θ; at the height h above the bottom v² = v₀² − 2 g h
/// and N = m (v²/r + g (1 − h/r)), to the centre.
#[test]
fn a_bead_on_a_hoop_is_held_from_both_sides() {
    let (m, r, c, g) = (1.3, 0.5, 0.2, 9.81_f64);
    let start = (2.25 * g * r).sqrt();
    let pose = Pose::new("x", c).with("y", -r).with("x'", start).with("y'", 0.0);
    let simulation = Simulation::new(&Hoop { m, r, c, g }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(1.0).tolerance(1e-12));
    let mut signs = [false; 2];
    for t in (1..=20).map(|k| 0.05 * f64::from(k)) {
        let at = |text: &str| value(&record, Hoop::LAYOUT, text, t);
        let (h, speed) = (at("y") + r, at("x'").hypot(at("y'")));
        assert!(((at("x") - c).hypot(at("y")) - r).abs() < 1e-10);
        assert!((speed * speed - start * start + 2.0 * g * h).abs() < 1e-8, "{t}");
        let held = m * (speed * speed / r + g * (1.0 - h / r));
        assert!((at("slider(P)") - held).abs() < 1e-7, "{t}: {} for {held}", at("slider(P)"));
        signs[usize::from(held > 0.0)] = true;
    }
    assert_eq!(signs, [true; 2]);
}

/// A thin plank on a cylinder that stands still.
#[derive(BarSystem)]
#[gravity(g)]
#[ground(O = (0, 0))]
#[disc(O, radius = r)]
#[bar(AB, mass = m, length = l)]
#[support(O = bar(AB), rough)]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[figure(A = (-l / 2, r), B = (l / 2, r))]
struct Rocker {
    m: f64,
    l: f64,
    r: f64,
    g: f64,
}

/// It rolls: at the tilt φ its middle is r φ from where it touches, ½ (m l²/12 + m r² φ²) φ̇² + m g
/// r (cos φ + φ sin φ) keeps its value, and a quarter of a period is ∫ dφ/φ̇.
#[test]
fn a_plank_rocks_on_a_cylinder() {
    let (m, l, r, g, tilt) = (2.0, 1.3, 0.4, 9.81, 0.5_f64);
    let height = |phi: f64| phi.cos() + phi * phi.sin();
    let rate =
        |phi: f64| (2.0 * g * r * (height(tilt) - height(phi)) / (l * l / 12.0 + r * r * phi * phi)).sqrt();
    // φ = φ₀ sin u makes the integrand even and smooth at both ends: midpoints converge faster than
    // any power.
    let parts = 200;
    let at = |k: u32| core::f64::consts::FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(parts);
    let quarter: f64 = (0..parts).map(|k| tilt * at(k).cos() / rate(tilt * at(k).sin())).sum::<f64>()
        * core::f64::consts::FRAC_PI_2
        / f64::from(parts);
    let (sin, cos) = tilt.sin_cos();
    let back = r * tilt - l / 2.0;
    let pose = Pose::new("phi", tilt).with("x", -r * sin + back * cos).with("y", r * cos + back * sin);
    let simulation = Simulation::new(&Rocker { m, l, r, g }).unwrap().tolerance(1e-12).start(pose).unwrap();
    let record = run(simulation.until("phi = 0").unwrap());
    let end = record.events().last().unwrap();
    assert!((end.t - quarter).abs() < 1e-9, "{} {quarter}", end.t);
    assert!((end["phi'"] + rate(0.0)).abs() < 1e-9 && (end["x"] + l / 2.0).abs() < 1e-9, "{end}");
}
