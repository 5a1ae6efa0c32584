//! Decisions that reactions and openings make clear, as the search makes them.

use liftoff_fixtures::{AFrame, Block, Ladder, RodOnSupports};

use super::*;
use crate::context::scales_of;
use crate::prelude::*;
use crate::system::Model;

fn context(model: Model) -> RunContext {
    let scales = scales_of(&model).unwrap();
    RunContext { model, scales }
}

fn decided(model: Model, state: &[f64], touching: u64, unloaded: u64) -> Option<ContactSolution> {
    let [touching, unloaded] = [touching, unloaded].map(ContactSet::from_bits);
    decide(&context(model), state, &ContactProblem { touching, unloaded, ..ContactProblem::default() }, None)
}

/// Units in which nothing is one: m, l, g.
const FRAME: AFrame = AFrame { m: 3.0, l: 0.02, g: 9.81 };

/// The A-frame falling with φ̇ < 0 at sin φ = s on the level S, whose reaction is 2 m g (¼ − (3/2)
/// s S + (9/4) s²).
fn frame(s: f64, sum: f64, unloaded: bool) -> Option<ContactSolution> {
    let AFrame { l, g, .. } = FRAME;
    let (c, rate) = ((1.0 - s * s).sqrt(), -(3.0 * (sum - s) * g / l).sqrt());
    decided(Model::new(&FRAME), &[s.asin(), l * s, rate, l * c * rate], 1, u64::from(unloaded))
}

#[test]
fn a_reaction_is_clear_from_a_part_of_the_natural_force_on() {
    let (force, weight) = (context(Model::new(&FRAME)).scales.force(), 2.0 * FRAME.m * FRAME.g);
    for s in [0.7, 0.8, 0.9] {
        for part in [-1.0, 0.0, 0.5, 0.999, 1.001, 2.0, 1e5] {
            let reaction = part * MARGIN * force;
            let sum = (0.25 + 2.25 * s * s - reaction / weight) / (1.5 * s);
            let Some(found) = frame(s, sum, false) else {
                assert!(part < 1.0, "{part}");
                continue;
            };
            assert!(part > 1.0 && found.closed == ContactSet::from_bits(1), "{part}");
            // The unit roundoff of terms as large as the weight.
            assert!((found.reactions[0] - reaction).abs() < 1e-14 * weight, "{part}");
        }
    }
}

/// As s falls through the upper root (S + r)/3 of the reaction, r² = S² − 1, its rate is 3 m g r ṡ.
#[test]
fn a_vanishing_reaction_opens_where_its_fall_in_a_natural_time_is_clear() {
    let AFrame { m, l, g } = FRAME;
    let scales = context(Model::new(&FRAME)).scales;
    let rate = |root: f64| {
        let (sum, s) = ((1.0 + root * root).sqrt(), ((1.0 + root * root).sqrt() + root) / 3.0);
        (s, sum, 3.0 * m * g * root * ((1.0 - s * s) * 3.0 * (sum - s) * g / l).sqrt())
    };
    let clear = MARGIN * scales.force() / scales.time;
    for part in [1e-4, 0.1, 0.9, 1.1, 10.0, 1e4] {
        // The rate is proportional to a small root.
        let (s, sum, fall) = rate(part * clear * 1e-7 / rate(1e-7).2);
        let opens = frame(s, sum, true).inspect(|found| {
            assert_eq!((found.closed, found.reactions[0]), (ContactSet::EMPTY, 0.0));
        });
        assert_eq!(opens.is_some(), fall > clear, "{part}");
    }
}

/// A load that grows takes a particle's weight off the floor: λ̇ = −f.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor)]
#[force(P = (0, f * t))]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Lifted {
    m: f64,
    l: f64,
    g: f64,
    f: f64,
}

#[test]
fn loads_change_with_time() {
    for (f, opens) in [(2.0, true), (-2.0, false)] {
        let lifted = Lifted { m: 3.0, l: 0.1, g: 9.81, f };
        let t = 3.0 * 9.81 / f;
        let found = decided(Model::new(&lifted), &[0.1, 0.0, 0.0, 0.0, t], 1, 1);
        assert_eq!(found.is_some(), opens, "{f}");
    }
}

/// A ladder that slides down: the reactions of its foot and of its head both fall, and what follows
/// if both have vanished is not told by each alone.
#[test]
fn two_that_vanish_at_once_are_not_such_a_case() {
    let ladder = || Model::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 });
    let (theta, rate) = (1.0_f64, -0.5);
    let (sine, cosine) = theta.sin_cos();
    let state = [theta, 0.5 * cosine, 0.5 * sine, rate, -0.5 * sine * rate, 0.5 * cosine * rate];
    let closed = |unloaded| decided(ladder(), &state, 0b11, unloaded).map(|found| found.closed);
    assert_eq!(closed(0b01), Some(ContactSet::from_bits(0b10)));
    assert_eq!(closed(0b10), Some(ContactSet::from_bits(0b01)));
    assert_eq!(closed(0b11), None);
}

/// A block that rocks about a corner, forth or back: its reaction falls in one of them, and its
/// tangential reaction would be lost with it.
#[test]
fn a_rough_contact_that_vanishes_is_not_such_a_case() {
    let (b, h) = (0.5, 1.0);
    let block = || Model::new(&Block { m: 1.0, b, h, g: 1.0 });
    for rate in [-0.7, 0.7] {
        let (sine, cosine) = 0.3_f64.sin_cos();
        let (x, y) = (b * cosine - h * sine, b * sine + h * cosine);
        let state = [0.3, x, y, rate, -y * rate, x * rate];
        assert!(decided(block(), &state, 0b01, 0).is_some());
        assert!(decided(block(), &state, 0b01, 0b01).is_none());
    }
}

#[test]
fn redundant_reactions_are_not_such_a_case() {
    let rod = || Model::new(&RodOnSupports { m: 1.0, l: 1.0, g: 1.0 });
    assert!(decided(rod(), &[0.0; 6], 0b101, 0).is_some());
    assert!(decided(rod(), &[0.0; 6], 0b111, 0).is_none());
}
