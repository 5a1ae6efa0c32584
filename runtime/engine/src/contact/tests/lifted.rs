//! Contacts whose reaction begins at zero, by a load that grows with a power of time.

use crate::contact::{ContactProblem, decide};
use crate::model::ContactSet;
use crate::prelude::*;
use crate::system::Model;

/// A particle on a floor, with the load that is m g at t = 0.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor)]
#[force(P = (p, w + a * t + b * t * t + c * t * t * t))]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Smooth {
    m: f64,
    l: f64,
    g: f64,
    p: f64,
    w: f64,
    a: f64,
    b: f64,
    c: f64,
}

/// The same without slip.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, rough)]
#[force(P = (p, w + a * t + b * t * t + c * t * t * t))]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Rough {
    m: f64,
    l: f64,
    g: f64,
    p: f64,
    w: f64,
    a: f64,
    b: f64,
    c: f64,
}

const M: f64 = 3.0;
const G: f64 = 9.81;

/// With N = m g − w − a t − b t² − c t³.
fn model(is_rough: bool, w: f64, [a, b, c]: [f64; 3]) -> Model {
    let (m, l, g, p) = (M, 0.1, G, 2.0);
    match is_rough {
        true => Model::new(&Rough { m, l, g, p, w, a, b, c }),
        false => Model::new(&Smooth { m, l, g, p, w, a, b, c }),
    }
}

/// The first power that is there decides: what falls opens, what rises stays, and what stays zero
/// too. So it does where the reaction was located at zero up to the error of an event.
#[test]
fn the_first_rate_that_does_not_vanish_decides() {
    let touching = ContactSet::EMPTY.with(0);
    let state = [0.1, 0.0, 0.0, 0.0, 0.0];
    for is_rough in [false, true] {
        for (powers, stays) in [
            ([0.0; 3], true),
            ([-1.0, 0.0, 0.0], true),
            ([1.0, 0.0, 0.0], false),
            ([-1.0, 5.0, 5.0], true),
            ([1.0, -5.0, -5.0], false),
            ([0.0, -1.0, 0.0], true),
            ([0.0, 1.0, 0.0], false),
            ([0.0, -1.0, 5.0], true),
            ([0.0, 1.0, -5.0], false),
            ([0.0, 0.0, -1.0], true),
            ([0.0, 0.0, 1.0], false),
        ] {
            for (error, unloaded) in
                [(0.0, ContactSet::EMPTY), (0.0, touching), (3e-10, touching), (-3e-10, touching)]
            {
                let question = ContactProblem { touching, unloaded, ..ContactProblem::default() };
                let found = decide(&model(is_rough, M * G * (1.0 + error), powers), &state, &question);
                let found =
                    found.unwrap_or_else(|failure| panic!("{is_rough} {powers:?} {error}: {failure}"));
                let expected = if stays { touching } else { ContactSet::EMPTY };
                assert_eq!(found.closed, expected, "{is_rough} {powers:?} {error}");
                assert!(found.reactions[0].abs() <= 1e-9 * M * G, "{is_rough} {powers:?} {error}");
            }
        }
    }
}

/// A load that grows with time takes the weight off a rough floor at t = m g/a, whatever rounding
/// leaves of the reaction there.
#[test]
fn a_growing_load_lifts_what_is_rough() {
    for k in 0..40 {
        let (m, a) = (M + 0.37 * f64::from(k), 1.0 + 0.11 * f64::from(k));
        let rough = Rough { m, l: 0.1, g: G, p: 2.0, w: 0.0, a, b: 0.0, c: 0.0 };
        let start = Pose::new("x", 0.1).with("y", 0.0).with("x'", 0.0).with("y'", 0.0);
        let lifts = m * G / a;
        let simulation = Simulation::new(&rough).unwrap().start(start).unwrap().limit(1.2 * lifts);
        let record = simulation.run().unwrap_or_else(|error| panic!("{k}: {error}"));
        let event = record.events().iter().find(|event| event.kind == EventKind::Open).unwrap();
        assert!((event.t / lifts - 1.0).abs() < 1e-9, "{k}: {event:?}");
    }
}
