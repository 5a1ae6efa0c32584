//! Guides with Coulomb friction against closed forms.

use liftoff::method::MethodId;
use liftoff::model::Form;
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
    let start = Pose::at("x", r).with("y", 0.0).with("x'", 0.0);
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

/// A ladder between a vertical and a horizontal guide.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[slider(A = horizontal(0), friction = mu)]
#[slider(B = vertical(0), friction = nu, static = nu_s)]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (-3 * l / 5, 0), B = (0, 4 * l / 5))]
struct Ellipsograph {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
    nu: f64,
    nu_s: f64,
}

/// Newton's and Euler's equations of the whole, with the forces at the ends as they are told; Coulomb's law with |N|; the
/// energy. The bar swings through its lowest position, so that both ends change their sides.
#[test]
fn an_ellipsograph_obeys_the_laws_of_motion_and_friction() {
    let (m, l, g, mu, nu) = (1.2, 0.8, 9.81, 0.1, 0.15);
    let model = Ellipsograph { m, l, g, mu, nu, nu_s: 0.2 };
    let start = Pose::at("theta", 0.9).with("theta'", 0.0);
    let record = run(Simulation::new(&model).unwrap().start(start).unwrap().limit(6.0));
    let kinds: Vec<EventKind> = record.events().iter().map(|event| event.kind).collect();
    let count = |kind: EventKind| kinds.iter().filter(|it| **it == kind).count();
    assert!(count(EventKind::Side) >= 4 && count(EventKind::Reverse) >= 4, "{kinds:?}");
    assert_eq!(kinds[kinds.len() - 2], EventKind::Stick, "{kinds:?}");
    let of = |text: &str| record.function(text).unwrap();
    let [theta, rate, acceleration] = ["theta", "theta'", "theta''"].map(of);
    let [na, nb, ra, rb, va, vb] = ["N(A)", "N(B)", "R(A)", "R(B)", "v(A)", "v(B)"].map(of);
    let energy = of("T + V + D");
    for k in 1..600 {
        let t = 0.01 * f64::from(k);
        let (s, c) = theta(t).sin_cos();
        let (w, a) = (rate(t), acceleration(t));
        // Centre at (−l/2 cos θ, l/2 sin θ); A at (−l cos θ, 0), B at (0, l sin θ).
        let force = [m * 0.5 * l * (s * a + c * w * w), m * 0.5 * l * (c * a - s * w * w)];
        // The normals are a quarter turn from the guides: up for A; to the left for B, whose guide points up.
        let [ax, ay, bx, by] = [ra(t), na(t), -nb(t), rb(t)];
        assert!((ax + bx - force[0]).abs() < 1e-9 * m * g, "{t}");
        assert!((ay + by - m * g - force[1]).abs() < 1e-9 * m * g, "{t}");
        let moment = 0.5 * l * (-c * ay + s * ax) + 0.5 * l * (c * by - s * bx);
        assert!((moment - m * l * l / 12.0 * a).abs() < 1e-9 * m * g * l, "{t}");
        for (normal, friction, slip, mu) in [(na(t), ra(t), va(t), mu), (nb(t), rb(t), vb(t), nu)] {
            let law = if slip.abs() > 1e-9 { friction + mu * normal.abs() * slip.signum() } else { 0.0 };
            assert!(law.abs() < 1e-9 * m * g, "{t} {law}");
        }
        assert!((energy(t) - energy(0.0)).abs() < 1e-10 * m * g * l, "{t} {}", energy(t) - energy(0.0));
    }
}

/// A drawer: a body in a guide at two points, pulled beside it.
#[derive(BarSystem)]
#[body(K, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m, inertia = j, centre = (l / 2, b))]
#[slider(A = horizontal(0), friction = mu, jams)]
#[slider(B = horizontal(0), friction = mu)]
#[force(C = (f, 0))]
#[coordinate(x = x(A))]
#[figure(A = (0, 0), B = (l, 0), C = (0, h))]
struct Drawer {
    m: f64,
    j: f64,
    l: f64,
    h: f64,
    b: f64,
    mu: f64,
    f: f64,
}

