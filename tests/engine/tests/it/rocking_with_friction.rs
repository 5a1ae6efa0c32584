//! Sequences of impacts with friction, and sequences of such sequences: what bounces on two feet by
//! turns comes to rest.

use liftoff::method::MethodId;
use liftoff::prelude::*;

/// A body that bounces along a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, friction = mu, restitution = e)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 1))]
struct Skipping {
    m: f64,
    g: f64,
    mu: f64,
    e: f64,
}

/// A block, 2b wide and 2h high, on two feet with friction.
#[derive(BarSystem)]
#[gravity(g)]
#[body(block, points(G = (0, 0), A = (-b, -h), B = (b, -h)), mass = m, inertia = m * (b * b + h * h) / 3, centre = (0, 0))]
#[support(A = floor, friction = mu, restitution = e, tangential = e_t)]
#[support(B = floor, friction = mu, restitution = e, tangential = e_t)]
#[figure(A = (-b, 0), B = (b, 0))]
#[coordinate(x = x(G))]
#[coordinate(y = y(G))]
#[coordinate(theta = angle(block), from = right)]
struct Feet {
    m: f64,
    b: f64,
    h: f64,
    g: f64,
    mu: f64,
    e: f64,
    e_t: f64,
}

fn run(simulation: Simulation) -> Trajectory {
    simulation.run().unwrap_or_else(|error| panic!("{error}"))
}

/// All impulses together are the weight's: it slides until v₀/μg, however often it has bounced, and
/// no longer bounces from √(2h/g) (1 + e)/(1 − e) on.
#[test]
fn what_skips_along_a_floor_slows_down_by_its_weight() {
    let (g, mu, v) = (9.81, 0.2, 6.0);
    for (e, tolerance) in [(0.5, 1e-8), (0.3, 1e-10), (0.8, 1e-6)] {
        for method in MethodId::ALL {
            let body = Skipping { m: 1.3, g, mu, e };
            let pose = Pose::new("x", 0.0).with("y", 0.1).with("x'", v).with("y'", 0.0);
            let simulation = Simulation::new(&body).unwrap().start(pose).unwrap().method(method);
            let record = run(simulation.limit(4.0).tolerance(tolerance));
            let at = |kind: EventKind| record.events().iter().find(|event| event.kind == kind).expect("it");
            let (settle, stick) = (at(EventKind::Settle), at(EventKind::Stick));
            let rest = (0.2_f64 / g).sqrt() * (1.0 + e) / (1.0 - e);
            let error = 30.0 * tolerance;
            assert!((settle.t - rest).abs() < error, "{settle} {rest}");
            assert!((settle["x'"] - (v - mu * g * settle.t)).abs() < error, "{settle}");
            assert!((stick.t - v / (mu * g)).abs() < error, "{stick}");
            assert!(record.audit().is_clean(), "{:?}", record.audit());
        }
    }
}

/// The rate at which a block of unit mass strikes with its next foot, and when, after it has struck
/// with a rate ω. That foot bounces: its speeds are 2bω eᵏ, its flights 2bω eᵏ 2/g. Between, the
/// block's angular momentum about it is what the weight leaves of that before the impact, L = J ωₖ +
/// b wₖ with J = 4/3 r², wₖ the foot's speed.
fn next_strike(block: &Feet, omega: f64) -> (f64, f64) {
    let &Feet { b, h, g, e, .. } = block;
    let r_squared = b * b + h * h;
    let inertia = 4.0 / 3.0 * r_squared;
    let (mut momentum, mut speed) = ((r_squared / 3.0 + h * h - b * b) * omega, 2.0 * b * omega);
    let (mut t, mut tilt) = (0.0, 0.0);
    while speed > 1e-18 * omega {
        speed *= e;
        let flight = 2.0 * speed / g;
        tilt += (momentum - b * speed) / inertia * flight;
        momentum -= g * b * flight;
        t += flight;
    }
    let (rate, deceleration) = (momentum / inertia, g * b / inertia);
    let strikes = (rate * rate + 2.0 * deceleration * tilt).sqrt();
    (strikes, t + (rate + strikes) / deceleration)
}

/// Of a small tilt the block keeps a part of its rate from one foot to the other that does not
/// depend on it: the sequence of sequences is a geometric one.
#[test]
fn a_block_that_bounces_on_its_feet_by_turns_comes_to_rest() {
    for (b, e) in [(0.3, 0.5), (0.3, 0.2), (0.5, 0.3), (0.2, 0.7)] {
        let block = Feet { m: 2.0, b, h: 1.0, g: 9.81, mu: 3.0, e, e_t: 0.0 };
        let tilt = 1e-6_f64;
        let (s, c) = tilt.sin_cos();
        let pose = Pose::new("theta", tilt).with("x", -b + c * b - s).with("y", s * b + c);
        let record = run(Simulation::new(&block).unwrap().start(pose).unwrap().limit(1.0).tolerance(1e-12));
        let deceleration = 9.81 * b / (4.0 / 3.0 * (b * b + 1.0));
        let first = (2.0 * deceleration * tilt).sqrt();
        let (next, after) = next_strike(&block, first);
        let rest = first / deceleration + after / (1.0 - next / first);
        let settle = record.events().iter().rfind(|event| event.kind == EventKind::Settle).expect("rest");
        assert!((settle.t / rest - 1.0).abs() < 20.0 * tilt, "{b} {e}: {:e} {rest:e}", settle.t);
        assert_eq!(settle.supports, ["A", "B"], "{settle}");
        assert!(
            record.final_state()[3..].iter().all(|rate| rate.abs() < 1e-14),
            "{:?}",
            record.final_state()
        );
        assert!(record.audit().is_clean(), "{:?}", record.audit());
    }
}

/// Thrown, with restitution along the floor too, and where friction never lets it slide: all end at
/// rest, and where a tight tolerance says. When they do depends on each impact where e is large:
/// errors grow from one to the next.
#[test]
fn a_thrown_block_comes_to_rest_at_every_tolerance() {
    for (mu, e, e_t) in
        [(50.0, 0.1902, 0.5), (50.0, 0.5, 0.5), (0.5, 0.8, 0.0), (0.2, 0.5, 0.5), (0.5, 0.0, 0.0)]
    {
        let block = Feet { m: 0.93876, b: 0.90158, h: 1.78686, g: 9.81, mu, e, e_t };
        let low = 0.1_f64.sin() * block.b + 0.1_f64.cos() * block.h;
        let rest = |tolerance: f64| {
            let pose = Pose::new("theta", 0.1).with("x", 0.0).with("y", low + 0.2).with("x'", 1.0);
            let pose = pose.with("y'", 0.0).with("theta'", 0.0);
            let record =
                run(Simulation::new(&block).unwrap().start(pose).unwrap().limit(30.0).tolerance(tolerance));
            assert!(record.final_state()[3..].iter().all(|rate| rate.abs() < 1e-12), "{mu} {e} {tolerance}");
            record.final_state()[1]
        };
        let place = rest(1e-11);
        for tolerance in [1e-6, 1e-8] {
            let error = rest(tolerance) - place;
            assert!(error.abs() < 300.0 * tolerance, "{mu} {e} {tolerance}: {error:e}");
        }
    }
}
