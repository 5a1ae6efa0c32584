//! Impacts that accumulate at two contacts at once, and corners that a bar does not reach.

use liftoff::prelude::*;

/// A ball bounces in a groove of two slopes.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(left = slope(-a), under = P, restitution = e)]
#[support(right = slope(b), under = P, restitution = e)]
#[figure(P = (0, 1))]
struct Groove {
    m: f64,
    a: f64,
    b: f64,
    e: f64,
    g: f64,
}

/// It comes to rest at the bottom, however the flights between the slopes disturb one another, and
/// bears its weight there.
#[test]
fn a_ball_comes_to_rest_in_a_groove() {
    for (a, b) in [(0.6, 0.6), (0.9, 0.3)] {
        for e in [0.0, 0.3, 0.5, 0.8] {
            let groove = Groove { m: 2.0, a, b, e, g: 9.81 };
            let start = Pose::new("x_P", 0.05).with("y_P", 1.0);
            let run = Simulation::new(&groove).unwrap().start(start).unwrap().limit(60.0).run().unwrap();
            let end = run.final_state();
            assert!(end.iter().all(|x| x.abs() < 1e-10), "{a} {b} {e}: {end:?}");
            let weight =
                Output::parse(Groove::LAYOUT, "(N(left) * cos(a) + N(right) * cos(b)) / (m * g)").unwrap();
            assert!((run.value(&weight, 60.0) - 1.0).abs() < 1e-12, "{a} {b} {e}");
        }
    }
}

/// A bar on one corner, with another beside it.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(K = corner(0, 0), under = AB)]
#[support(J = corner(w, 0), under = AB)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(phi = angle(AB), from = right)]
struct Tipping {
    m: f64,
    l: f64,
    w: f64,
    g: f64,
}

/// Level on K alone, its centre outside, it tips at once: φ̈ = −12 d g/(l² + 12 d²) at the distance
/// d.
#[test]
fn a_bar_that_ends_before_a_corner_is_not_on_it() {
    let bar = Tipping { m: 1.0, l: 1.0, w: 0.3, g: 10.0 };
    let start = Pose::new("x", -0.8).with("y", 0.0).with("phi", 0.0);
    let run = Simulation::new(&bar).unwrap().start(start).unwrap().until("t = 0.01").unwrap().run().unwrap();
    assert_eq!(run.segments()[0].closed, ["K"]);
    let turn = run.value(&Output::parse(Tipping::LAYOUT, "phi''").unwrap(), 0.0);
    let d: f64 = 0.3;
    assert!((turn - 12.0 * d * 10.0 / (1.0 + 12.0 * d * d)).abs() < 1e-12, "{turn}");
}
