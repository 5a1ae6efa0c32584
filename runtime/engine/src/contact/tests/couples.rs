//! Loads that contacts share with a couple.

use crate::contact::closed_rows::ClosedRows;
use crate::contact::degenerate::OrderLadder;
use crate::contact::equations::SeriesEquations;
use crate::contact::{ContactProblem, decide};
use crate::model::ContactSet;
use crate::prelude::*;
use crate::system::Model;

/// A level rod on both ends, driven not to turn, with a load at one end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(G = AB, at = l / 2)]
#[support(A = floor)]
#[support(B = floor)]
#[force(B = (0, -q))]
#[drive(theta = omega * t)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(theta = angle(AB), from = right)]
#[coordinate(x = x(G))]
#[coordinate(y = y(G))]
struct Levelled {
    m: f64,
    l: f64,
    g: f64,
    q: f64,
    omega: f64,
}

/// The couple C of the drive and the difference d of the ends' reactions hold d l/2 + C = q l/2. At
/// the lever l/√2 the shortest are d = q/2 and C = q l/4, whatever the unit of length is.
#[test]
fn couples_and_forces_are_compared_at_their_lever() {
    for l in [1e-3, 1.0, 4e4] {
        let (m, g, q) = (2.0, 9.81, 3.0);
        let model = Model::new(&Levelled { m, l, g, q, omega: 0.0 });
        let (state, touching) = ([0.0; 7], ContactSet::from_bits(0b11));
        let question = ContactProblem { touching, ..ContactProblem::default() };
        let expected = [0.5 * (m * g + 0.5 * q), 0.5 * (m * g + 1.5 * q), 0.25 * q * l];
        let found = decide(&model, &state, &question).unwrap();
        assert!(!found.unique && found.closed == touching);
        for (reaction, expected) in found.reactions.iter().zip(&expected) {
            assert!((reaction - expected).abs() < 1e-12 * expected, "{l}: {:?}", found.reactions);
        }
        let equations = SeriesEquations::along(&model, &state, &[]);
        let problem = OrderLadder::new(model.layout(), &question).problem(&equations, 0);
        let attempt = problem.attempt(&[0, 1, 2]).unwrap();
        assert_eq!((attempt.nullity, attempt.consistent), (1, true));
        for (row, expected) in expected.iter().enumerate() {
            let reaction = attempt.x[3 + row] * problem.scale[3 + row];
            assert!((reaction - expected).abs() < 1e-11 * expected, "{l}: {row} {reaction}");
        }
    }
}

/// A second, heavier bar on a hinge at the end of the first one, with its end on the floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = p * m, length = l / 2)]
#[pin(A = (0, 0))]
#[support(B = floor)]
#[support(C = floor)]
#[drive(a = omega * t)]
#[figure(B = (l, 0), C = (3 * l / 2, 0))]
#[coordinate(a = angle(AB), from = right)]
#[coordinate(b = angle(BC), from = right)]
struct Jointed {
    m: f64,
    p: f64,
    l: f64,
    g: f64,
    omega: f64,
}

/// The lever is that of J, whose squares by a are l², l² and 1 of the couple, by b (l/2)²: ℓ = 3
/// l/2, whatever the inertia.
#[test]
fn levers_are_those_of_the_rows_in_their_own_units() {
    for (p, l) in [(1.0, 1.0), (50.0, 1.0), (7.0, 1e3)] {
        let model = Model::new(&Jointed { m: 2.0, p, l, g: 9.81, omega: 0.0 });
        let (state, touching) = ([0.0; 5], ContactSet::from_bits(0b11));
        let question = ContactProblem { touching, ..ContactProblem::default() };
        let problem = OrderLadder::new(model.layout(), &question)
            .problem(&SeriesEquations::along(&model, &state, &[]), 0);
        let balanced = problem.closed_rows(vec![0, 1, 2]).levers;
        let own = ClosedRows::compute(&*model.system, &state, &touching).levers;
        for levers in [balanced, own] {
            assert_eq!(levers[..2], [1.0, 1.0]);
            assert!((levers[2] - 1.5 * l).abs() < 1e-12 * l, "{p} {l}: {levers:?}");
        }
    }
}
