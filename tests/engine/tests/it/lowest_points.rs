//! Gaps that are stationary where they touch: a point on its floor where it is lowest, whose gap
//! opens whichever way it moves, so that the floor holds nothing, and gaps that are greatest, which
//! no finite reaction holds.

#![allow(clippy::duplicated_attributes, reason = "two bars may be as long as each other")]

use core::f64::consts::FRAC_PI_2;

use liftoff::prelude::*;

/// A bar hangs by its end down to the floor, and a couple turns it.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[support(A = floor(-l), restitution = e)]
#[couple(OA = c)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0, -l))]
struct Hanging {
    m: f64,
    l: f64,
    c: f64,
    e: f64,
}

/// φ̈ = 3 c / m l² from rest, from the lowest point and beside it, up to where the gap is seen to
/// be open.
#[test]
fn a_bar_hanging_to_the_floor_swings() {
    for (m, l) in [(1.0, 1.0), (3.0, 1e-3), (1e-4, 1e5)] {
        for delta in [0.0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-6, 1e-5, 1.4e-5, 1e-4, 1e-3] {
            for (start, c) in [(delta, -2.0), (-delta, -2.0), (delta, 2.0)] {
                let bar = Hanging { m, l, c: c * m * l * l, e: 0.5 };
                let pose = Pose::new("phi", start - FRAC_PI_2);
                let run = Simulation::new(&bar).unwrap().start(pose).unwrap().limit(0.3).run();
                let run = run.unwrap_or_else(|error| panic!("{l} {start:e} {c}: {error}"));
                let phi = run.value(&Output::parse(run.layout(), "phi").unwrap(), 0.3);
                let right = start - FRAC_PI_2 + 0.5 * 3.0 * c * 0.3 * 0.3;
                assert!((phi - right).abs() < 1e-9, "{l} {start:e} {c}: {phi} for {right}");
            }
        }
    }
}

/// Through its lowest point at a rate the floor has nothing to hold either.
#[test]
fn a_bar_swings_past_its_lowest_point() {
    for rate in [1e-6, 1e-3, 1.0, 30.0] {
        let bar = Hanging { m: 1.0, l: 1.0, c: 0.0, e: 0.5 };
        let pose = Pose::new("phi", -FRAC_PI_2).with("phi'", rate);
        let run = Simulation::new(&bar).unwrap().start(pose).unwrap().limit(1.0).run().unwrap();
        let phi = run.value(&Output::parse(run.layout(), "phi").unwrap(), 1.0);
        assert!((phi - (rate - FRAC_PI_2)).abs() < 1e-9, "{rate}: {phi}");
    }
}

/// Two bars in a line, the lower end on the floor: pushed aside at the knee they swing as they
/// would without a floor.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(1)]
#[bar(OA, mass = 1, length = 1)]
#[bar(AB, mass = 1, length = 1)]
#[pin(O = (0, 0))]
#[support(B = floor(-2 - low))]
#[force(push = (2, 0), at = A)]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
#[figure(A = (0, -1), B = (0, -2))]
struct Line {
    low: f64,
}

#[test]
fn bars_hanging_in_a_line_swing_as_without_a_floor() {
    let end = |low: f64| {
        let line = Line { low };
        let run = Simulation::new(&line).unwrap().start(Pose::new("phi", 0.0).with("psi", 0.0)).unwrap();
        let run = run.limit(0.4).run().unwrap_or_else(|error| panic!("{low}: {error}"));
        ["phi", "psi", "phi'", "psi'"].map(|name| run.value(&Output::parse(run.layout(), name).unwrap(), 0.4))
    };
    for (held, free) in end(0.0).iter().zip(end(1.0)) {
        assert!((held - free).abs() < 1e-9, "{held} {free}");
    }
}

/// A parallelogram whose coupler is at its lowest: along the joints its gap opens either way,
/// though its row is not zero.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[bar(OA, mass = 1, length = 1)]
#[bar(AB, mass = 1, length = 2)]
#[bar(CB, mass = 1, length = 1)]
#[pin(O = (0, 0))]
#[pin(C = (2, 0))]
#[support(B = floor(-1 - low))]
#[couple(OA = 3)]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = right)]
#[coordinate(chi = angle(CB), from = down)]
#[figure(A = (0, -1), B = (2, -1))]
struct Coupler {
    low: f64,
}

#[test]
fn a_coupler_at_its_lowest_swings_as_without_a_floor() {
    let end = |low: f64| {
        let pose = Pose::new("phi", 0.0).with("psi", 0.0);
        let run = Simulation::new(&Coupler { low }).unwrap().start(pose).unwrap().limit(0.5).run();
        let run = run.unwrap_or_else(|error| panic!("{low}: {error}"));
        ["phi", "phi'"].map(|name| run.value(&Output::parse(run.layout(), name).unwrap(), 0.5))
    };
    // (2/3 + 1) φ̈ = 3.
    let [phi, rate] = end(0.0);
    assert!((phi - 0.5 * 1.8 * 0.25).abs() < 1e-9 && (rate - 0.9).abs() < 1e-9, "{phi} {rate}");
    assert!((end(1.0)[0] - phi).abs() < 1e-9);
}

/// Where its gap is greatest a floor is not left: an upright bar at a floor of its own height
/// stays.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(1)]
#[bar(OA, mass = 1, length = 1)]
#[pin(O = (0, 0))]
#[support(A = floor(1))]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0, 1))]
struct Upright {}

#[test]
fn a_floor_at_the_greatest_height_is_not_passed() {
    for delta in [0.0, 1e-15, 1e-9, 1e-7] {
        let pose = Pose::new("phi", FRAC_PI_2 - delta);
        let run = Simulation::new(&Upright {}).unwrap().start(pose).unwrap().limit(20.0).run();
        let phi = run.map(|run| run.value(&Output::parse(run.layout(), "phi").unwrap(), 20.0));
        assert!(phi.as_ref().is_ok_and(|phi| (phi - FRAC_PI_2).abs() < 1e-5) || phi.is_err(), "{phi:?}");
    }
}

/// A thread along a hanging bar, from a point between its ends: no other position is allowed. The
/// thread's row is zero, so that no tension holds a couple.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(1)]
#[bar(OA, mass = 1, length = 1)]
#[pin(O = (0, 0))]
#[ground(C = (0, -0.25))]
#[thread(t = C -> A, length = 0.75)]
#[couple(OA = c)]
#[particle(P, mass = 1)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0, -1), P = (3, 0))]
struct AlongThread {
    c: f64,
}

#[test]
fn a_couple_on_a_bar_along_a_thread_is_jammed() {
    let pose = || Pose::new("phi", -FRAC_PI_2).with("x_P", 3.0).with("y_P", 0.0);
    for c in [-1.0, -1e-3, 1e-3, 1.0, 1e3] {
        let model = AlongThread { c };
        let run = Simulation::new(&model).unwrap().start(pose()).unwrap().limit(1.0).run();
        let error = run.expect_err("no reaction is finite").to_string();
        assert!(error.contains("jammed") && error.contains('t'), "{c}: {error}");
    }
    // Without a couple it hangs, and its thread bears nothing.
    let run = Simulation::new(&AlongThread { c: 0.0 }).unwrap().start(pose()).unwrap().limit(1.0).run();
    let run = run.unwrap();
    for (name, right) in [("phi", -FRAC_PI_2), ("y_P", -0.5), ("N(t)", 0.0)] {
        let value = run.value(&Output::parse(run.layout(), name).unwrap(), 1.0);
        assert!((value - right).abs() < 1e-9, "{name} {value}");
    }
}
