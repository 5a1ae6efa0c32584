//! Against a bar's impulse by hand, and the search on random impacts.

use super::*;
use crate::contact::impulse::CollisionError;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

/// A bar of mass m and length l, level, one end of which strikes a floor at the speed v: W = 1/m +
/// 12 (l/2)²/(m l²) = 4/m.
fn bar(law: Law, e: f64) -> Collision {
    let (m, l, v) = (2.0, 3.0, 0.7);
    Collision {
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[m, m, m * l * l / 12.0])),
        jacobian: DMatrix::from_row_slice(2, 3, &[f64::NAN, 1.0, 0.0, 0.0, 1.0, -0.5 * l]),
        rates: DVector::from_row_slice(&[0.3, -v, 0.0]),
        prescribed_gap_rate: DVector::zeros(2),
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
        prescribed_gap_rate: DVector::zeros(1),
        applied: DVector::zeros(2),
        rows: vec![Row::Contact { restitution: 0.5, law: Law::Newton }],
    };
    let found = collision(1.0).of_single().unwrap();
    assert!((found.rates[1] / 0.75e20 - 1.0).abs() < 1e-14 && (found.impulses[0] - 0.75).abs() < 1e-15);
    assert!(collision(1e295).of_single().is_none());
}

/// M = L Lᵀ + 1, and the numbers of rows and rates; the second row without a velocity.
fn drawn(n: usize, numbers: &[f64], rows: Vec<Row>) -> Collision {
    let root = DMatrix::from_fn(n, n, |i, j| numbers[4 * i + j]);
    let rates = DVector::from_fn(n, |i, _| numbers[16 + i]);
    let mut jacobian = DMatrix::from_fn(rows.len(), n, |row, j| numbers[20 + 4 * row + j]);
    if let Some(at_rest) = (1 < rows.len()).then(|| jacobian.row(1).transpose()) {
        let along = at_rest.dot(&rates) / rates.norm_squared();
        jacobian.set_row(1, &(at_rest - along * &rates).transpose());
    }
    let mass = &root * root.transpose() + DMatrix::identity(n, n);
    Collision {
        mass,
        jacobian,
        rates,
        prescribed_gap_rate: DVector::zeros(rows.len()),
        applied: DVector::zeros(n),
        rows,
    }
}

/// Numbers differ by less than `part` of the largest of their kind.
fn assert_is_searched(collision: &Collision, found: &Outcome, part: f64) -> Result<(), TestCaseError> {
    let searched = collision.search::<true>(usize::MAX).unwrap();
    let close = |own: &DVector<f64>, other: &DVector<f64>| (own - other).amax() < part * own.amax().max(1.0);
    for (own, other) in [
        (&found.rates, &searched.rates),
        (&found.impulses, &searched.impulses),
        (&found.opening, &searched.opening),
    ] {
        prop_assert!(close(own, other), "{own} {other}");
    }
    let zeros = |outcome: &Outcome| outcome.opening.map(|speed| speed == 0.0);
    // Impulses of a hundred times the rates stand for rows that all but depend on each other:
    // rounding is beyond what counts as zero.
    if found.impulses.amax() < 10.0 {
        prop_assert_eq!(zeros(found), zeros(&searched));
    }
    prop_assert!((found.gained - searched.gained).abs() < part * found.gained.abs().max(1.0));
    prop_assert_eq!(&found.acting, &searched.acting);
    prop_assert_eq!((found.law, found.method), (searched.law, searched.method));
    let compressed = [found, &searched].map(|it| it.compression.clone().map(|(rates, _)| rates));
    if let [Some(own), Some(other)] = &compressed {
        prop_assert!(close(own, other), "{own} {other}");
    }
    prop_assert_eq!(compressed[0].is_some(), compressed[1].is_some());
    Ok(())
}

const LAWS: [Law; 3] = [Law::Newton, Law::Poisson, Law::Stronge];

proptest! {
    /// Of up to four coordinates; the search finds the same.
    #[test]
    fn it_is_what_the_search_finds(n in 1_usize..5, numbers in prop::collection::vec(-1.0..1.0_f64, 24), e in 0.0..1.0_f64) {
        let collision = drawn(n, &numbers, vec![Row::Contact { restitution: e, law: Law::Poisson }]);
        let Some(found) = collision.of_single() else { return Ok(()) };
        assert_is_searched(&collision, &found, 1e-13)?;
    }

    /// Beside a contact at rest and one that departs or not, with friction, by each law.
    #[test]
    fn it_is_what_the_search_finds_with_friction(
        n in 2_usize..5,
        numbers in prop::collection::vec(-1.0..1.0_f64, 44),
        (e, mu, law) in (prop::sample::select(vec![0.0, 0.6, 1.0]), 0.0..1.5_f64, prop::sample::select(LAWS.to_vec())),
    ) {
        let contact = Row::Contact { restitution: e, law };
        let friction = |of: usize| Row::Friction { of, mu, restitution: 0.0 };
        let rows = vec![contact, contact, contact, friction(0), friction(1), friction(2)];
        let collision = drawn(n, &numbers, rows);
        let Some(found) = collision.of_single() else { return Ok(()) };
        // Towards W_NN = σ μ W_Nt impulses grow beyond all bounds, and their rounding with them.
        assert_is_searched(&collision, &found, 1e-12 * found.impulses.amax().max(1.0))?;
    }
}
