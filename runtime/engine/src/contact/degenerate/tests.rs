//! What the orders tell of single rows.

use nalgebra::DVector;

use super::{ContactProblem, Ladder};
use crate::contact::equations::Equations;
use crate::model::ContactSet;
use crate::system::Model;

use liftoff_fixtures::{AFrame, RodOnSupports};

/// Open rows have neither entries nor a bias, all others those that they had.
#[test]
fn rows_that_take_no_part_are_zero() {
    let model = Model::of(&RodOnSupports { m: 1.0, l: 2.0, g: 1.0 });
    let state = [0.3, 0.1, 0.2, 0.7, 0.4, -0.2];
    let acceleration = DVector::from_row_slice(&[0.3, -0.1, 0.5]);
    let equations = || Equations::along(&model, &state, std::slice::from_ref(&acceleration));
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

/// The end of a rod that turns has g̈ = ÿ − θ̈ l/2 cos θ + θ̇² l/2 sin θ: pressed where this is less than zero by more than what is
/// known of its terms.
#[test]
fn a_contact_is_pressed_beyond_the_rounding_of_its_terms() {
    let model = Model::of(&RodOnSupports { m: 1.0, l: 2.0, g: 1.0 });
    let (turn, rate) = (0.3_f64, 1.7);
    let layout = model.layout();
    let touching = ContactSet::EMPTY.with(0);
    let turned = rate * rate * turn.sin();
    for unit in [1e-8, 1.0, 1e8] {
        let state = [turn, 0.0, 0.0, rate * unit, 0.0, 0.0];
        for (part, pressed) in [(1.0, false), (0.0, false), (-1e-10, false), (-1e-8, true), (-1.0, true)] {
            let mut ladder = Ladder::new(layout, &ContactProblem { touching, ..ContactProblem::default() });
            // The two terms cancel but for a part of them.
            let a = -turned * (1.0 - 2.0 * part) * unit * unit;
            ladder.accelerations = vec![DVector::from_row_slice(&[0.0, 0.0, a])];
            assert_eq!(ladder.is_pressed(&model, &state, 0), pressed, "{unit} {part}");
        }
    }
}

/// M₀ a₂ − J₀ᵀ λ₂ = f₂ − Σ (Mₖ a₂₋ₖ − Jₖᵀ λ₂₋ₖ), and J₀ a₂ + b₂ + Σ Jₖ a₂₋ₖ = 0: what is rounding of them follows from the largest of their
/// terms, and of those of order 0 in a natural time.
#[test]
fn higher_orders_are_known_as_well_as_their_terms() {
    let model = Model::of(&AFrame { m: 2.0, l: 0.7, g: 9.81 });
    let (c, rate) = (0.8, -1.3);
    let state = [0.6_f64.asin(), 0.7 * 0.6, rate, 0.7 * c * rate];
    let a = [[0.4, -0.3], [1.5, 0.2]].map(|a| DVector::from_row_slice(&a));
    let equations = Equations::along(&model, &state, &a);
    // Reactions so large that their terms are the largest, and none.
    for (load, time) in [(1e4, None), (0.0, None), (0.0, Some(1e-3))] {
        let question =
            ContactProblem { touching: ContactSet::EMPTY.with(0), time, ..ContactProblem::default() };
        let mut ladder = Ladder::new(model.layout(), &question);
        ladder.accelerations = a.to_vec();
        let reactions = [1.0, -2.0].map(|part| DVector::repeat(model.layout().rows(), part * load));
        ladder.reactions = reactions.to_vec();
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
    }
}
