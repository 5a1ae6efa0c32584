//! The law of several contacts without friction, and the work that they do.

use nalgebra::{DMatrix, DVector};

use crate::contact::friction::tests::random::{Random, cases};
use crate::contact::impulse::{Collision, CollisionError, Outcome, Row};
use crate::model::Law::{self, Newton, Poisson, Stronge};

const E: f64 = 0.6;

/// Two particles over a floor, each with a law, coupled by an entry of the mass matrix or not.
fn particles(rates: [f64; 2], laws: [Law; 2], coupling: f64) -> Result<Outcome, CollisionError> {
    Collision {
        mass: DMatrix::from_row_slice(2, 2, &[1.0, coupling, coupling, 1.0]),
        jacobian: DMatrix::identity(2, 2),
        rates: DVector::from_row_slice(&rates),
        prescribed_gap_rate: DVector::zeros(2),
        applied: DVector::zeros(2),
        rows: laws.map(|law| Row::Contact { restitution: E, law }).to_vec(),
    }
    .solve()
}

/// The law of those that act; Poisson's where others depart, or where one that acts declares it;
/// Stronge's of one alone. An impulse on one lifts the other.
#[test]
fn coupled_contacts_that_act_have_one_law() {
    let several = Err(CollisionError::Several);
    for (rates, laws, expected) in [
        ([-1.0, -1.5], [Newton, Newton], Ok(Newton)),
        ([-1.0, -1.5], [Newton, Poisson], Ok(Poisson)),
        ([-1.0, -1.5], [Poisson, Newton], Ok(Poisson)),
        ([-1.0, -1.5], [Poisson, Poisson], Ok(Poisson)),
        ([-1.0, -1.5], [Stronge, Newton], several),
        ([-1.0, -1.5], [Poisson, Stronge], several),
        ([-1.0, -1.5], [Stronge, Stronge], several),
        ([-1.0, 1.0], [Newton, Newton], Ok(Poisson)),
        ([-1.0, 1.0], [Stronge, Newton], Ok(Stronge)),
        ([-1.0, 1.0], [Stronge, Stronge], Ok(Stronge)),
        ([-1.0, 1.0], [Newton, Stronge], Ok(Poisson)),
        ([-1.0, 0.0], [Newton, Newton], Ok(Newton)),
        ([-1.0, 0.0], [Poisson, Newton], Ok(Poisson)),
        ([-1.0, 0.0], [Newton, Poisson], Ok(Newton)),
        ([-1.0, 0.0], [Stronge, Newton], Ok(Stronge)),
        ([-1.0, 0.0], [Stronge, Poisson], Ok(Stronge)),
        ([-1.0, 0.0], [Newton, Stronge], Ok(Newton)),
        ([-1.0, 0.0], [Poisson, Stronge], Ok(Poisson)),
        ([1.0, 0.0], [Newton, Newton], Ok(Poisson)),
        ([0.0, 0.0], [Newton, Poisson], Ok(Newton)),
    ] {
        let found = particles(rates, laws, -0.5);
        assert_eq!(found.as_ref().map(|it| it.law).map_err(|error| *error), expected, "{rates:?} {laws:?}");
        let Ok(found) = found else { continue };
        for k in 0..2 {
            let strikes = rates[k] < 0.0;
            assert_eq!(found.acting.contains(&k), strikes, "{rates:?} {laws:?}");
            assert!(!strikes || found.law != Newton || (found.rates[k] + E * rates[k]).abs() < 1e-15);
            assert_eq!(found.compression.is_some(), found.law != Newton, "{rates:?} {laws:?}");
        }
        assert!(found.factor == 1.0 && found.unique && found.groups.is_empty(), "{rates:?} {laws:?}");
    }
}

/// Contacts that nothing couples are struck as if each were alone, whatever law the other has.
#[test]
fn uncoupled_contacts_have_their_own_laws() {
    for laws in
        [Newton, Poisson, Stronge].map(|one| [Newton, Poisson, Stronge].map(|other| [one, other])).concat()
    {
        for rates in [[-1.0, -2.0], [-1.0, 0.0], [-1.0, 1.0], [0.0, -1.0], [1.0, 0.0]] {
            let found = particles(rates, laws, 0.0).unwrap();
            for k in 0..2 {
                let strikes = rates[k] < 0.0;
                let after = if strikes { -E * rates[k] } else { rates[k] };
                assert!((found.rates[k] - after).abs() < 1e-15, "{rates:?} {laws:?}");
                assert!((found.impulses[k] - (after - rates[k])).abs() < 1e-15, "{rates:?} {laws:?}");
                assert!((found.opening[k] - after).abs() < 1e-15, "{rates:?} {laws:?}");
                assert_eq!(found.acting.contains(&k), strikes, "{rates:?} {laws:?}");
            }
            let apart: Vec<Law> = found.groups.iter().map(|group| group.outcome.law).collect();
            assert_eq!(apart, if rates[0] * rates[1] > 0.0 { laws.to_vec() } else { Vec::new() });
            let kinetic = |u: &[f64]| 0.5 * u.iter().map(|u| u * u).sum::<f64>();
            let change = kinetic(found.rates.as_slice()) - kinetic(&rates);
            assert!((found.gained - change).abs() < 1e-15, "{rates:?} {laws:?}");
        }
    }
}

