//! The active set method by itself: what it ends with bears, and nothing else opens.

use nalgebra::{DMatrix, DVector};

use crate::contact::active_rows::ActiveRows;
use crate::contact::friction::tests::random::{Random, cases};
use crate::contact::least_constraint::LeastConstraint;
use crate::contact::trials::LcpError;

/// Accelerations and multipliers with some rows closed.
fn closed(
    mass: &DMatrix<f64>,
    jacobian: &DMatrix<f64>,
    (force, bias): (&DVector<f64>, &DVector<f64>),
    rows: &[usize],
) -> (DVector<f64>, DVector<f64>) {
    let (j, b) = (jacobian.select_rows(rows), bias.select_rows(rows));
    let inverse = mass.clone().try_inverse().unwrap();
    let free = &inverse * force;
    let w = &j * &inverse * j.transpose();
    let multipliers = match rows.is_empty() {
        true => DVector::zeros(0),
        false => w.lu().solve(&-(&j * &free + b)).unwrap(),
    };
    (free + inverse * j.tr_mul(&multipliers), multipliers)
}

/// More contacts than any other way could decide, of which many depend on each other: fixed rows
/// hold, candidates bear or open.
#[test]
fn active_basis_holds_all_others() {
    let mut random = Random(0x1F83_D9AB_5BE0_CD19);
    let mut bearing = 0;
    for k in 0..cases(400) {
        let (n, fixed, candidates) = (3 + random.below(4), random.below(3), 1 + 3 * (k % 9));
        let r = fixed + candidates;
        let entry = |random: &mut Random| match k % 2 {
            0 => random.between(-1.0, 1.0),
            _ => random.below(3) as f64 - 1.0,
        };
        let root = DMatrix::from_fn(n, n, |_, _| random.between(-1.0, 1.0));
        let mass = &root * root.transpose() + DMatrix::identity(n, n);
        let unit = |i: usize| 1.0 / mass[(i, i)].sqrt();
        let mass = DMatrix::from_fn(n, n, |i, j| mass[(i, j)] * unit(i) * unit(j));
        let jacobian = DMatrix::from_fn(r, n, |_, _| entry(&mut random));
        let force = DVector::from_fn(n, |_, _| 3.0 * random.between(-1.0, 1.0));
        // Some accelerations meet all conditions, those of many contacts with zero.
        let meets = DVector::from_fn(n, |_, _| entry(&mut random));
        let opening = DVector::from_fn(r, |row, _| if row < fixed { 0.0 } else { random.below(3) as f64 });
        let bias = opening - &jacobian * &meets;
        let slack = DVector::repeat(r, 1e-12);
        let least = LeastConstraint::new(&mass, &jacobian, (&force, &bias), &slack).unwrap();
        let (held, asked): (Vec<usize>, Vec<usize>) = (0..r).partition(|row| *row < fixed);
        let rows = least.find_active_basis(&held, &asked).unwrap();
        let (a, multipliers) = closed(&mass, &jacobian, (&force, &bias), &rows);
        let openings = &jacobian * &a + &bias;
        for row in 0..r {
            let small = 1e-8 * (1.0 + a.amax());
            assert!(openings[row] >= -small && (row >= fixed || openings[row] <= small), "{k}: {openings}");
        }
        for (row, multiplier) in rows.iter().zip(multipliers.iter()) {
            assert!(*row < fixed || *multiplier >= -1e-8, "{k}: {multipliers}");
            bearing += usize::from(*row >= fixed);
        }
    }
    assert!(bearing > 400, "{bearing}");
}

/// 0 ≤ a − 1 and 0 ≤ −a + 1 − ε contradict each other by ε, which is rounding up to a part of their
/// terms.
#[test]
fn contacts_contradict_each_other_beyond_rounding() {
    for size in [1e-6, 1.0, 1e6] {
        let bearing = |excess: f64| {
            let jacobian = DMatrix::from_row_slice(2, 1, &[1.0, -1.0]);
            let (force, bias) = (DVector::zeros(1), DVector::from_row_slice(&[-size, size * (1.0 - excess)]));
            let slack = DVector::repeat(2, 1e-12 * size);
            let mass = DMatrix::identity(1, 1);
            LeastConstraint::new(&mass, &jacobian, (&force, &bias), &slack)
                .unwrap()
                .find_active_basis(&[], &[0, 1])
        };
        assert_eq!(bearing(0.0), Ok(vec![0]));
        assert_eq!(bearing(1e-10), Ok(vec![0]));
        assert_eq!(bearing(1e-7), Err(LcpError::Jammed));
    }
}