/// With the centre on the guide −N_A = N_B = f h/l: it locks for 2 μ h > l, whatever the force, and else has (f − 2 μ f h/l)/m.
#[test]
fn a_drawer_locks_beyond_the_angle_of_friction() {
    let (m, j, l, h, b) = (2.0, 0.3, 0.6, 1.0, 0.0);
    for f in [-50.0, 0.1, 3.0, 1e4] {
        let start = || Pose::at("x", 0.0).with("x'", 0.0);
        let locked = Drawer { m, j, l, h, b, mu: 0.3001, f };
        let error = Simulation::new(&locked).unwrap().start(start()).unwrap().limit(1.0).run().unwrap_err();
        assert!(
            matches!(error.cause(), liftoff::RunCause::Start(liftoff::StartError::Equilibrium)),
            "{error}"
        );
        let free = Drawer { m, j, l, h, b, mu: 0.2, f };
        let record = run(Simulation::new(&free).unwrap().start(start()).unwrap().limit(1.0));
        let a = (f - f.signum() * 2.0 * 0.2 * (f * h / l).abs()) / m;
        let [x, na, nb] = ["x", "N(A)", "N(B)"].map(|text| record.function(text).unwrap());
        assert!((x(1.0) - 0.5 * a).abs() < 1e-10 * a.abs().max(1.0));
        assert!((na(0.5) + f * h / l).abs() < 1e-9 * f.abs().max(1.0), "{} {}", na(0.5), f * h / l);
        assert!((na(0.5) + nb(0.5)).abs() < 1e-9 * f.abs().max(1.0));
    }
}

/// The same with the centre at the height b, pushed on while it slides:
///
/// ```text
/// (l − 2 σ μ s b) N_B = f (h − b),    s = sign N_B
/// ```
///
/// For 2 μ b > l, σ = 1 and f (h − b) > 0 there is no motion in which it slides; for f (h − b) < 0 there are two, of which
/// stiff guides would hold that with N_B < 0.
fn tall(mu: f64, f: f64) -> Drawer {
    Drawer { m: 2.0, j: 0.3, l: 0.6, h: 1.5, b: 1.0, mu, f }
}

#[test]
fn where_no_reaction_obeys_the_law_a_guide_jams() {
    let start = || Pose::at("x", 0.0).with("x'", 1.0);
    let go =
        |mu: f64, f: f64| Simulation::new(&tall(mu, f)).unwrap().start(start()).unwrap().limit(0.01).run();
    for f in [0.5, 20.0] {
        let error = go(0.31, f).unwrap_err();
        assert!(error.to_string().contains("jammed: no reactions of A, B satisfy"), "{error}");
        let run = go(0.29, f).unwrap();
        let normal = run.function("N(B)").unwrap()(0.0);
        let expected = f * 0.5 / (0.6 - 2.0 * 0.29);
        assert!((normal / expected - 1.0).abs() < 1e-9, "{normal} {expected}");
    }
    let run = go(0.31, -20.0).unwrap();
    let normal = run.function("N(B)").unwrap()(0.0);
    assert!((normal + 20.0 * 0.5 / (0.6 + 2.0 * 0.31)).abs() < 1e-9, "{normal}");
    let several = |entry: &liftoff::LogEntry| entry.decision.to_string().contains("stiff springs");
    assert!(run.log().iter().any(several), "{:?}", run.log());
}

/// A drawer that runs against a wall with its handle.
#[derive(BarSystem)]
#[body(K, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m, inertia = j, centre = (l / 2, 0))]
#[slider(A = horizontal(0), friction = mu)]
#[slider(B = horizontal(0), friction = mu)]
#[support(C = wall(w), restitution = e)]
#[coordinate(x = x(A))]
#[figure(A = (0, 0), B = (l, 0), C = (0, h))]
struct Stopped {
    m: f64,
    j: f64,
    l: f64,
    h: f64,
    w: f64,
    mu: f64,
    e: f64,
}

