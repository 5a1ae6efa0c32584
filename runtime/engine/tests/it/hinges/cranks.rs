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
        let start = Pose::at("phi", phi).with("phi'", rate);
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
