//! A light rod with a heavy end, by its other end: three coordinates of what is nearly a particle.

use super::{are_determined, refuse_singular, singular};
use crate::contact::ContactError;
use crate::model::ContactSet;
use crate::prelude::*;
use crate::system::Model;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[mass(B, heavy)]
#[support(A = floor)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (0.6 * l, 0.8 * l))]
struct Loaded {
    m: f64,
    heavy: f64,
    l: f64,
    g: f64,
}

fn model(part: f64, heavy: f64, l: f64) -> Model {
    Model::new(&Loaded { m: part * heavy, heavy, l, g: 9.81 })
}

/// With ε = m/M of the balanced mass matrix det M = 1 − (1 + ε/2)²/((1 + ε)(1 + ε/3)) ≈ ε/3 at any
/// angle, in any units.
#[test]
fn accelerations_are_determined_by_a_determinant() {
    for (heavy, l) in [(1.0, 1.0), (3e-6, 2e4), (7e8, 1e-5)] {
        for (part, expected) in [(1.0, true), (3.3e-6, true), (2.7e-6, false), (1e-9, false)] {
            for theta in [0.3, 1.5, -2.0] {
                let state = [theta, 0.1 * l, 0.0, 0.4, 0.0, 0.0];
                let found = are_determined(&*model(part, heavy, l).system, &state);
                assert_eq!(found, expected, "{heavy} {part} {theta}");
            }
        }
    }
}

/// A turn about the heavy end moves next to no mass: the rod's angle and its light end are
/// undetermined, the latter only across the rod. The floor does not hold it where it is upright.
#[test]
fn massless_coordinates_are_named() {
    let (level, upright) = (0.0, core::f64::consts::FRAC_PI_2);
    let model = model(1e-16, 2.0, 0.5);
    let touching = ContactSet::EMPTY.with(0);
    for (theta, closed, expected) in [
        (level, ContactSet::EMPTY, vec!["theta", "y"]),
        (upright, ContactSet::EMPTY, vec!["theta", "x"]),
        (upright, touching, vec!["theta", "x"]),
        (level, touching, vec![]),
    ] {
        let state = [theta, 0.0, 0.0, 0.0, 0.0, 0.0];
        let sorted = |error: ContactError| match error {
            ContactError::Singular { mut coordinates, contacts, .. } => {
                coordinates.sort();
                assert_eq!(contacts.len(), closed.len());
                coordinates
            }
            other => panic!("{other}"),
        };
        let refused = refuse_singular(&model, &state, closed).err().map(sorted).unwrap_or_default();
        assert_eq!(refused, expected, "{theta}");
        assert_eq!(sorted(singular(&model, &state, closed)), expected, "{theta}");
    }
    // What is no number is told as that.
    let state = [level, 0.0, 0.0, 1e200, 0.0, 0.0];
    assert_eq!(refuse_singular(&model, &state, touching), Err(ContactError::NotFinite));
}
