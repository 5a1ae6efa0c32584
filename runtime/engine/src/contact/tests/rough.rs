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

/// The rod turns about its end, N = m (g − ¾ g cos²θ − ½ l ω² sin θ) = 0. As N rises it goes on so; as N falls the end would have to
/// leave the floor, which the rest of the motion, ÿ = −¾ g cos²θ without the force across, presses on.
#[test]
fn a_rough_contact_without_reaction_stays_while_that_rises() {
    let (m, l, g) = (2.0, 0.5, 9.81);
    let model = Model::of(&RoughRod { m, l, g });
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
