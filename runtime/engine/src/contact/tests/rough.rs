//! A rough contact without a normal reaction.

use crate::contact::{ContactError, ContactProblem, decide};
use crate::model::ContactSet;
use crate::prelude::*;
use crate::system::Model;

/// A rod on its rough lower end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, rough)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (0.6 * l, 0.8 * l))]
struct RoughRod {
    m: f64,
    l: f64,
    g: f64,
}

/// The rod turns about its end, N = m (g − ¾ g cos²θ − ½ l ω² sin θ) = 0. As N rises it goes on so;
/// as N falls the end would have to leave the floor, which the rest of the motion, ÿ = −¾ g cos²θ
/// without the force across, presses on.
#[test]
fn a_rough_contact_without_reaction_stays_while_that_rises() {
    let (m, l, g) = (2.0, 0.5, 9.81);
    let model = Model::new(&RoughRod { m, l, g });
    for theta in [0.7_f64, 1.2, 2.1] {
        let (sine, cosine) = theta.sin_cos();
        let rate = (2.0 * g * (1.0 - 0.75 * cosine * cosine) / (l * sine)).sqrt();
        for rate in [rate, -rate] {
            let state = [theta, 0.0, 0.0, rate, 0.0, 0.0];
            // dN/dt = m g ω cos θ (9 sin²θ − 1) / 4 sin θ.
            let rises = rate * cosine * (9.0 * sine * sine - 1.0) > 0.0;
            let touching = ContactSet::EMPTY.with(0);
            for unloaded in [ContactSet::EMPTY, touching] {
                let question = ContactProblem { touching, unloaded, ..ContactProblem::default() };
                match decide(&model, &state, &question) {
                    Ok(found) => {
                        assert!(rises && found.closed == touching && found.unique, "{theta} {rate}");
                        assert!(
                            found.reactions[0].abs() < 1e-13 * m * g,
                            "{theta} {rate} {:?}",
                            found.reactions
                        );
                    }
                    Err(error) => assert!(!rises && matches!(error, ContactError::Jammed { .. }), "{error}"),
                }
            }
        }
    }
}

/// A rod with two rough ends.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, rough)]
#[support(B = floor, rough)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (l, 0))]
struct RodOnRoughEnds {
    m: f64,
    l: f64,
    g: f64,
}

/// The same of either end, the other one above the floor; and what it bears where N = m (g − ¾ g
/// cos²θ − ½ l ω² sin θ) is not zero.
#[test]
fn each_rough_contact_holds_its_own_tangent() {
    let (m, l, g) = (2.0, 0.5, 9.81);
    let model = Model::new(&RodOnRoughEnds { m, l, g });
    for end in [0, 1] {
        for theta in [0.7_f64, 1.2, 2.1] {
            let (sine, cosine) = theta.sin_cos();
            let touching = ContactSet::EMPTY.with(end);
            let decided = |rate: f64, unloaded: ContactSet| {
                // About B the rod is turned by half a turn, and A moves.
                let state = match end {
                    0 => [theta, 0.0, 0.0, rate, 0.0, 0.0],
                    _ => [
                        theta + core::f64::consts::PI,
                        l * cosine,
                        l * sine,
                        rate,
                        -l * sine * rate,
                        l * cosine * rate,
                    ],
                };
                decide(&model, &state, &ContactProblem { touching, unloaded, ..ContactProblem::default() })
            };
            let zero = (2.0 * g * (1.0 - 0.75 * cosine * cosine) / (l * sine)).sqrt();
            for part in [0.0, 0.5] {
                let found = decided(part * zero, ContactSet::EMPTY).unwrap();
                let normal = m * g * (1.0 - 0.75 * cosine * cosine) * (1.0 - part * part);
                assert!(found.closed == touching && found.unique, "{end} {theta}");
                assert!((found.reactions[end] - normal).abs() < 1e-12 * m * g, "{end} {theta} {part}");
            }
            for rate in [zero, -zero] {
                let rises = rate * cosine * (9.0 * sine * sine - 1.0) > 0.0;
                for unloaded in [ContactSet::EMPTY, touching] {
                    match decided(rate, unloaded) {
                        Ok(found) => assert!(rises && found.closed == touching, "{end} {theta} {rate}"),
                        Err(error) => {
                            assert!(!rises && matches!(error, ContactError::Jammed { .. }), "{error}");
                        }
                    }
                }
            }
        }
    }
}
