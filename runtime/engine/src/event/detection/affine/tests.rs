//! Guards of a block by hand.

use super::super::StepView;
use super::*;
use crate::model::Form;
use crate::prelude::*;

/// A block on a belt, held by a spring.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k)]
#[support(P = floor, friction = mu, static = mu_s, moving = w)]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Block {
    m: f64,
    g: f64,
    k: f64,
    mu: f64,
    mu_s: f64,
    w: f64,
}

/// A bar that slides on a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[figure(A = (0, 0), B = (4 * l / 5, 3 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Bar {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
}

const BLOCK: Block = Block { m: 1.3, g: 9.81, k: 4.7, mu: 0.2, mu_s: 0.5, w: 0.7 };

/// x, y, ẋ and ẏ over a step, as cubics.
const MOTION: [[f64; 4]; 4] = [[0.3, 0.8, -0.4, 0.1], [1.2, 0.1, 0.0, -0.2], [0.6, -1.1, 0.3, 0.2], [0.5; 4]];

fn evaluate(c: &[f64], theta: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * theta + c)
}

/// N, R, g and v of the block by hand, with its spring level where it is on the belt.
fn by_hand(slip: Slip, [x, _, u, _]: [f64; 4]) -> [f64; 4] {
    let Block { m, g, k, mu, w, .. } = BLOCK;
    match slip {
        Slip::Stick => [m * g, k * x, 0.0, 0.0],
        _ => [m * g, -f64::from(slip.sign()) * mu * m * g, 0.0, u - w],
    }
}

#[test]
fn guards_of_a_block_follow_from_its_dense_output() {
    let simulation = Simulation::new(&BLOCK).expect("a block");
    for slip in [Slip::Stick, Slip::Forward, Slip::Backward] {
        let phase = simulation.context.phase(ContactSet::EMPTY.slipping(0, slip), Form::Reduced);
        assert!(phase.info().affine, "{slip:?}");
        let kept: Vec<&[f64; 4]> = phase.kept().iter().map(|&entry| &MOTION[entry]).collect();
        let end: Vec<f64> = kept.iter().map(|c| evaluate(&c[..], 1.0)).collect();
        let coefficients = (0..4).flat_map(|k| kept.iter().map(move |c| c[k]));
        let step = DenseOutput::series([0.0, 0.5], &end, coefficients);
        let mut guards = AffineGuards::compute(&*phase, &simulation.context);
        let guards = guards.over(&step).expect("a cubic");
        let found = [guards.reaction(0), guards.reaction(1), guards.gap(0), guards.gap(1)];
        for theta in [0.0, 0.3, 1.0] {
            let expected = by_hand(slip, MOTION.map(|c| evaluate(&c, theta)));
            for (found, expected) in found.map(|c| evaluate(c, theta)).into_iter().zip(expected) {
                // Some roundings of the largest term, m g.
                let apart = (found - expected).abs();
                assert!(
                    apart <= 8.0 * f64::EPSILON * BLOCK.m * BLOCK.g,
                    "{slip:?} {theta}: {found} for {expected}"
                );
            }
        }
    }
}

/// Its end is a coordinate, the gap while it flies; its reaction depends on its angle.
#[test]
fn guards_of_a_bar_are_affine_in_flight_only() {
    let simulation = Simulation::new(&Bar { m: 1.0, l: 1.0, g: 9.81, mu: 0.1 }).expect("a bar");
    let sliding = ContactSet::EMPTY.slipping(0, Slip::Forward);
    for (set, affine) in [(ContactSet::EMPTY, true), (sliding, false)] {
        assert_eq!(simulation.context.phase(set, Form::Reduced).info().affine, affine, "{set:?}");
    }
}

/// ∫ R (v − v°) dt of the block: R = ∓μ m g, v = u − w where it slides, and v° = −w without rates.
#[test]
fn the_work_of_friction_follows_from_its_series() {
    let Block { m, g, mu, w, .. } = BLOCK;
    let simulation = Simulation::new(&BLOCK).expect("a block");
    for slip in [Slip::Forward, Slip::Backward] {
        let phase = simulation.context.phase(ContactSet::EMPTY.slipping(0, slip), Form::Reduced);
        let kept: Vec<&[f64; 4]> = phase.kept().iter().map(|&entry| &MOTION[entry]).collect();
        let end: Vec<f64> = kept.iter().map(|c| evaluate(&c[..], 1.0)).collect();
        let coefficients = (0..4).flat_map(|k| kept.iter().map(move |c| c[k]));
        let step = DenseOutput::series([0.0, 0.5], &end, coefficients);
        let mut guards = AffineGuards::compute(&*phase, &simulation.context);
        let view = StepView::new(&phase, &simulation.context, &step).with_series(guards.over(&step));
        let [_, _, [a, b, c, d], _] = MOTION;
        for end in [0.3, 1.0_f64] {
            let way = a * end + b * end.powi(2) / 2.0 + c * end.powi(3) / 3.0 + d * end.powi(4) / 4.0;
            let expected = -f64::from(slip.sign()) * mu * m * g * 0.5 * way;
            let found = view.friction_work(end, &[-w], &|_, _, _| true).expect("series");
            assert!((found - expected).abs() < 1e-12, "{slip:?} {end}: {found} {expected}");
        }
        assert_eq!(view.friction_work(1.0, &[-w], &|_, _, _| false), None);
    }
}

/// A polynomial as long as there is room for with the zeros behind it, and no longer; none of
/// guards that overflow.
#[test]
fn guards_have_series_where_there_is_room() {
    let simulation = Simulation::new(&BLOCK).expect("a block");
    let phase = simulation.context.phase(ContactSet::EMPTY.slipping(0, Slip::Forward), Form::Reduced);
    let entries = phase.info().entries;
    let step = |terms: usize| {
        DenseOutput::series([0.0, 0.5], &vec![0.0; entries], core::iter::repeat_n(0.0, entries * terms))
    };
    let mut guards = AffineGuards::compute(&*phase, &simulation.context);
    for (terms, has) in [(1, true), (ORDERS - ENDS, true), (ORDERS - ENDS + 1, false), (ORDERS + 1, false)] {
        assert_eq!(guards.over(&step(terms)).is_some(), has, "{terms}");
    }
    guards.is_finite = false;
    assert!(guards.over(&step(1)).is_none());
}
