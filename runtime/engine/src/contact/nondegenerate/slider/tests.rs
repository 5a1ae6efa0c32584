//! A single contact decided in closed form, against the decision of any number of contacts.

use super::decide as decide_slider;
use crate::contact::closed_rows::ClosedRows;
use crate::contact::friction::tests::random::Random;
use crate::contact::friction::{SlipDirection, SlipVelocity as KnownSlip, holds, least_hold};
use crate::contact::{ContactProblem, decide};
use crate::context::{RunContext, scales_of};
use crate::model::{self, ContactSet};
use crate::prelude::*;
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

/// Where the closed form decides at all it decides alike, and nothing else may follow; at rest it
/// does so of nearly all states from which one motion follows, those with w < 0 among them.
#[test]
fn a_single_contact_is_decided_alike() {
    let mut random = Random(0x51_1e);
    let (mut decided, mut kinds, mut missed) = ([0; 3], [0; 3], 0);
    for _ in 0..4000 {
        let mu = random.between(0.0, 2.0);
        let mu_s = mu * [1.0, random.between(1.0, 1.5)][random.below(2)];
        // Other units of time.
        let turn = random.below(3);
        let unit = [1.0, 1e-8, 1e8][turn];
        let [p, q] = [0.0; 2].map(|_| random.between(-12.0, 12.0) * unit);
        let alpha = random.between(-1.0, 1.0);
        let rod = Pulled { m: 1.0, l: 1.0, g: 9.81 * unit, p, q, alpha, far: -9.0, mu, mu_s };
        let model = Model::from(&rod);
        let scales = scales_of(&model).unwrap();
        let context = RunContext { model, scales };
        let senses = [KnownSlip::Forward, KnownSlip::Backward, KnownSlip::Rest, KnownSlip::Rest];
        let known = senses[random.below(4)];
        let speed = match known {
            KnownSlip::Forward => random.between(0.1, 2.0),
            KnownSlip::Backward => random.between(-2.0, -0.1),
            KnownSlip::Rest | KnownSlip::Leaves(_) => 0.0,
        };
        let (speed, rate) = (speed * f64::sqrt(unit), random.between(-3.0, 3.0) * f64::sqrt(unit));
        let (sine, cosine) = alpha.sin_cos();
        let theta = random.between(-3.0, 3.0);
        let state = [theta, 0.0, 0.0, rate, speed * cosine, speed * sine];
        let leaves =
            [SlipDirection::Forward, SlipDirection::Backward].map(|sense| (1, KnownSlip::Leaves(sense)));
        for slips in [[(1, known)], [leaves[0]], [leaves[1]]].iter().take(if speed == 0.0 { 3 } else { 1 }) {
            let touching = ContactSet::EMPTY.with(1);
            let question = ContactProblem { touching, slips, ..ContactProblem::default() };
            let (found, expected) =
                (decide_slider(&context, &state, &question), decide(&context.model, &state, &question));
            let Some(found) = found else {
                let one = expected.is_ok_and(|it| it.unique && it.alternatives.is_none());
                missed += usize::from(one && slips[0].1 == KnownSlip::Rest);
                continue;
            };
            let expected = expected.unwrap();
            assert_eq!(
                (found.closed, found.active_basis),
                (expected.closed, expected.active_basis),
                "{slips:?} {state:?}"
            );
            assert!(expected.unique && expected.alternatives.is_none(), "{slips:?} {state:?}");
            for (one, other) in found.reactions.iter().zip(&expected.reactions) {
                assert!((one - other).abs() <= 1e-9 * (unit + other.abs()), "{one} {other}");
            }
            decided[turn] += usize::from(slips[0].1 == known);
            let slip =
                found.closed.contains(1).then(|| 1 + usize::from(found.closed.sense(1).unsigned_abs() > 0));
            kinds[slip.unwrap_or(0)] += 1;
        }
    }
    let enough = decided.iter().all(|count| *count > 800) && kinds.iter().all(|count| *count > 200);
    assert!(enough && missed < 20, "{decided:?} {kinds:?} {missed}");
}

/// A rod on a level floor, at θ with the rate ω, its end without slip or with one.
fn on_the_floor(rod: &Pulled) -> RunContext {
    let model = Model::new(rod);
    let scales = scales_of(&model).unwrap();
    RunContext { model, scales }
}

const LYING: Pulled =
    Pulled { m: 2.0, l: 3.0, g: 9.81, p: 0.0, q: 0.0, alpha: 0.0, far: -9.0, mu: 0.4, mu_s: 0.5 };

