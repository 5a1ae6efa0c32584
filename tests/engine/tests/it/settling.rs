//! Infinitely many impacts: a ball dropped from h rests at √(2h/g) (1 + e)/(1 − e).

use liftoff::method::Dop853;
use liftoff::prelude::*;
use liftoff::{Event, EventKind};
use liftoff_fixtures::TwoBalls;

fn drop(e: f64, heights: [f64; 2], tolerance: f64) -> Vec<Event> {
    let simulation = Simulation::new(&TwoBalls { m: 1.0, e, g: 1.0, h: 1.0 }).unwrap().tolerance(tolerance);
    let pose = Pose::new("y", heights[0]).with("z", heights[1]).with("x", 0.0).with("w", 1.0);
    simulation.start(pose).unwrap().limit(20.0).run().unwrap().events().to_vec()
}

/// When a ball comes to rest.
fn settled(events: &[Event], ball: &str) -> f64 {
    let settles = |event: &&Event| event.kind == EventKind::Settle && event.supports.contains(&ball);
    events.iter().filter(settles).map(|event| event.t).next_back().unwrap()
}

/// Heights that differ by less and less: the one that settles first leaves the other alone. An end
/// is known to the bound of ten tolerances, in natural times of some seconds.
#[test]
fn independent_contacts_settle_each_at_its_time() {
    for (height, tolerance) in [(1.002, 1e-4), (1.00005, 1e-6), (1.0000005, 1e-12), (1.3, 1e-9), (1.0, 1e-9)]
    {
        let events = drop(0.8, [1.0, height], tolerance);
        for (ball, h) in [("P", 1.0), ("Q", height)] {
            let expected = f64::sqrt(2.0 * h) * 1.8 / 0.2;
            let error = (settled(&events, ball) - expected).abs();
            assert!(error < 30.0 * tolerance, "{height} {tolerance:e} {ball}: {error:e}");
        }
    }
}

/// With e = h = ½ and g = 1 the impacts come at 1, 2, 2.5, …: gaps are exactly zero at ends of
/// steps.
#[test]
fn impacts_at_round_times_are_seen() {
    for (heights, e) in [([0.5, 0.5], 0.5), ([0.5, 2.0], 0.5), ([0.5, 0.125], 0.5), ([2.0, 4.5], 0.25)] {
        let events = drop(e, heights, 1e-9);
        for (ball, h) in [("P", heights[0]), ("Q", heights[1])] {
            let expected = f64::sqrt(2.0 * h) * (1.0 + e) / (1.0 - e);
            assert!((settled(&events, ball) - expected).abs() < 1e-8, "{heights:?} {ball} {events:?}");
        }
    }
}

/// Thrown up so little that the flight is below the rounding of the gap, or below the bound of a
/// tolerance: it is back at once.
#[test]
fn flights_too_low_to_be_seen_are_over_at_once() {
    let model = TwoBalls { m: 1.0, e: 0.8, g: 1.0, h: 1.0 };
    // Slower ones rest from the start.
    for speed in [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4] {
        for tolerance in [1e-4, 1e-6, 1e-9, 1e-12] {
            let start = Pose::new("y", 0.0).with("z", 1.0).with("x", 0.0).with("w", 1.0).with("y'", speed);
            let run = Simulation::new(&model).unwrap().tolerance(tolerance).start(start).unwrap();
            let run = run.limit(1.0).run().unwrap();
            // Flights of 2 v e^k, in all 2 v/(1 - e).
            let expected = 2.0 * speed / 0.2;
            let error = (settled(run.events(), "P") - expected).abs();
            assert!(error < 1e-2 * expected + 1e-15, "{speed:e} {tolerance:e} {error:e}");
            assert!(run.events().iter().all(|e| e.state[0] > -1e-12), "{speed:e} {tolerance:e}");
        }
    }
}

/// Of many flights each lands on the floor, to rounding and not to its bound: of 1900 with e = 0.99
/// all errors are seen in the time of rest.
#[test]
fn many_flights_end_at_their_time() {
    for tolerance in [1e-6, 1e-8, 1e-9, 1e-10, 1e-12] {
        let model = TwoBalls { m: 1.0, e: 0.99, g: 1.0, h: 1.0 };
        let pose = Pose::new("y", 1.0).with("z", 0.0).with("x", 0.0).with("w", 1.0);
        let run = Simulation::new(&model).unwrap().tolerance(tolerance).method(Dop853);
        let run = run.start(pose).unwrap().limit(282.0).run().unwrap();
        let error = settled(run.events(), "P") - 199.0 * 2f64.sqrt();
        // The time is known to an ulp of 281 at each impact, and the ratio of two flights makes a
        // hundred times that of it.
        assert!(error.abs() < 1e-9, "{tolerance:e}: {error:e}");
    }
}

/// A bar on a pin, its end above a floor with friction.
#[derive(BarSystem)]
#[gravity(10)]
#[bar(OA, mass = 2.21, length = 1.36)]
#[pin(O = (-0.54, 0.62))]
#[support(A = floor(-0.14), friction = 0.14, restitution = 0.3)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0.81, 0.48))]
struct Flap {}

/// The same with a particle that it does not touch.
#[derive(BarSystem)]
#[gravity(10)]
#[bar(OA, mass = 2.21, length = 1.36)]
#[particle(P, mass = 0.9)]
#[pin(O = (-0.54, 0.62))]
#[support(A = floor(-0.14), friction = 0.14, restitution = 0.3)]
#[support(P = floor(-0.14), friction = 0.14, restitution = 0.3)]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(A = (0.81, 0.48), P = (2.3, 0.23))]
struct FlapBeside {}

/// Where the bar rests its end cannot slip: the floor bears with any friction within the cone, and
/// nothing happens to the contact. The bar falls and comes to rest as it does alone.
#[test]
fn a_bar_on_a_pin_rests_without_slip_beside_another_body_too() {
    let alone = Simulation::new(&Flap {}).unwrap().limit(2.0).run().unwrap();
    let beside = Simulation::new(&FlapBeside {}).unwrap().limit(2.0).run().unwrap();
    let told = |run: &Trajectory| {
        let own = run.events().iter().filter(|event| event.supports.contains(&"A"));
        own.map(|event| (event.t, event.kind)).collect::<Vec<_>>()
    };
    let (alone, beside) = (told(&alone), told(&beside));
    let rests = |(_, kind): &(f64, EventKind)| !matches!(kind, EventKind::Impact | EventKind::Settle);
    assert!(!alone.iter().any(rests) && alone.last().unwrap().1 == EventKind::Settle, "{alone:?}");
    assert_eq!(alone.len(), beside.len());
    for ((t, kind), other) in alone.iter().zip(&beside) {
        assert!((t - other.0).abs() < 1e-8 && *kind == other.1, "{t} {kind:?} {other:?}");
    }
}
