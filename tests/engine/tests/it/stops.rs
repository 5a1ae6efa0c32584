//! Stops beside friction: what rests against one may be held by either.

use liftoff::prelude::*;

/// A slide with dry friction that rests against a stop; a growing force pulls it away.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[support(guide = floor, under = P, friction = mu)]
#[support(stop = wall(0), under = P, facing = right)]
#[force(P = (c * t - d, -n))]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Slide {
    m: f64,
    mu: f64,
    n: f64,
    c: f64,
    d: f64,
}

/// Where the stop no longer bears, at t = d/c, friction holds, up to μ n; then m ẍ = c t − d − μ n.
#[test]
fn friction_takes_over_from_a_stop() {
    let model = Slide { m: 2.0, mu: 0.5, n: 2.0, c: 1.0, d: 0.5 };
    let start = Pose::new("x", 0.0).with("y", 0.0).with("x'", 0.0);
    let run = Simulation::new(&model).unwrap().start(start).unwrap().limit(3.0).run().unwrap();
    let slips: Vec<_> = run.events().iter().filter(|event| event.kind == EventKind::Slip).collect();
    assert_eq!(slips.len(), 1);
    assert!((slips[0].t - 1.5).abs() < 1e-9, "{}", slips[0].t);
    let [x, stop] = ["x", "N(stop)"].map(|text| run.output(text).unwrap());
    assert_eq!(run.value(&x, 1.4), 0.0);
    assert!((run.value(&x, 3.0) - 1.5f64.powi(3) / 12.0).abs() < 1e-9);
    for t in [0.1, 0.4, 0.6, 1.0, 1.4] {
        assert!(run.value(&stop, t) >= 0.0, "{t}");
    }
}

/// A valve between two stops, pushed to and fro under dry friction.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[weld(AB, angle = 0)]
#[point(C = AB, at = (l / 2, 0))]
#[support(C = floor(0), friction = mu, static = limit)]
#[support(A = wall(-d), facing = right, restitution = e)]
#[support(B = wall(l + d), facing = left, restitution = e)]
#[force(push = (f * sin(w * t) + k, 0), at = A)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[figure(A = (0, 0), B = (l, 0))]
struct Valve {
    g: f64,
    m: f64,
    l: f64,
    d: f64,
    mu: f64,
    limit: f64,
    e: f64,
    f: f64,
    w: f64,
    k: f64,
}

/// Its parameters over their ranges, by the fractions of multiples of square roots.
fn valve(number: u32) -> Valve {
    let unit = |prime: f64| (f64::from(number) * prime.sqrt()).fract();
    let between = |prime: f64, [low, high]: [f64; 2]| low + (high - low) * unit(prime);
    let decades = |prime: f64, range: [f64; 2]| 10f64.powf(between(prime, range));
    let (g, m, mu) = (9.81, decades(2.0, [-1.0, 1.0]), between(3.0, [0.05, 0.6]));
    let f = m * g * mu * between(5.0, [0.9, 6.0]);
    Valve {
        g,
        m,
        l: between(7.0, [0.1, 2.0]),
        d: decades(11.0, [-2.0, 0.0]),
        mu,
        limit: mu * between(13.0, [1.0, 1.5]),
        e: [0.0, unit(17.0), 1.0][number as usize % 3],
        f,
        w: decades(19.0, [-0.5, 1.5]),
        k: [0.0, f * between(23.0, [-0.5, 0.5])][number as usize % 2],
    }
}

/// At the default tolerance its energy raises no alarm, and nothing holds up its events.
#[test]
fn a_valve_alternates_between_its_stops() {
    for number in 1..=60 {
        let model = valve(number);
        let limit = 12.0 * core::f64::consts::TAU / model.w;
        let start = Pose::new("x", 0.0).with("y", 0.0).with("x'", 0.0);
        let run = Simulation::new(&model).unwrap().start(start).unwrap().limit(limit).run();
        let run = run.unwrap_or_else(|error| panic!("{number}: {error}"));
        let audit = run.audit();
        assert!(audit.is_clean(), "{number}: {audit:?}");
    }
}
