//! What the orders tell of single rows.

use nalgebra::DVector;

use super::{ContactProblem, OrderLadder, decide};
use crate::contact::ContactError;
use crate::contact::equations::SeriesEquations;
use crate::contact::friction::{ContactMode, SlipDirection, SlipVelocity};
use crate::model::{ContactKind, ContactSet, Side, Slip as ModelSlip};
use crate::prelude::*;
use crate::system::Model;

use liftoff_fixtures::{AFrame, RodOnSupports};

/// Open rows have neither entries nor a bias, all others those that they had.
#[test]
fn rows_that_take_no_part_are_zero() {
    let model = Model::new(&RodOnSupports { m: 1.0, l: 2.0, g: 1.0 });
    let state = [0.3, 0.1, 0.2, 0.7, 0.4, -0.2];
    let acceleration = DVector::from_row_slice(&[0.3, -0.1, 0.5]);
    let equations = || SeriesEquations::along(&model, &state, std::slice::from_ref(&acceleration));
    let (whole, acting) = (equations(), equations().acting(|row| row == 1 || row == 2));
    for order in 0..2 {
        assert!(whole.bias[order][0] != 0.0 && whole.jacobian[order].row(0).amax() > 0.0);
        assert_eq!((acting.bias[order][0], acting.jacobian[order].row(0).amax()), (0.0, 0.0));
        for row in 1..3 {
            assert_eq!(acting.bias[order][row], whole.bias[order][row]);
            assert_eq!(acting.jacobian[order].row(row), whole.jacobian[order].row(row));
        }
        assert_eq!((&acting.mass[order], &acting.force[order]), (&whole.mass[order], &whole.force[order]));
    }
}

/// The end of a rod that turns has g̈ = ÿ − θ̈ l/2 cos θ + θ̇² l/2 sin θ: pressed where this is
/// less than zero by more than what is known of its terms.
#[test]
fn a_contact_is_pressed_beyond_the_rounding_of_its_terms() {
    let (turn, rate) = (0.3_f64, 1.7);
    let touching = ContactSet::EMPTY.with(0);
    let turned = rate * rate * turn.sin();
    for unit in [1e-8, 1.0, 1e8] {
        let model = Model::new(&RodOnSupports { m: 1.0, l: 2.0, g: unit * unit });
        let state = [turn, 0.0, 0.0, rate * unit, 0.0, 0.0];
        for (part, pressed) in [(1.0, false), (0.0, false), (-1e-10, false), (-1e-8, true), (-1.0, true)] {
            let mut ladder =
                OrderLadder::new(model.layout(), &ContactProblem { touching, ..ContactProblem::default() });
            // The two terms cancel but for a part of them.
            let a = -turned * (1.0 - 2.0 * part) * unit * unit;
            ladder.accelerations = vec![DVector::from_row_slice(&[0.0, 0.0, a])];
            assert_eq!(ladder.is_any_pressed(&model, &state, &[(0, 0.0)]), pressed, "{unit} {part}");
        }
    }
}

/// A reaction that was located at zero but for N makes twice W N of g̈ no pressing, W = (1 + 3
/// cos²θ)/m; one below zero opens by itself.
#[test]
fn located_reactions_do_not_press() {
    for (m, l) in [(1.0, 2.0), (3e5, 7e-4)] {
        let model = Model::new(&RodOnSupports { m, l, g: 1.0 });
        let turn = 0.3_f64;
        let touching = ContactSet::EMPTY.with(0);
        let compliance = (1.0 + 3.0 * turn.cos().powi(2)) / m;
        for (part, pressed) in [(0.0, true), (0.4, true), (0.6, false), (-0.6, true)] {
            let mut ladder =
                OrderLadder::new(model.layout(), &ContactProblem { touching, ..ContactProblem::default() });
            // The rod falls with 1e-7 of the weight.
            ladder.accelerations = vec![DVector::from_row_slice(&[0.0, 0.0, -1e-7])];
            let located = part * 1e-7 / compliance;
            let state = [turn, 0.0, 0.0, 0.0, 0.0, 0.0];
            assert_eq!(ladder.is_any_pressed(&model, &state, &[(0, located)]), pressed, "{m} {part}");
        }
    }
}