/// Unit vectors, of which some depend on others, put in and taken out: what is in is independent,
/// and any vector is the sum of its combination of these and of what is independent of them.
#[test]
fn vectors_split_into_what_depends_and_what_does_not() {
    let mut random = Random(0x428A_2F98_D728_AE22);
    let mut removed = 0;
    for k in 0..cases(300) {
        let n = 2 + k % 4;
        let mut whole = || DVector::from_fn(n, |_, _| random.below(5) as f64 - 2.0 + 1e-3);
        let vectors: Vec<DVector<f64>> = (0..8).map(|_| whole().normalize()).collect();
        let mut active = ActiveRows::default();
        for (row, vector) in vectors.iter().enumerate() {
            let depends = active.split(vector).depends();
            assert_eq!(active.push(row, vector), !depends, "{k}");
            if row == 4 {
                let place = k % active.rows.len();
                active.remove(place);
                removed += 1;
            }
            let within = DMatrix::from_columns(&vectors[..=row]).select_columns(&active.rows);
            let smallest = within.tr_mul(&within).symmetric_eigenvalues().min();
            assert!(smallest > 1e-13, "{k}: {smallest:e}");
            for vector in &vectors {
                let split = active.split(vector);
                let combination = DVector::from_vec(active.combination(&split));
                let size = 1.0 + combination.amax();
                assert!((&within * combination + &split.independent - vector).amax() < 1e-13 * size, "{k}");
                assert!(within.tr_mul(&split.independent).amax() < 1e-13, "{k}");
            }
        }
    }
    assert!(removed > 0);
}

/// Rows of any length, of which each pair is independent, and the same that bear.
#[test]
fn lengths_of_rows_do_not_matter() {
    let mass = DMatrix::identity(2, 2);
    let rows = DMatrix::from_row_slice(3, 2, &[1.0, 0.0, 0.6, 0.8, 0.0, 1.0]);
    let force = DVector::from_row_slice(&[-1.0, -2.0]);
    for unit in [1e-7, 1.0, 1e7] {
        let least = |bias: f64, force: &DVector<f64>, slack: f64| {
            let (bias, slack) = (DVector::repeat(3, bias * unit), DVector::repeat(3, slack * unit));
            LeastConstraint::new(&mass, &(&rows * unit), (force, &bias), &slack).unwrap()
        };
        let pressed = least(0.0, &force, 1e-12);
        assert_eq!(pressed.independent(&[0, 1, 2]), [0, 1], "{unit}");
        assert_eq!(pressed.independent(&[2, 0]), [2, 0], "{unit}");
        let bearing = pressed.find_active_basis(&[], &[0, 1, 2]).unwrap();
        let (a, multipliers) = closed(&mass, &(&rows * unit), (&force, &DVector::zeros(3)), &bearing);
        assert!(a.amax() < 1e-14 && multipliers.min() > 0.0 && bearing.len() == 2, "{unit}: {bearing:?}");
        // What nothing presses on does not bear.
        let still = least(0.0, &DVector::zeros(2), 0.0);
        assert!(still.find_active_basis(&[], &[0, 1, 2]).unwrap().is_empty(), "{unit}");
        assert!(least(1.0, &DVector::zeros(2), 0.0).find_active_basis(&[], &[0, 1, 2]).unwrap().is_empty());
    }
}

/// What has no inertia moves without bounds under any force, whatever openings there are besides.
#[test]
fn without_inertia_forces_decide() {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 0.0]));
    let jacobian = DMatrix::from_row_slice(1, 2, &[0.0, 1.0]);
    for (push, bears) in [(-1e-3, true), (1e-3, false)] {
        let (force, slack) = (DVector::from_row_slice(&[0.0, push]), DVector::from_element(1, 1e-12));
        for opening in [1.0, -1.0, 0.0] {
            let bias = DVector::from_element(1, opening);
            let least = LeastConstraint::new(&mass, &jacobian, (&force, &bias), &slack).unwrap();
            assert_eq!(!least.find_active_basis(&[], &[0]).unwrap().is_empty(), bears, "{push} {opening}");
        }
    }
}

/// What is pushed is what does not depend on others, at the very limit too.
#[test]
fn a_vector_at_the_limit_is_reported_alike() {
    for (part, depends) in [(0.99e-10, true), (1e-10, true), (1.01e-10, false)] {
        let mut active = ActiveRows::default();
        assert!(active.push(0, &DVector::from_row_slice(&[1.0, 0.0])));
        let other = DVector::from_row_slice(&[1.0, part]);
        assert_eq!(active.split(&other).depends(), depends, "{part}");
        assert_eq!(active.push(1, &other), !depends, "{part}");
    }
}