/// The guides bear P h/l each, and rub against the rebound: m (1 + e) v = P (1 − 2 μ h/l). An impulse I at the handle moves the
/// drawer by I (1 − 2 μ h/l)/m, and not at all where it locks.
#[test]
fn guides_rub_at_impacts() {
    let (m, l, h, mu, e, v) = (2.0, 0.6, 1.0, 0.2, 0.5, 1.0);
    let of = |mu: f64| Stopped { m, j: 0.3, l, h, w: 0.25, mu, e };
    let start = |rate: f64| Pose::at("x", 0.0).with("x'", rate);
    let record = run(Simulation::new(&of(mu)).unwrap().start(start(v)).unwrap().limit(0.5));
    let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    assert!((impact.t - 0.25 / v).abs() < 1e-10 && (impact["x'"] + e * v).abs() < 1e-12, "{impact}");
    let expected = m * (1.0 + e) * v / (1.0 - 2.0 * mu * h / l);
    let [a, b, wall] =
        ["A", "B", "C"].map(|label| impact.impulses.iter().find(|it| it.label == label).unwrap());
    assert!((wall.value - expected).abs() < 1e-10, "{:?}", impact.impulses);
    for guide in [a, b] {
        assert!((guide.value.abs() - expected * h / l).abs() < 1e-10, "{:?}", impact.impulses);
        assert!((guide.friction.unwrap() - mu * guide.value.abs()).abs() < 1e-10, "{:?}", impact.impulses);
    }
    let lost = record.function("D").unwrap()(0.5);
    assert!((lost - 0.5 * m * v * v * (1.0 - e * e)).abs() < 1e-10, "{lost}");
    for (mu, rate) in [(0.2, 3.0 / m * (1.0 - 2.0 * mu * h / l)), (0.31, 0.0)] {
        let simulation = Simulation::new(&of(mu)).unwrap().start(start(0.0)).unwrap().limit(0.02);
        let record = run(simulation.impulse("C", [-3.0, 0.0], 0.01).unwrap());
        let impulse = record.events().iter().find(|event| event.kind == EventKind::Impulse).unwrap();
        assert!((impulse["x'"] + rate).abs() < 1e-12, "{impulse}");
    }
}

/// Poses off a guide and rates across it are refused, by its name.
#[test]
fn starts_beside_a_guide_are_refused() {
    let bead = Bead { m: 1.0, mu: 0.3, c: 1.0, d: 1.0 };
    let refused =
        |pose: Pose| Simulation::new(&bead).unwrap().start(pose).err().map(|error| error.to_string());
    let off = refused(Pose::at("x", 0.0).with("y", 0.1)).unwrap();
    assert!(off.contains("slider P"), "{off}");
    let across = refused(Pose::at("x", 0.0).with("y'", 0.1)).unwrap();
    assert!(across.contains("slider P"), "{across}");
    assert_eq!(refused(Pose::at("x", 0.0).with("x'", 0.1)), None);
}

/// A guide that is taken away lets go.
#[test]
fn a_released_guide_lets_go() {
    let bead = Bead { m: 1.0, mu: 0.3, c: 0.0, d: 2.0 };
    let start = Pose::at("x", 0.0).with("x'", 1.0);
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
        let start = Pose::at("x", 0.0).with("y", -r).with("x'", v);
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

/// Every method and both forms see the same events.
#[test]
fn all_methods_and_forms_agree_on_guides() {
    let model = Ellipsograph { m: 1.2, l: 0.8, g: 9.81, mu: 0.1, nu: 0.15, nu_s: 0.2 };
    let start = || Pose::at("theta", 0.9).with("theta'", 0.0);
    let simulation = || Simulation::new(&model).unwrap().start(start()).unwrap().limit(6.0).tolerance(1e-11);
    let expected = run(simulation());
    let forms = [Form::Closed, Form::Projected].map(|form| simulation().form(form));
    let methods = MethodId::ALL.map(|method| simulation().method(method));
    for record in forms.into_iter().chain(methods).map(run) {
        assert_eq!(record.events().len(), expected.events().len());
        for (event, other) in record.events().iter().zip(expected.events()) {
            assert_eq!((event.kind, &event.supports), (other.kind, &other.supports), "{event} {other}");
            assert!((event.t - other.t).abs() < 1e-8, "{event} {other}");
        }
    }
}

/// A particle on a free bar: no force acts on the two.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[particle(P, mass = p)]
#[slider(P = bar(AB), friction = mu, static = mu_s)]
#[figure(A = (0, 0), B = (l, 0), P = (l / 3, 0))]
#[coordinate(theta = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Pair {
    m: f64,
    p: f64,
    l: f64,
    mu: f64,
    mu_s: f64,
}