/// What is held whatever its reaction, was located without one, or is not alone is no such case.
#[test]
fn other_questions_are_not_answered_in_closed_form() {
    let context = on_the_floor(&LYING);
    let state = [1.0, 0.0, 0.0, 0.3, 0.5, 0.0];
    let (own, other) = (ContactSet::EMPTY.with(1), ContactSet::EMPTY.with(0));
    let slips = [(1, KnownSlip::Forward), (0, KnownSlip::Rest)];
    let alone = ContactProblem { touching: own, slips: &slips[..1], ..ContactProblem::default() };
    let is_answered = |question: ContactProblem| decide_slider(&context, &state, &question).is_some();
    assert!(is_answered(alone));
    assert!(!is_answered(ContactProblem { held: own, ..alone }));
    assert!(!is_answered(ContactProblem { held: other, ..alone }));
    assert!(!is_answered(ContactProblem { unloaded: own, ..alone }));
    assert!(!is_answered(ContactProblem { held: own, unloaded: own, ..alone }));
    assert!(!is_answered(ContactProblem { touching: own.union(other), ..alone }));
    assert!(!is_answered(ContactProblem { touching: other, ..alone }));
    assert!(!is_answered(ContactProblem { touching: own.union(other), slips: &slips, ..alone }));
    assert!(!is_answered(ContactProblem { slips: &[], ..alone }));
    // Without friction it is one.
    let context = on_the_floor(&Pulled { mu: 0.0, mu_s: 0.0, ..LYING });
    assert!(decide_slider(&context, &state, &alone).is_some());
}

/// 1 + 3 cos²θ ± 3 μ sin θ cos θ of a rod that slides forward or backward, relative to what it is
/// without friction, whatever its mass and length; nothing of one that sticks.
#[test]
fn how_a_sliding_rod_is_held_is_a_number() {
    for (m, l) in [(2.0, 3.0), (1e-7, 1e4)] {
        let context = on_the_floor(&Pulled { m, l, mu: 1.7, mu_s: 1.7, ..LYING });
        for theta in [0.7_f64, 1.1, 2.2] {
            let state = [theta, 0.0, 0.0, 0.0, 0.0, 0.0];
            let (sine, cosine) = theta.sin_cos();
            let smooth = 1.0 + 3.0 * cosine * cosine;
            let of = |slip: model::Slip| ContactSet::EMPTY.slipping(1, slip);
            for (slip, sense) in [(model::Slip::Forward, 1.0), (model::Slip::Backward, -1.0)] {
                let expected = 1.0 + sense * 3.0 * 1.7 * sine * cosine / smooth;
                let told = holds(context.system(), &state, &of(slip));
                assert!(
                    told.len() == 1 && told[0].0 == 1 && (told[0].1 - expected).abs() < 1e-12,
                    "{told:?}"
                );
                let least = least_hold(context.system(), &state, &of(slip)).unwrap();
                assert_eq!(least, told[0].1);
            }
            assert!(least_hold(context.system(), &state, &of(model::Slip::Stick)).is_none());
        }
    }
}

/// Of all rows those of joints and closed contacts, with the tangents of those that have friction,
/// sticking or sliding.
#[test]
fn closed_rows_are_those_of_closed_contacts() {
    let context = on_the_floor(&LYING);
    let layout = context.layout();
    let state = [1.0, 0.0, 0.0, 0.3, 0.5, 0.0];
    let tangent = |contact: usize| layout.frictions.iter().find(|it| it.contact == contact).unwrap().row;
    let rows = |set: ContactSet| ClosedRows::compute(context.system(), &state, &set).rows;
    assert_eq!(rows(ContactSet::EMPTY), [0; 0]);
    for slip in [model::Slip::Stick, model::Slip::Forward, model::Slip::Backward] {
        for contact in [0, 1] {
            let alone = ContactSet::EMPTY.slipping(contact, slip);
            assert_eq!(rows(alone), [contact, tangent(contact)], "{slip:?}");
        }
        let both = ContactSet::EMPTY.slipping(0, slip).slipping(1, model::Slip::Forward);
        let mut expected = [0, 1, tangent(0), tangent(1)];
        expected.sort_unstable();
        assert_eq!(rows(both), expected, "{slip:?}");
    }
    // In natural coordinates √m q.
    let equations = context.system().equations(&state);
    let all = ClosedRows::compute(context.system(), &state, &own_and_other());
    for (k, &row) in all.rows.iter().enumerate() {
        assert_eq!(all.levers[k], 1.0);
        for j in 0..3 {
            let expected = equations.jacobian(row)[j] / equations.mass(j)[j].sqrt();
            assert!((all.jacobian[(k, j)] - expected).abs() <= 1e-15 * expected.abs(), "{row} {j}");
        }
    }
}

fn own_and_other() -> ContactSet {
    ContactSet::EMPTY.slipping(0, model::Slip::Forward).slipping(1, model::Slip::Stick)
}
