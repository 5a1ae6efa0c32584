//! What the orders tell of single rows.

use nalgebra::DVector;

use super::{ContactProblem, Ladder};
use crate::contact::equations::Equations;
use crate::model::ContactSet;
use crate::system::Model;

use liftoff_fixtures::RodOnSupports;

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