/// Momentum and angular momentum stay, and T + D; N is across the bar and R along it on the particle, |R| = μ |N| against the
/// slip.
#[test]
fn what_slides_on_a_free_bar_keeps_its_momentum() {
    let mut seed = 0x1234_5678_9ABC_DEF1_u64;
    let mut between = |low: f64, high: f64| {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut stuck = 0;
    for _ in 0..60 {
        let mu = between(0.05, 1.2);
        let mu_s = mu * [1.0, 1.3][usize::from(between(0.0, 1.0) < 0.5)];
        let (m, p, l) = (between(0.5, 2.0), between(0.2, 2.0), between(0.5, 1.5));
        let place = between(-0.5, 1.5) * l;
        let turn = between(-3.0, 3.0);
        let slip = between(-2.0, 2.0);
        let pose = Pose::at("theta", 0.0).with("theta'", turn).with("x", 0.0).with("y", 0.0).with("x'", 0.0);
        let pose = pose.with("y'", 0.0).with("x_P", place).with("x_P'", slip);
        let model = Pair { m, p, l, mu, mu_s };
        let record = run(Simulation::new(&model).unwrap().start(pose).unwrap().limit(1.5));
        stuck += usize::from(record.events().iter().any(|event| event.kind == EventKind::Stick));
        let of = |text: &str| record.function(text).unwrap();
        let kept = ["px", "py", "Lz", "T + D"].map(of);
        let [theta, normal, friction, v, ax, ay] =
            ["theta", "N(P)", "R(P)", "v(P)", "ax(P)", "ay(P)"].map(of);
        let size = (m + p) * (l + 1.0) * 10.0;
        for k in 0..=30 {
            let t = 0.05 * f64::from(k);
            kept.iter()
                .for_each(|of| assert!((of(t) - of(0.0)).abs() < 1e-10 * size, "{t} {} {}", of(t), of(0.0)));
            let (s, c) = theta(t).sin_cos();
            let (across, along) = (p * (c * ay(t) - s * ax(t)), p * (c * ax(t) + s * ay(t)));
            assert!((across - normal(t)).abs().max((along - friction(t)).abs()) < 1e-10 * size, "{t}");
            let law = match v(t) {
                v if v.abs() > 1e-9 => (friction(t) + mu * normal(t).abs() * v.signum()).abs(),
                _ => friction(t).abs() - mu_s * normal(t).abs(),
            };
            assert!(law <= 1e-10 * size, "{t} {law}");
        }
    }
    assert!(stuck > 5, "{stuck}");
}

/// A slider-crank that a motor turns steadily: nothing is left free.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = r)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[mass(B, p)]
#[slider(B = horizontal(0), friction = mu)]
#[drive(phi = w * t)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0, r), B = (sqrt(l * l - r * r), 0))]
struct Crank {
    m: f64,
    p: f64,
    r: f64,
    l: f64,
    g: f64,
    mu: f64,
    w: f64,
}

/// The motor pays for the friction: T + V + D grows by its work.
#[test]
fn a_motor_pays_for_the_friction_of_a_piston() {
    let (r, l, w, mu) = (0.1, 0.3, 5.0, 0.25);
    let crank = Crank { m: 0.5, p: 1.0, r, l, g: 9.81, mu, w };
    let record = run(Simulation::new(&crank).unwrap().limit(1.3));
    let of = |text: &str| record.function(text).unwrap();
    let [energy, torque, normal, friction, slip] = ["E + D", "drive(phi)", "N(B)", "R(B)", "v(B)"].map(of);
    assert!(record.events().iter().any(|event| event.kind == EventKind::Reverse));
    // Gauss's rule of five points on small pieces between the events.
    let nodes = [
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_08),
    ];
    let mut work = 0.0;
    let times: Vec<f64> = record.events().iter().map(|event| event.t).collect();
    for pair in times.windows(2) {
        let pieces = 24;
        for k in 0..pieces {
            let half = 0.5 * (pair[1] - pair[0]) / f64::from(pieces);
            let middle = pair[0] + half * f64::from(2 * k + 1);
            for (x, weight) in nodes {
                let value =
                    torque(middle + half * x) + if x == 0.0 { 0.0 } else { torque(middle - half * x) };
                work += half * weight * w * value;
            }
        }
    }
    assert!((energy(1.3) - energy(0.0) - work).abs() < 1e-9, "{} {work}", energy(1.3) - energy(0.0));
    for k in 0..100 {
        let t = 0.013 * f64::from(k);
        let law = friction(t) + mu * normal(t).abs() * slip(t).signum();
        assert!(slip(t).abs() < 1e-6 || law.abs() < 1e-10, "{t} {law}");
    }
}

