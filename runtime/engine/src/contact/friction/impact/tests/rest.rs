//! Contacts that come to rest at the end of their impacts.

use nalgebra::{DMatrix, DVector};

use crate::contact::impulse::{Collision, Row};
use crate::model::{ContactSet, Law, Slip};

/// The tip of a bar on a pin rises and slides when its impacts are over: it is closed by an impulse
/// below zero. Another tip beside it rests on its floor and sticks, its normal and tangent one row.
/// By closed form: P = −m ġ / (J_N² − σ μ J_N J_t).
#[test]
fn one_closes_beside_another_whose_rows_are_one() {
    let (inertia, mu, rate) = (0.0222, 0.72, 3e-6);
    let (normal, tangent) = (0.146, 0.104);
    let contact = Row::Contact { restitution: 1.0, law: Law::Poisson };
    for count in [1, 2] {
        let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[inertia, 0.151][..count]));
        let rows = [[normal, 0.0], [0.0, -0.363], [tangent, 0.0], [0.0, 0.104]];
        let rows: Vec<[f64; 2]> = if count == 1 { vec![rows[0], rows[2]] } else { rows.to_vec() };
        let friction = |of: usize| Row::Friction { of, mu, restitution: 0.0 };
        let mut rates = DVector::zeros(count);
        rates[0] = rate;
        let collision = Collision {
            mass,
            jacobian: DMatrix::from_fn(2 * count, count, |i, j| rows[i][j]),
            rates,
            prescribed_gap_rate: DVector::zeros(2 * count),
            applied: DVector::zeros(count),
            rows: (0..count).map(|_| contact).chain((0..count).map(friction)).collect(),
        };
        let set = (0..count).fold(ContactSet::EMPTY, ContactSet::with).slipping(0, Slip::Forward);
        let set = if count == 2 { set.slipping(1, Slip::Stick) } else { set };
        let outcome = collision.come_to_rest(&set, usize::MAX).unwrap();
        let expected = -inertia * rate * normal / (normal * normal - mu * normal * tangent);
        assert!((outcome.impulses[0] - expected).abs() <= 1e-12 * expected.abs(), "{outcome:?}");
        assert!((outcome.impulses[count] + mu * expected).abs() <= 1e-12 * expected.abs(), "{outcome:?}");
        assert!(outcome.rates.amax() <= 1e-12 * rate, "{outcome:?}");
    }
}

/// The tip stops, its normal and tangent one row, beside bars that a slider holds at rest: the
/// rounding of the one is not taken for an impulse of the others.
#[test]
fn one_stops_beside_what_is_held_at_rest() {
    let (inertia, mu) = (0.0222, 0.72);
    let (normal, tangent) = (0.146, 0.104);
    for k in 0..20 {
        let rate = -3e-6 / (1.0 + f64::from(k));
        let held = [[0.3, 0.07 + 0.01 * f64::from(k)], [0.07 + 0.01 * f64::from(k), 0.5]];
        let mut mass = DMatrix::zeros(3, 3);
        mass[(0, 0)] = inertia;
        held.iter().enumerate().for_each(|(i, row)| (0..2).for_each(|j| mass[(1 + i, 1 + j)] = row[j]));
        let rows = [[normal, 0.0, 0.0], [0.0, 0.363, 0.104], [tangent, 0.0, 0.0]];
        let collision = Collision {
            mass,
            jacobian: DMatrix::from_fn(3, 3, |i, j| rows[i][j]),
            rates: DVector::from_row_slice(&[rate, 0.0, 0.0]),
            prescribed_gap_rate: DVector::zeros(3),
            applied: DVector::zeros(3),
            rows: vec![
                Row::Contact { restitution: 0.5, law: Law::Newton },
                Row::TwoSided,
                Row::Friction { of: 0, mu, restitution: 0.0 },
            ],
        };
        let set = ContactSet::EMPTY.with(0).slipping(0, Slip::Stick);
        let outcome = collision.come_to_rest(&set, usize::MAX).unwrap();
        let impulse = normal * outcome.impulses[0] + tangent * outcome.impulses[2];
        assert!((impulse + inertia * rate).abs() <= 1e-12 * inertia * rate.abs(), "{outcome:?}");
        assert_eq!((outcome.rates[1], outcome.rates[2]), (0.0, 0.0));
    }
}
