//! Against a bar's impulse by hand, and the search on random impacts.

use super::*;
use crate::contact::impulse::CollisionError;
use nalgebra::DMatrix;
use proptest::prelude::*;

/// A bar of mass m and length l, level, one end of which strikes a floor at the speed v: W = 1/m + 12 (l/2)²/(m l²) = 4/m.
fn bar(law: Law, e: f64) -> Collision {
    let (m, l, v) = (2.0, 3.0, 0.7);
    Collision {
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[m, m, m * l * l / 12.0])),
        jacobian: DMatrix::from_row_slice(2, 3, &[f64::NAN, 1.0, 0.0, 0.0, 1.0, -0.5 * l]),
        rates: DVector::from_row_slice(&[0.3, -v, 0.0]),
        drift: DVector::zeros(2),
        applied: DVector::zeros(3),
        rows: vec![Row::Open, Row::Contact { restitution: e, law }],
    }
}

#[test]
fn a_bar_turns_about_its_other_third() {
    for (law, e) in [(Law::Newton, 0.0), (Law::Newton, 0.6), (Law::Poisson, 0.6), (Law::Stronge, 0.6)] {
        let found = bar(law, e).of_single().unwrap();
        let impulse = (1.0 + e) * 0.7 * 2.0 / 4.0;
        let expected = [0.3, -0.7 + impulse / 2.0, -impulse * 1.5 / 1.5];
        // The unit roundoff of a few terms of size one.
        assert!((&found.rates - DVector::from_row_slice(&expected)).amax() < 1e-15, "{}", found.rates);
        assert!((found.impulses[1] - impulse).abs() < 1e-15 && found.impulses[0] == 0.0);
        assert!((found.opening[1] - 0.7 * e).abs() < 1e-15 && found.opening[0] == 0.0);
        assert!((found.gained + 0.5 * impulse * 0.7 * (1.0 - e)).abs() < 1e-15, "{}", found.gained);
        assert_eq!((found.law, &found.acting[..]), (law, &[1][..]));
        let compression = found.compression.map(|(_, impulses)| impulses[1]);
        assert_eq!(compression.is_some(), law != Law::Newton);
        assert!(compression.is_none_or(|compression| (compression - impulse / (1.0 + e)).abs() < 1e-15));
    }
}

#[test]
fn others_are_left_to_the_search() {
    let left = |change: fn(&mut Collision)| {
        let mut collision = bar(Law::Newton, 0.5);
        change(&mut collision);
        collision.of_single().is_none()
    };
    assert!(!left(|_| ()));
    let others: [fn(&mut Collision); 7] = [
        |it| it.rows[0] = Row::TwoSided,
        |it| it.rows[0] = it.rows[1],
        |it| it.rows[0] = Row::Tangent { of: 1 },
        |it| it.rows[1] = Row::TwoSided,
        |it| it.applied[2] = 1e-3,
        |it| it.rates[1] = 0.1,
        |it| it.mass[(1, 1)] = 0.0,
    ];
    for (k, change) in others.into_iter().enumerate() {
        assert!(left(change), "{k}");
    }
    let mut departs = bar(Law::Newton, 0.5);
    departs.jacobian.row_mut(0).fill(0.0);
    departs.rates[1] = 0.1;
    assert_eq!(departs.solve().map(|outcome| outcome.impulses[1]), Ok::<_, CollisionError>(0.0));
}

/// Δu = 1e20 v/2 of the second coordinate is no number, although the impulse is one.
#[test]
fn rates_beyond_all_numbers_are_left_to_the_search() {
    let collision = |speed: f64| Collision {
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1e-40])),
        jacobian: DMatrix::from_row_slice(1, 2, &[1.0, 1e-20]),
        rates: DVector::from_row_slice(&[-speed, 0.0]),
        drift: DVector::zeros(1),
        applied: DVector::zeros(2),
        rows: vec![Row::Contact { restitution: 0.5, law: Law::Newton }],
    };
    let found = collision(1.0).of_single().unwrap();
    assert!((found.rates[1] / 0.75e20 - 1.0).abs() < 1e-14 && (found.impulses[0] - 0.75).abs() < 1e-15);
    assert!(collision(1e295).of_single().is_none());
}

proptest! {
    /// M = L Lᵀ + 1, of up to four coordinates; the search finds the same.
    #[test]
    fn it_is_what_the_search_finds(n in 1_usize..5, numbers in prop::collection::vec(-1.0..1.0_f64, 24), e in 0.0..1.0_f64) {
        let root = DMatrix::from_fn(n, n, |i, j| numbers[4 * i + j]);
        let collision = Collision {
            mass: &root * root.transpose() + DMatrix::identity(n, n),
            jacobian: DMatrix::from_fn(1, n, |_, j| numbers[16 + j]),
            rates: DVector::from_fn(n, |i, _| numbers[20 + i]),
            drift: DVector::zeros(1),
            applied: DVector::zeros(n),
            rows: vec![Row::Contact { restitution: e, law: Law::Poisson }],
        };
        let Some(found) = collision.of_single() else { return Ok(()) };
        let searched = collision.searched_within(usize::MAX).unwrap();
        for (own, other) in [(&found.rates, &searched.rates), (&found.impulses, &searched.impulses), (&found.opening, &searched.opening)] {
            prop_assert!((own - other).amax() < 1e-13 * own.amax().max(1.0), "{own} {other}");
        }
        prop_assert!((found.gained - searched.gained).abs() < 1e-13 * found.gained.abs().max(1.0));
        prop_assert_eq!(found.acting, searched.acting);
    }
}
