//! Coordinates without mass, or with little.

use nalgebra::{DMatrix, DVector};

use super::solve;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::contact::trials::LcpError;

/// A massless coordinate pressed against a contact stays there; pulled away from it, its
/// acceleration is undetermined.
#[test]
fn pulled_massless_points_have_no_motion() {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[2.0, 0.0]));
    let jacobian = DMatrix::from_row_slice(1, 2, &[0.0, 1.0]);
    let found = |force: f64| solve(&mass, &jacobian, &[-1.0, force], &[0.0]);
    let pressed = found(-0.5).unwrap();
    assert_eq!(pressed.active_basis, [0]);
    assert!((pressed.reactions[0] - 0.5).abs() < 1e-14 && (pressed.accelerations[0] + 0.5).abs() < 1e-14);
    assert_eq!(found(0.5).unwrap_err(), LcpError::Singular);
    // Tied to a mass it has the acceleration of the mass, and still leaves the contact.
    let tied = DMatrix::from_row_slice(1, 2, &[1.0, -1.0]);
    assert_eq!(solve(&mass, &tied, &[-1.0, -0.5], &[-0.25]).unwrap_err(), LcpError::Singular);
}

/// Massless bodies without load stay on their contacts with zero reaction, even if there are more
/// contacts than sets to be tried; a mass beside them leaves its contact.
#[test]
fn massless_bodies_rest_on_their_contacts_unpressed() {
    for count in [1, 3, 17] {
        let mass = DMatrix::from_fn(count, count, |i, j| f64::from(u8::from(i == 0 && j == 0)));
        let jacobian = DMatrix::identity(count, count);
        for (push, bearing) in [(1.0, vec![]), (-1.0, vec![0])] {
            let force: Vec<f64> = (0..count).map(|j| if j == 0 { push } else { 0.0 }).collect();
            let found = solve(&mass, &jacobian, &force, &vec![0.0; count]).unwrap();
            assert_eq!((found.active_basis, found.degenerate), (bearing, (1..count).collect()), "{count}");
            assert!((found.accelerations[0] - f64::max(push, 0.0)).abs() < 1e-14, "{count}");
            assert!((found.reactions[0] - f64::max(-push, 0.0)).abs() < 1e-14, "{count}");
            assert!(found.unique && found.accelerations.rows(1, count - 1).iter().all(|a| a.abs() < 1e-14));
        }
    }
}

/// M a = f for two coordinates with correlation 1 − δ, beside others held by many contacts. The
/// accelerations are undetermined if the least singular value is below √ε times the largest one,
/// which belongs to the contacts.
#[test]
fn half_of_the_digits_are_asked_of_accelerations() {
    for contacts in [0, 1, 100] {
        // The least singular value is δ. The largest is 2, or that of a unit mass with `rows` unit
        // rows.
        let rows = contacts as f64;
        let largest = f64::max(2.0, 0.5 + (0.25 + rows).sqrt());
        let cutoff = f64::EPSILON.sqrt() * largest;
        for (part, free) in [(0.1, vec![1, 2]), (10.0, vec![])] {
            let mut mass = DMatrix::identity(3, 3);
            (mass[(1, 2)], mass[(2, 1)]) = (1.0 - part * cutoff, 1.0 - part * cutoff);
            let jacobian = DMatrix::from_fn(contacts, 3, |_, j| if j == 0 { 1.0 } else { 0.0 });
            let (force, bias) = (DVector::zeros(3), DVector::zeros(contacts));
            let problem = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force, &bias));
            assert_eq!(problem.undetermined(&(0..contacts).collect::<Vec<_>>()), free, "{contacts} {part}");
        }
    }
}

/// A single massless coordinate is undetermined, unless a row holds it.
#[test]
fn a_coordinate_without_mass_alone_is_undetermined() {
    let undetermined = |entry: f64| {
        let (mass, jacobian) = (DMatrix::zeros(1, 1), DMatrix::from_element(1, 1, entry));
        let none = DVector::zeros(1);
        let problem = EquilibratedKkt::new(&mass, &jacobian, (&none, &none), (&none, &none));
        [problem.undetermined(&[]), problem.undetermined(&[0])]
    };
    assert_eq!(undetermined(0.0), [[0], [0]]);
    assert_eq!(undetermined(1e-7), [vec![0], vec![]]);
}

/// The null vector of inertia is (1, 1, k) in equilibrated coordinates: the third is not named if k
/// is below a tenth.
#[test]
fn coordinates_that_hardly_move_are_not_named() {
    for (k, free) in [(0.5, vec![0, 1, 2]), (0.11, vec![0, 1, 2]), (0.09, vec![0, 1]), (0.0, vec![0, 1])] {
        let (one, two) = (-0.5 * k, -1.0 + 0.5 * k * k);
        let mass = DMatrix::from_row_slice(3, 3, &[1.0, two, one, two, 1.0, one, one, one, 1.0]);
        let (none, bias) = (DVector::zeros(3), DVector::zeros(0));
        let problem = EquilibratedKkt::new(&mass, &DMatrix::zeros(0, 3), (&none, &bias), (&none, &bias));
        assert_eq!(problem.undetermined(&[]), free, "{k}");
    }
}