/// A rough contact has Stronge's law as it has Poisson's, two that act have none.
#[test]
fn rough_contacts_have_stronge_s_law_alone() {
    let law = Stronge;
    let struck = |second: Row, coupling: f64| {
        Collision {
            mass: DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, coupling, 0.0, coupling, 1.0]),
            jacobian: DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
            rates: DVector::from_row_slice(&[0.3, -1.0, -2.0]),
            prescribed_gap_rate: DVector::zeros(3),
            applied: DVector::zeros(3),
            rows: vec![Row::Contact { restitution: E, law }, Row::Tangent { of: 0 }, second],
        }
        .solve()
    };
    let alone = struck(Row::Open, 0.0).unwrap();
    assert_eq!((alone.law, alone.factor), (Stronge, 1.0));
    assert!((alone.rates - DVector::from_row_slice(&[0.0, E, -2.0])).amax() < 1e-15);
    let gained = 0.5 * (E * E - 1.0 - 0.09);
    assert!((alone.gained - gained).abs() < 1e-15, "{}", alone.gained);
    let second = Row::Contact { restitution: E, law };
    assert_eq!(struck(second, -0.2).unwrap_err(), CollisionError::Several);
    let apart = struck(second, 0.0).unwrap();
    assert!((apart.rates - DVector::from_row_slice(&[0.0, E, 2.0 * E])).amax() < 1e-15);
}

/// A plank on three feet shares what it bears in many ways, be it only while it is compressed.
#[test]
fn shared_impulses_are_reported_by_either_law() {
    for law in [Newton, Poisson] {
        for (feet, unique) in [(vec![0, 2], true), (vec![0, 1, 2], false)] {
            let row =
                |k: usize| if feet.contains(&k) { Row::Contact { restitution: E, law } } else { Row::Open };
            let found = Collision {
                mass: DMatrix::identity(2, 2),
                jacobian: DMatrix::from_row_slice(3, 2, &[1.0, -1.0, 1.0, 0.0, 1.0, 1.0]),
                rates: DVector::from_row_slice(&[-1.0, 0.0]),
                prescribed_gap_rate: DVector::zeros(3),
                applied: DVector::zeros(2),
                rows: (0..3).map(row).collect(),
            }
            .solve()
            .unwrap();
            assert!((found.rates - DVector::from_row_slice(&[E, 0.0])).amax() < 1e-14, "{law:?}");
            assert_eq!(found.unique, unique, "{law:?} {feet:?}");
        }
    }
}

/// Contacts with something applied from outside, which acts before them on what joints leave free:
/// what they gain is the kinetic energy after all less that after it alone, and never more than
/// nothing.
#[test]
fn contacts_gain_what_the_kinetic_energy_gains() {
    let mut random = Random(0x243F_6A88_85A3_08D3);
    let mut lost = 0;
    for k in 0..cases(300) {
        let (n, held, contacts) = (4, k % 2, 1 + k % 3);
        let r = held + contacts;
        let root = DMatrix::from_fn(n, n, |_, _| random.between(-1.0, 1.0));
        let mass = &root * root.transpose() + DMatrix::identity(n, n);
        let inverse = mass.clone().try_inverse().unwrap();
        let jacobian = DMatrix::from_fn(r, n, |_, _| random.between(-1.0, 1.0));
        // What the joint leaves of a change of the rates by an impulse.
        let row = jacobian.row(0).transpose();
        let by_joint = &inverse * &row;
        let left = |rates: DVector<f64>| match held {
            0 => rates,
            _ => &rates - &by_joint * (row.dot(&rates) / row.dot(&by_joint)),
        };
        let rates = left(DVector::from_fn(n, |_, _| random.between(-1.0, 1.0)));
        let applied = DVector::from_fn(n, |_, _| random.between(-2.0, 2.0)) * [0.0, 1.0, 1.0][k % 3];
        let law = [Newton, Poisson][(k / 2) % 2];
        let contact = Row::Contact { restitution: random.between(0.0, 1.0), law };
        let rows = (0..r).map(|row| if row < held { Row::TwoSided } else { contact }).collect();
        let before = &rates + left(&inverse * &applied);
        let it = Collision { mass, jacobian, rates, prescribed_gap_rate: DVector::zeros(r), applied, rows };
        let found = it.solve().unwrap();
        let kinetic = |u: &DVector<f64>| 0.5 * u.dot(&(&it.mass * u));
        let change = kinetic(&found.rates) - kinetic(&before);
        let size = 1.0 + found.impulses.amax().powi(2);
        assert!((found.gained - change).abs() < 1e-11 * size, "{k}: {} {change}", found.gained);
        assert!(found.gained <= 1e-12 * size, "{k}");
        lost += usize::from(found.gained < -1e-2);
    }
    assert!(lost > 100, "{lost}");
}
