//! Slider-cranks with friction in the guide and in a hinge.

use liftoff::prelude::*;

use crate::friction::run;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = p, length = k)]
#[pin(O = (0, 0))]
#[slider(B = horizontal(0), friction = mu)]
#[hinge(A, friction = nu, radius = r)]
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
    g: f64,
}

/// Cranks with their starts, by a generator of its own.
fn cranks() -> impl Iterator<Item = (Crank, [f64; 2])> {
    let mut seed = 3_u64;
    let mut between = move |low: f64, high: f64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..30).map(move |_| {
        let [m, p] = [between(0.5, 2.0), between(0.3, 2.0)];
        let [l, k] = [between(0.2, 0.5), between(0.7, 1.5)];
        let [mu, nu, r] = [between(0.05, 0.5), between(0.05, 0.5), between(0.005, 0.03)];
        let start = [between(-3.0, 3.0), between(-15.0, 15.0)];
        (Crank { m, p, l, k, mu, nu, r, g: 9.81 }, start)
    })
}

/// The reaction of the guide changes its side where it vanishes, and is on the new side afterwards.
#[test]
fn guides_beside_hinges_change_their_sides() {
    let mut sides = 0;
    for (crank, [phi, rate]) in cranks() {
        let start = Pose::new("phi", phi).with("phi'", rate);
        let record = run(Simulation::new(&crank).unwrap().start(start).unwrap().limit(2.0));
        let normal = record.function("N(B)").unwrap();
        let events = record.events();
        for (before, pair) in events.iter().zip(events.windows(2).skip(1)) {
            let [event, next] = pair else { continue };
            if event.kind == EventKind::Side && before.t < event.t && event.t < next.t {
                let [gone, new] = [before.t, next.t].map(|t| normal(0.5 * (event.t + t)));
                assert!(gone * new < 0.0, "{} {gone} {new}", event.t);
                sides += 1;
            }
        }
        let energy = record.function("E + D").unwrap();
        let size = record.function("T").unwrap()(0.0).max(1.0);
        assert!((energy(2.0) - energy(0.0)).abs() < 1e-8 * size, "{}", energy(2.0) - energy(0.0));
    }
    assert!(sides > 20, "{sides}");
}

/// A slider-crank with friction in its guide and in both hinges, which a couple turns to and fro.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = p, length = k)]
#[pin(O = (0, 0))]
#[slider(B = horizontal(0), friction = mu)]
#[hinge(A, friction = 10 * mu, radius = r)]
#[pin(O, friction = mu, radius = b)]
#[couple(OA = c * sin(w * t))]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0, l), B = (sqrt(k * k - l * l), 0))]
struct Swayed {
    m: f64,
    p: f64,
    l: f64,
    k: f64,
    mu: f64,
    r: f64,
    b: f64,
    c: f64,
    w: f64,
    g: f64,
}

/// At rest one of three frictions more than enough holds it, and their shares are not determined:
/// none bears beyond its limit, and it goes on again where all of them are at theirs, whatever the
/// method and the tolerance.
#[test]
fn what_hinges_and_a_guide_hold_together_obeys_all_their_limits() {
    use liftoff::method::MethodId::{Auto, Dop853, Radau};
    let swayed =
        Swayed { m: 1.0, p: 1.2, l: 0.3, k: 1.0, mu: 1.0, r: 0.003, b: 0.02, c: 5.0, w: 4.0, g: 9.81 };
    let mut starts = Vec::new();
    for (method, tolerance) in [(Auto, 1e-10), (Dop853, 1e-11), (Radau, 1e-9)] {
        let start = Pose::new("phi", 0.6318828667133107).with("phi'", 1.0);
        let simulation = Simulation::new(&swayed).unwrap().start(start).unwrap().method(method);
        let record = run(simulation.tolerance(tolerance).limit(1.0));
        let at = ["R(A)/N(A)", "R(B)/N(B)", "R(O)/N(O)", "phi'"].map(|text| record.function(text).unwrap());
        for k in 1..200 {
            let t = f64::from(k) / 200.0;
            for (ratio, limit) in at[..3].iter().zip([10.0, 1.0, 1.0]) {
                assert!(ratio(t).abs() <= limit * (1.0 + 1e-6), "{method:?} {tolerance} {t}: {}", ratio(t));
            }
        }
        let slips = |event: &&Event| event.kind == EventKind::Slip && event.t > 0.7;
        let last = record.events().iter().rfind(slips).map(|event| event.t);
        assert!(at[3](0.99) < -0.1, "{method:?} {tolerance}");
        starts.push(last.unwrap_or_else(|| panic!("{method:?} {:?}", record.events())));
    }
    assert!(starts.iter().all(|t| (t - starts[0]).abs() < 1e-7), "{starts:?}");
}
