//! A ladder, a slider-crank and a pair of bodies, whose guides obey the laws of motion and
//! friction.

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_core::model::Form;

use crate::friction::run;

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

/// Newton's and Euler's equations of the whole, with the forces at the ends as they are told;
/// Coulomb's law with |N|; the energy. The bar swings through its lowest position, so that both
/// ends change their sides.
#[test]
fn an_ellipsograph_obeys_the_laws_of_motion_and_friction() {
    let (m, l, g, mu, nu) = (1.2, 0.8, 9.81, 0.1, 0.15);
    let model = Ellipsograph { m, l, g, mu, nu, nu_s: 0.2 };
    let start = Pose::new("theta", 0.9).with("theta'", 0.0);
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
        // The normals are a quarter turn from the guides: up for A; to the left for B, whose guide
        // points up.
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

/// Every method and both forms see the same events.
#[test]
fn all_methods_and_forms_agree_on_guides() {
    let model = Ellipsograph { m: 1.2, l: 0.8, g: 9.81, mu: 0.1, nu: 0.15, nu_s: 0.2 };
    let start = || Pose::new("theta", 0.9).with("theta'", 0.0);
    let simulation = || Simulation::new(&model).unwrap().start(start()).unwrap().limit(6.0).tolerance(1e-11);
    let expected = run(simulation());
    let forms = [Form::Reduced, Form::Multipliers].map(|form| simulation().form(form));
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

/// Momentum and angular momentum stay, and T + D; N is across the bar and R along it on the
/// particle, |R| = μ |N| against the slip.
#[test]
fn sliders_on_a_free_bar_conserve_momentum() {
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
        let pose = Pose::new("theta", 0.0).with("theta'", turn).with("x", 0.0).with("y", 0.0).with("x'", 0.0);
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
