//! A single contact decided in closed form, against the decision of any number of contacts.

use super::super::single;
use super::super::{Sense, Slip as KnownSlip};
use super::random::Random;
use crate::contact::{ContactProblem, decide};
use crate::integration::phase_point::RunContext;
use crate::model::ContactSet;
use crate::prelude::*;
use crate::scales::scales_of;
use crate::system::Model;

/// A rod on a rough slope, pulled at its other end, which does not reach a wall far away.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[force(B = (p, q))]
#[support(B = wall(far), facing = right, friction = 0.3)]
#[support(A = slope(alpha), friction = mu, static = mu_s)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (0.6 * l, 0.8 * l))]
struct Pulled {
    m: f64,
    l: f64,
    g: f64,
    p: f64,
    q: f64,
    alpha: f64,
    far: f64,
    mu: f64,
    mu_s: f64,
}

/// Where the closed form decides at all it decides alike, and nothing else may follow; it does so of nearly all states but those
/// of Painlevé's paradox and between the cones.
#[test]
fn a_single_contact_is_decided_alike() {
    let mut random = Random(0x51_1e);
    let (mut decided, mut kinds) = (0, [0; 3]);
    for _ in 0..4000 {
        let mu = random.between(0.0, 2.0);
        let mu_s = mu * [1.0, random.between(1.0, 1.5)][random.below(2)];
        let [p, q] = [0.0; 2].map(|_| random.between(-12.0, 12.0));
        let alpha = random.between(-1.0, 1.0);
        let rod = Pulled { m: 1.0, l: 1.0, g: 9.81, p, q, alpha, far: -9.0, mu, mu_s };
        let model = Model::from(&rod);
        let scales = scales_of(&model).unwrap();
        let context = RunContext { model, scales, switches: Vec::new() };
        let senses = [KnownSlip::Forward, KnownSlip::Backward, KnownSlip::Rest, KnownSlip::Rest];
        let known = senses[random.below(4)];
        let speed = match known {
            KnownSlip::Forward => random.between(0.1, 2.0),
            KnownSlip::Backward => random.between(-2.0, -0.1),
            KnownSlip::Rest | KnownSlip::Leaves(_) => 0.0,
        };
        let (sine, cosine) = alpha.sin_cos();
        let theta = random.between(-3.0, 3.0);
        let state = [theta, 0.0, 0.0, random.between(-3.0, 3.0), speed * cosine, speed * sine];
        let leaves = [Sense::Forward, Sense::Backward].map(|sense| (1, KnownSlip::Leaves(sense)));
        for slips in [[(1, known)], [leaves[0]], [leaves[1]]].iter().take(if speed == 0.0 { 3 } else { 1 }) {
            let touching = ContactSet::EMPTY.with(1);
            let question = ContactProblem { touching, slips, ..ContactProblem::default() };
            let Some(found) = single::decide(&context, &state, &question) else { continue };
            let expected = decide(&context.model, &state, &question).unwrap();
            assert_eq!(
                (found.closed, found.bearing),
                (expected.closed, expected.bearing),
                "{slips:?} {state:?}"
            );
            assert!(expected.unique && expected.alternatives.is_none(), "{slips:?} {state:?}");
            for (one, other) in found.reactions.iter().zip(&expected.reactions) {
                assert!((one - other).abs() <= 1e-9 * (1.0 + other.abs()), "{one} {other}");
            }
            decided += usize::from(slips[0].1 == known);
            let slip =
                found.closed.contains(1).then(|| 1 + usize::from(found.closed.sense(1).unsigned_abs() > 0));
            kinds[slip.unwrap_or(0)] += 1;
        }
    }
    assert!(decided > 2400 && kinds.iter().all(|count| *count > 200), "{decided} {kinds:?}");
}
