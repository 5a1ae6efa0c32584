//! Tests of the steps that solve equilibrated KKT systems.

use nalgebra::{DMatrix, DVector};

use super::{EquilibratedKkt, is_regular, largest_in_part, parts, refined};

/// Pivots of a diagonal matrix are its entries, whatever their signs and units.
#[test]
fn a_matrix_is_regular_by_its_least_pivot() {
    let diagonal = |entries: &[f64]| DMatrix::from_diagonal(&DVector::from_row_slice(entries));
    for unit in [1e-20, 1.0, 1e20] {
        for (part, expected) in [(1.0, true), (1.1e-6, true), (0.9e-6, false), (0.0, false)] {
            for sign in [1.0, -1.0] {
                let matrix = diagonal(&[0.5 * unit, -2.0 * unit, sign * 2.0 * part * unit]);
                assert_eq!(is_regular(&matrix.full_piv_lu()), expected, "{unit} {part}");
            }
        }
    }
}

/// With `part` times the inverse, each of four refinements multiplies the residual by 1 − part; a
/// refinement that does not reduce it is discarded.
#[test]
fn solutions_are_refined_while_that_helps() {
    let matrix = DMatrix::from_row_slice(2, 2, &[3.0, 1.0, -1.0, 2.0]);
    let right = DVector::from_row_slice(&[1.0, -4.0]);
    let inverse = matrix.clone().try_inverse().unwrap();
    // Each step leaves 1 − part of the residual.
    for (part, left) in [(0.9, 1e-5), (1.2, -3.2e-4), (1.0, 0.0), (2.0, -1.0), (3.0, -2.0), (0.0, 1.0)] {
        let (x, rest) = refined(&matrix, &right, |b| Some(&inverse * b * part)).unwrap();
        assert!((&rest - &right * left).amax() < 1e-14, "{part}: {rest}");
        assert!((&inverse * (&right * (1.0 - left)) - &x).amax() < 1e-14, "{part}: {x}");
    }
    assert!(refined(&matrix, &right, |_| None).is_err());
}

/// Two rows prescribe accelerations of one coordinate that differ by 2 ε; each has a residual ε,
/// which counts as roundoff up to 1e-9 of the terms.
#[test]
fn rows_contradict_each_other_beyond_rounding() {
    for (mass, length) in [(1.0, 1.0), (1e-8, 1e5), (1e10, 1e-3)] {
        let consistent = |apart: f64| {
            let jacobian = DMatrix::from_element(2, 1, length);
            let bias = DVector::from_row_slice(&[1.0, 1.0 + 2.0 * apart]) * length;
            let (force, m) = (DVector::zeros(1), DMatrix::from_element(1, 1, mass));
            let problem = EquilibratedKkt::new(&m, &jacobian, (&force, &bias), (&force, &bias.abs()));
            let found = problem.attempt(&[0, 1]).unwrap();
            assert_eq!(found.nullity, 1);
            assert!((found.x[0] * problem.scale[0] + 1.0).abs() < 1e-5, "{mass} {length}");
            found.consistent
        };
        assert!(consistent(0.0) && consistent(0.9e-9) && !consistent(1.1e-9) && !consistent(-1.1e-9));
    }
}

/// Connected blocks of the matrix, numbered as they appear, with the largest entry of each.
#[test]
fn parts_are_what_entries_connect() {
    let pairs = [(0, 3), (3, 5), (1, 4)];
    let entry = |i: usize, j: usize| pairs.contains(&(i.min(j), i.max(j))) || i == j && i != 2;
    let matrix = DMatrix::from_fn(6, 6, |i, j| if entry(i, j) { -1e-9 } else { 0.0 });
    let found = parts(&matrix);
    assert_eq!(found, [0, 1, 2, 0, 1, 0]);
    let values = DVector::from_row_slice(&[1.0, 7.0, 0.5, 3.0, 2.0, 2.5]);
    assert_eq!(largest_in_part(&found, &values).as_slice(), [3.0, 7.0, 0.5, 3.0, 7.0, 3.0]);
}

/// Uncoupled bodies are solved separately: one on three rows of which any two suffice, one that
/// falls, one on a single row, in units that differ by many orders.
#[test]
fn parts_are_solved_for_themselves() {
    for heavy in [1e-12, 1.0, 1e12] {
        let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 2.0, heavy, 3.0]));
        let rows = [[1.0, -1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0]];
        let jacobian = DMatrix::from_fn(4, 4, |i, j| rows[i][j]);
        let force = DVector::from_row_slice(&[-3.0, 0.0, -5.0 * heavy, 6.0]);
        let bias = DVector::zeros(4);
        let problem = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
        assert_eq!(problem.parts, [0, 0, 1, 2, 0, 1, 0, 0]);
        let found = problem.attempt(&[0, 1, 2, 3]).unwrap();
        assert!(found.consistent && found.nullity == 1);
        let natural = |k: usize| found.x[k] * problem.scale[k];
        let accelerations: Vec<f64> = (0..4).map(natural).collect();
        assert!(accelerations[..3].iter().all(|a| a.abs() < 1e-14) && (accelerations[3] - 2.0).abs() < 1e-14);
        // λ₀ + λ₂ + λ₃ = 3 and λ₃ = λ₀: in the least-norm solution all are one.
        for (k, expected) in [(4, 1.0), (5, 5.0 * heavy), (6, 1.0), (7, 1.0)] {
            assert!((natural(k) / expected - 1.0).abs() < 1e-13, "{heavy} {k}: {}", natural(k));
        }
    }
}

/// The reactions of feet at xₖ under a unit weight at c are not unique; the least-norm ones are 1/n
/// + (c − x̄)(xₖ − x̄)/Σ(x − x̄)², however many there are.
#[test]
fn many_redundant_rows_share_a_load() {
    for count in [2, 3, 30, 120] {
        let c = 0.37 * f64::from(count);
        let feet = count as usize;
        let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 7.0]));
        let jacobian = DMatrix::from_fn(feet, 2, |foot, j| if j == 0 { 1.0 } else { foot as f64 - c });
        let (force, bias) = (DVector::from_row_slice(&[-1.0, 0.0]), DVector::zeros(feet));
        let problem = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
        let found = problem.attempt(&(0..feet).collect::<Vec<_>>()).unwrap();
        assert!(found.consistent && found.nullity == feet - 2, "{count} {}", found.nullity);
        let mean = 0.5 * f64::from(count - 1);
        let spread: f64 = (0..count).map(|foot| (f64::from(foot) - mean).powi(2)).sum();
        for foot in 0..count {
            let expected = 1.0 / f64::from(count) + (c - mean) * (f64::from(foot) - mean) / spread;
            let place = 2 + foot as usize;
            let natural = found.x[place] * problem.scale[place];
            assert!((natural - expected).abs() < 1e-12, "{count} {foot}: {natural} {expected}");
        }
        assert!(found.x.rows(0, 2).amax() < 1e-12, "{count}");
    }
}

/// A selection of rows keeps the block numbers, with gaps.
#[test]
fn parts_of_a_selection_keep_their_numbers() {
    let largest = largest_in_part(&[7, 2, 7], &DVector::from_row_slice(&[1.0, 5.0, 3.0]));
    assert_eq!(largest.as_slice(), [3.0, 5.0, 3.0]);
    assert!(largest_in_part(&[], &DVector::zeros(0)).is_empty());
}