/// A drawer that does not jam: what no reaction holds is stopped at once.
#[derive(BarSystem)]
#[body(K, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m, inertia = j, centre = (l / 2, b))]
#[slider(A = horizontal(0), friction = mu)]
#[slider(B = horizontal(0), friction = mu)]
#[force(C = (f, 0))]
#[coordinate(x = x(A))]
#[figure(A = (0, 0), B = (l, 0), C = (0, h))]
struct Wedged {
    m: f64,
    j: f64,
    l: f64,
    h: f64,
    b: f64,
    mu: f64,
    f: f64,
}

/// The impulses of the guides stop it, |P_A| = |P_B| = b m v/l, within the cones of friction.
#[test]
fn an_impact_without_collision_ends_a_slip_in_guides() {
    let model = Wedged { m: 2.0, j: 0.3, l: 0.6, h: 1.5, b: 1.0, mu: 0.31, f: 5.0 };
    let start = Pose::at("x", 0.0).with("x'", 1.0);
    let record = run(Simulation::new(&model).unwrap().start(start).unwrap().limit(0.1));
    let impact = &record.events()[0];
    assert_eq!(
        (impact.kind, &impact.note),
        (EventKind::Impact, &Some(liftoff::Note::WithoutCollision)),
        "{impact}"
    );
    assert!(impact.t == 0.0 && impact["x'"].abs() < 1e-12, "{impact}");
    let impulse = |label: &str| impact.impulses.iter().find(|it| it.label == label).unwrap();
    for label in ["A", "B"] {
        let bound = 0.31 * impulse(label).value.abs();
        assert!((impulse(label).value.abs() - 1.0 * 2.0 / 0.6).abs() < 1e-10, "{:?}", impact.impulses);
        assert!(impulse(label).friction.unwrap().abs() <= bound, "{:?}", impact.impulses);
    }
    assert!(record.final_state().iter().all(|x| x.abs() < 1e-12), "{:?}", record.final_state());
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

/// With nothing along the wire it stays, and its side changes with N. A force f along it lets it slip where μₛ N = f; then
/// m v̇ = f − μ |N|, N = d − c t. Without any force N is zero throughout, and nothing happens.
#[test]
fn a_held_bead_changes_its_side_at_rest_or_slips() {
    let (m, mu, mu_s, c, d) = (0.8, 0.4, 0.6, 3.0, 2.0);
    for alpha in [0.0, 0.7, -2.0_f64] {
        let of = |f: f64, c: f64, d: f64, v: f64| {
            let start = Pose::at("x", 0.0).with("x'", v * alpha.cos());
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