/// M₀ a₂ − J₀ᵀ λ₂ = f₂ − Σ (Mₖ a₂₋ₖ − Jₖᵀ λ₂₋ₖ), and J₀ a₂ + b₂ + Σ Jₖ a₂₋ₖ = 0: what is rounding
/// of them follows from the largest of their terms, and of those of order 0 in a natural time.
#[test]
fn higher_orders_are_known_as_well_as_their_terms() {
    let model = Model::new(&AFrame { m: 2.0, l: 0.7, g: 9.81 });
    let (c, rate) = (0.8, -1.3);
    let state = [0.6_f64.asin(), 0.7 * 0.6, rate, 0.7 * c * rate];
    let a = [[0.4, -0.3], [1.5, 0.2]].map(|a| DVector::from_row_slice(&a));
    let along = || SeriesEquations::along(&model, &state, &a);
    // Reactions so large that their terms are the largest, none, and no rows' own terms beside
    // those of the accelerations.
    for (load, time, quiet) in [
        (1e4, None, false),
        (0.0, None, false),
        (0.0, Some(1e-3), false),
        (0.0, None, true),
        (0.0, Some(1e-3), true),
    ] {
        let question =
            ContactProblem { touching: ContactSet::EMPTY.with(0), time, ..ContactProblem::default() };
        let mut ladder = OrderLadder::new(model.layout(), &question);
        ladder.accelerations = a.to_vec();
        let reactions = [1.0, -2.0].map(|part| DVector::repeat(model.layout().rows(), part * load));
        ladder.reactions = reactions.to_vec();
        let mut equations = along();
        if quiet {
            (0..3).for_each(|k| equations.mass[k] *= if k > 0 { 0.0 } else { 1.0 });
            for k in [0, 2] {
                equations.force[k].fill(0.0);
            }
        }
        let problem = ladder.problem(&equations, 2);
        let (f, m, j, b) = (&equations.force, &equations.mass, &equations.jacobian, &equations.bias);
        let force = [
            f[2].clone(),
            -&m[1] * &a[1],
            -&m[2] * &a[0],
            j[1].tr_mul(&reactions[1]),
            j[2].tr_mul(&reactions[0]),
        ];
        let bias = [b[2].clone(), &j[1] * &a[1], &j[2] * &a[0]];
        let part = time.map_or(0.0, |time| 1e-3 / (time * time));
        let n = a[0].len();
        let mut largest = 0.0_f64;
        for i in 0..n + bias[0].len() {
            let (terms, first): (Vec<f64>, f64) = match i.checked_sub(n) {
                None => (force.iter().map(|term| term[i]).collect(), f[0][i]),
                Some(row) => (bias.iter().map(|term| -term[row]).collect(), b[0][row]),
            };
            let scale = problem.scale[i];
            let right = scale * terms.iter().sum::<f64>();
            assert!((problem.right[i] - right).abs() <= 1e-12 * (1.0 + right.abs()), "{load} {i}");
            let size = terms.iter().map(|term| term.abs()).sum::<f64>() + part * first.abs();
            largest = largest.max(scale * size);
        }
        let told = problem.tolerance.max();
        assert!((told - 1e-12 * largest).abs() <= 1e-9 * told, "{load} {time:?}: {told:e} {largest:e}");
        // Order 0 has its own terms, and what they change by in a part of the natural time.
        let problem = ladder.problem(&equations, 0);
        let change = |i: usize| time.map_or(0.0, |time| 1e-3 * time * f[1][i].abs());
        let own = (0..n).map(|i| problem.scale[i] * (f[0][i].abs() + change(i)));
        let own = own.chain((0..b[0].len()).map(|row| problem.scale[n + row] * b[0][row].abs()));
        let (told, largest) = (problem.tolerance.max(), own.fold(0.0, f64::max));
        assert!((told - 1e-12 * largest).abs() <= 1e-9 * told, "{time:?}: {told:e} {largest:e}");
    }
}

