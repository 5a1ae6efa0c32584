//! Collisions of two point masses over a floor.

use super::*;

/// Two point masses over a floor, with friction of the first.
fn collision() -> Collision {
    let law = Law::Newton;
    Collision {
        mass: DMatrix::identity(3, 3),
        jacobian: DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
        rates: DVector::from_row_slice(&[0.5, -1.0, -2.0]),
        prescribed_gap_rate: DVector::zeros(3),
        applied: DVector::zeros(3),
        rows: vec![
            Row::Contact { restitution: 0.5, law },
            Row::Friction { of: 0, mu: 0.2, restitution: 0.0 },
            Row::Contact { restitution: 0.5, law },
        ],
    }
}

fn error(change: impl FnOnce(&mut Collision)) -> Option<CollisionError> {
    let mut collision = collision();
    change(&mut collision);
    assert_eq!(collision.solve().err(), collision.check().err());
    collision.check().err()
}

#[test]
fn mismatched_dimensions_are_refused() {
    assert_eq!(error(|_| ()), None);
    let wrong: [fn(&mut Collision); 9] = [
        |it| it.mass = DMatrix::identity(2, 2),
        |it| it.mass = DMatrix::identity(3, 2),
        |it| it.jacobian = DMatrix::zeros(2, 3),
        |it| it.jacobian = DMatrix::zeros(3, 2),
        |it| it.rates = DVector::zeros(2),
        |it| it.prescribed_gap_rate = DVector::zeros(2),
        |it| it.applied = DVector::zeros(2),
        |it| it.rows[1] = Row::Tangent { of: 3 },
        |it| it.rows[1] = Row::Friction { of: 1, mu: 0.2, restitution: 0.0 },
    ];
    for change in wrong {
        assert_eq!(error(change), Some(CollisionError::Dimensions));
    }
    for of in [Row::Open, Row::TwoSided, Row::Guide] {
        assert_eq!(error(|it| it.rows[0] = of), None);
    }
}

#[test]
fn nonfinite_entries_are_refused_in_closed_rows() {
    let wrong: [fn(&mut Collision); 5] = [
        |it| it.mass[(2, 2)] = f64::INFINITY,
        |it| it.rates[0] = f64::NAN,
        |it| it.applied[0] = f64::INFINITY,
        |it| it.prescribed_gap_rate[2] = f64::NAN,
        |it| it.jacobian[(2, 0)] = f64::NAN,
    ];
    for (k, change) in wrong.into_iter().enumerate() {
        assert_eq!(error(change), Some(CollisionError::Singular));
        let open = |it: &mut Collision| {
            it.rows[2] = Row::Open;
            change(it);
        };
        assert_eq!(error(open), (k < 3).then_some(CollisionError::Singular));
    }
}

/// The others move as if open rows, and the friction of open contacts, were not there.
#[test]
fn open_rows_take_no_part() {
    let mut open = collision();
    (open.rows[0], open.prescribed_gap_rate[0], open.prescribed_gap_rate[1]) = (Row::Open, 7.0, 7.0);
    let outcome = open.solve().unwrap();
    // The unit roundoff of some terms.
    assert!((outcome.rates - DVector::from_row_slice(&[0.5, -1.0, 1.0])).amax() < 1e-14);
    assert!((outcome.impulses - DVector::from_row_slice(&[0.0, 0.0, 3.0])).amax() < 1e-14);
    assert_eq!(outcome.acting, [2]);
    let acting = open.without_open_rows().unwrap();
    assert_eq!(acting.jacobian, DMatrix::from_fn(3, 3, |i, j| f64::from(u8::from(i == 2 && j == 2))));
    assert!(acting.prescribed_gap_rate == DVector::zeros(3) && acting.without_open_rows().is_none());
    assert!(collision().without_open_rows().is_none());
}

/// ġ⁻ of terms that cancel is their rounding, however small or large they are.
#[test]
fn an_approach_is_zero_up_to_the_rounding_of_its_terms() {
    for unit in [1e-20, 1.0, 1e20] {
        let mut it = collision();
        it.jacobian = DMatrix::from_row_slice(3, 3, &[0.1, 0.2, 0.0, 0.1, 0.2, 0.0, 0.0, 0.0, -1.0]);
        it.rates = DVector::from_row_slice(&[3.0, 3.0, 1.0]) * unit;
        it.prescribed_gap_rate =
            DVector::from_row_slice(&[-0.9 * (1.0 + 1e-13), -0.9 * (1.0 + 1e-11), 1.0]) * unit;
        let approach = it.approach();
        // The drift is −0.9e-11 more than the two terms of 0.3 and 0.6.
        assert_eq!((approach[0], approach[2]), (0.0, 0.0));
        assert!((approach[1] / unit + 0.9e-11).abs() < 1e-14, "{}", approach[1]);
    }
}
