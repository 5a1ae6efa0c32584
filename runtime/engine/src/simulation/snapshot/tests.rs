//! What is known of a run at one moment.

use super::PendingFlight;
use crate::event::{FrictionGuard, Guard, Note};
use crate::model::{ContactSet, Slip};
use crate::prelude::*;
use crate::simulation::tests::given::*;

/// A reaction is as good as zero within a part of the largest one, in any units.
#[test]
fn the_bound_of_a_reaction_is_a_part_of_the_largest_one() {
    let bound = |m: f64| {
        let mut found = 0.0;
        with_begun(&start(&Ball { m, ..BALL }, [0.0, 0.0, 3.0, 0.0]), |ball, _| {
            let (reactions, bound) = ball.reactions_at(&ball.state, set(FLOOR));
            assert_eq!(reactions[FLOOR], 10.0 * m);
            assert_eq!(bound, ball.relative_bound() * 10.0 * m);
            found = bound;
        });
        found
    };
    assert_eq!(bound(2e3), 1e3 * bound(2.0));
}

/// The time of a late event is known to its rounding, and its place to what the motion goes in
/// that.
#[test]
fn late_places_are_known_to_the_rounding_of_the_time() {
    with_start(&start(&BALL, [0.0, 1.0, 3.0, 0.0]), |mut ball| {
        assert_eq!(ball.relative_bound(), 1e-11);
        ball.t = 1e9;
        // Lengths are measured in its own metre.
        assert_eq!(ball.relative_bound(), 2.0 * f64::EPSILON * 1e9 * 3.0);
    });
}

/// A foot at the end of its bar is known to a part of the bar's length.
#[test]
fn a_foot_within_its_bound_is_beyond_the_end() {
    let bar = Overhang { m: 1.0, l: 1e3, g: 10.0 };
    for (inside, is_beyond) in [(1e-9, true), (1e-7, false)] {
        let pose = Pose::new("x", -inside).with("y", 1.0).with("theta", 0.0);
        with_start(&Simulation::new(&bar).unwrap().start(pose).unwrap(), |now| {
            assert_eq!(!now.find_beyond_end().is_empty(), is_beyond, "{inside}");
        });
    }
}

/// ġ²/2g above the floor, a part of its gap or not.
#[test]
fn a_flight_rises_by_the_square_of_its_speed() {
    for (y, v) in [(0.0, 1e-8), (1e-12, 1e-7)] {
        with_begun(&start(&BALL, [1.0, y, 0.0, v]), |ball, _| {
            let [PendingFlight { contact, rate, fall, height, .. }] = ball.find_rising()[..] else {
                panic!()
            };
            assert_eq!((contact, rate, fall), (FLOOR, v, 10.0));
            let expected = y + v * v / 20.0;
            assert!((height / expected - 1.0).abs() < 1e-14, "{height} {expected}");
        });
    }
}

/// Within the bound of its gap a start is followed from the height that is given, up or down.
#[test]
fn low_flights_at_a_start_have_one_height_each() {
    let gap = 1e-9;
    for (v, height) in [(-1e-3, gap), (1e-3, gap + 1e-6 / 20.0)] {
        let low = start(&BALL, [1.0, gap, 0.0, v]).tolerance(1e-9);
        with_start(&low, |ball| {
            let [(contact, found)] = ball.find_low_flights()[..] else { panic!("{v}") };
            assert!(contact == FLOOR && (found / height - 1.0).abs() < 1e-12, "{found} {height}");
        });
    }
    // What has begun to bounce keeps its height, and what rose beside other contacts is forgotten.
    with_begun(&start(&BALL, [0.0, 0.0, 0.0, 3e-6]), |mut ball, _| {
        let [rise] = ball.find_rising()[..] else { panic!() };
        ball.onset.risen = Some((set(FLOOR), vec![PendingFlight { height: 0.75, ..rise }]));
        assert_eq!(ball.find_low_flights(), [(FLOOR, rise.height)]);
        ball.onset.risen = Some((ContactSet::EMPTY, vec![PendingFlight { height: 0.75, ..rise }]));
        assert_eq!(ball.find_low_flights(), [(FLOOR, 0.75)]);
        ball.bounces.heights = vec![(FLOOR, 0.5)];
        assert_eq!(ball.find_low_flights(), [(FLOOR, 0.5)]);
    });
}

/// The reaction of an end that slides moves the mass m/(1 + 3 cos² θ + 3 σ μ sin θ cos θ).
#[test]
fn a_reaction_is_measured_by_the_mass_that_it_moves() {
    let Rod { m, l, g, mu } = Rod { m: 2.0, l: 3.0, g: 10.0, mu: 0.25 };
    for (theta, slip) in [(1.0_f64, 1.0), (1.0, -1.0), (2.0, 1.0), (0.5, 0.0)] {
        let pose = Pose::new("theta", theta).with("y", 0.0).with("x'", slip).with("theta'", 0.0);
        let rod = Simulation::new(&Rod { m, l, g, mu }).unwrap().start(pose).unwrap();
        with_begun(&rod, |mut now, _| {
            now.reactions.fill(0.0);
            let (s, c) = theta.sin_cos();
            let sigma = now.closed().sense(0) as f64;
            let own = m / (1.0 + 3.0 * c * c + 3.0 * sigma * mu * s * c);
            let moved = own.min(m / (1.0 + mu * sigma.abs()));
            let [found] = now.forces()[..] else { panic!() };
            assert!((found / (moved * g) - 1.0).abs() < 1e-12, "{theta} {slip}: {found}");
        });
    }
}

/// Of a sled that stops each foot has its own friction force, within its limit; both are at rest.
#[test]
fn feet_that_stop_have_their_own_forces() {
    let sled = Sled { m: 3.0, l: 1.0, g: 10.0, mu: 0.25, e: 0.0 };
    let pose = Pose::new("x'", 1.0).with("y", 0.0).with("theta", 0.0);
    with_begun(&Simulation::new(&sled).unwrap().start(pose).unwrap(), |mut now, start| {
        assert!(now.closed().contains(0) && now.closed().contains(1));
        let rub = |contact: usize| FrictionGuard {
            contact,
            friction: contact,
            slip: Slip::Forward,
            side: now.closed().side(contact),
        };
        let guards = [0, 1].map(|contact| Guard::Slip(rub(contact)));
        now.state.fill(0.0);
        now.handle(&guards, start).unwrap();
        let Some(Note::Friction(states)) = &now.transition.events[1].note else { panic!() };
        for (state, normal) in states.iter().zip([20.0, 10.0]) {
            assert!((state.normal - normal).abs() < 1e-12, "{state:?}");
            assert!(state.force.abs() <= state.limit * normal + 1e-12, "{state:?}");
        }
        assert!(states.len() == 2 && (states[0].force + states[1].force).abs() < 1e-12);
    });
}