/// Rates whose squares are no numbers.
#[test]
fn equations_that_are_not_finite_are_refused() {
    let model = Model::new(&RodOnSupports { m: 1.0, l: 2.0, g: 1.0 });
    let question = ContactProblem { touching: ContactSet::from_bits(0b101), ..ContactProblem::default() };
    let found = |rate: f64| decide(&model, &[0.3, 0.0, 0.0, rate, 0.0, 0.0], &question).map(|_| ());
    assert_eq!(found(1e3), Ok(()));
    assert_eq!(found(1e200), Err(ContactError::NotFinite));
}

/// A body in a guide, one end of which lies on the floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[slider(A = horizontal(0), friction = mu)]
#[support(B = floor, friction = mu)]
#[coordinate(x = x(A))]
#[coordinate(a = angle(AB), from = right)]
#[figure(A = (0, 0), B = (l, 0))]
struct Guided {
    m: f64,
    l: f64,
    mu: f64,
    g: f64,
}

/// A contact whose reaction was located at zero is open, unless it is held, and a guide does what
/// it did; what they may do is asked of the next order. All others may do anything.
#[test]
fn contacts_with_friction_begin_as_they_are_known() {
    let model = Model::new(&Guided { m: 1.0, l: 1.0, mu: 0.3, g: 9.81 });
    let layout = model.layout();
    let guide = (0..2).find(|&contact| layout.contacts[contact].kind == ContactKind::Guide).unwrap();
    let support = 1 - guide;
    let slips = [(guide, SlipVelocity::Rest), (support, SlipVelocity::Rest)];
    let touching = ContactSet::EMPTY.with(support).slipping(guide, ModelSlip::Backward);
    let touching = touching.pressing(guide, Side::Negative);
    let as_before = ContactMode::Guide { side: Side::Negative, sense: Some(SlipDirection::Backward) };
    for is_held in [false, true] {
        for is_unloaded in [false, true] {
            let if_so = |it: bool| if it { touching } else { ContactSet::EMPTY };
            let (held, unloaded) = (if_so(is_held), if_so(is_unloaded));
            let question =
                ContactProblem { touching, held, unloaded, slips: &slips, ..ContactProblem::default() };
            let mut ladder = OrderLadder::new(layout, &question);
            ladder.rub(&model, &[0.0; 4], &question).unwrap();
            let told = |contact: usize| {
                let it = ladder.rubbing.iter().find(|it| it.contact == contact).unwrap();
                let modes: Vec<ContactMode> = it.frictional.choices.iter().map(|it| it.mode).collect();
                (modes, it.later.as_ref().map(|later| later.choices.len()))
            };
            let note = format!("{is_held} {is_unloaded}");
            match is_unloaded {
                true => assert_eq!(told(guide), (vec![as_before], Some(6)), "{note}"),
                false => assert!(told(guide).0.len() == 6 && told(guide).1.is_none(), "{note}"),
            }
            match is_unloaded && !is_held {
                true => assert_eq!(told(support), (vec![ContactMode::Open], Some(4)), "{note}"),
                false => assert!(told(support).0.len() == 4 && told(support).1.is_none(), "{note}"),
            }
        }
    }
    // What does not touch takes no part.
    let question = ContactProblem {
        touching: ContactSet::EMPTY.with(support),
        slips: &slips,
        ..ContactProblem::default()
    };
    let mut ladder = OrderLadder::new(layout, &question);
    ladder.rub(&model, &[0.0; 4], &question).unwrap();
    assert_eq!(ladder.rubbing.iter().map(|it| it.contact).collect::<Vec<_>>(), [support]);
}
