//! Rows that share coordinates, or depend on each other.

use nalgebra::DMatrix;

use super::super::closed_rows::ClosedRows;
use super::super::complementarity::LcpRows;
use crate::model::Friction;

fn rows(jacobian: &[[f64; 4]]) -> ClosedRows {
    let jacobian = DMatrix::from_fn(jacobian.len(), 4, |i, j| jacobian[i][j]);
    let count = jacobian.nrows();
    ClosedRows {
        rows: (0..count).map(|k| 20 + k).collect(),
        jacobian,
        levers: (0..count).map(|k| k as f64).collect(),
    }
}

/// Rows 20 and 22 share coordinates with 24, which is alike to their sum; 21 and 23 are of other
/// ones.
#[test]
fn rows_that_share_a_load() {
    let all = rows(&[
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 2.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0],
        [1.0, 2.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 3.0],
    ]);
    assert_eq!(all.undetermined(), [true, false, true, false, true, false]);
    assert_eq!((all.find_index(22), all.find_index(19), all.find_index(26)), (Some(2), None, None));
    for (asked, kept) in
        [(20, vec![0, 2, 4]), (24, vec![0, 2, 4]), (21, vec![1]), (23, vec![3]), (25, vec![5])]
    {
        let connected = all.connected_with(|row| row == asked);
        assert_eq!(connected.rows, kept.iter().map(|k| 20 + k).collect::<Vec<_>>(), "{asked}");
        assert_eq!(connected.levers, kept.iter().map(|k| *k as f64).collect::<Vec<_>>());
        assert_eq!(connected.jacobian, all.jacobian.select_rows(&kept));
    }
    assert!(all.connected_with(|_| false).rows.is_empty());
}

/// J_N − σ μ J_t in the place of J_N, and nothing in that of J_t.
#[test]
fn a_sliding_contact_has_one_bent_row() {
    let [normal, tangent, other] = [[1.0, 2.0, 0.0, 3.0], [0.5, -1.0, 4.0, 0.0], [7.0, 0.0, 0.0, 1.0]];
    let mut bent = rows(&[normal, other, tangent]);
    bent.bend(Friction { contact: 20, row: 22, follows_slip: false }, -0.25);
    let expected = core::array::from_fn(|j| normal[j] + 0.25 * tangent[j]);
    assert_eq!(bent.jacobian, rows(&[expected, other, [0.0; 4]]).jacobian);
    let mut open = rows(&[normal, other]);
    open.bend(Friction { contact: 20, row: 22, follows_slip: false }, -0.25);
    assert_eq!(open.jacobian, rows(&[normal, other]).jacobian);
}

/// Fixed rows, closed candidates and what is tied to either, in ascending order.
#[test]
fn rows_are_closed_with_what_is_tied_to_them() {
    let rows = LcpRows { fixed: &[5, 1], candidates: &[2, 6], tied: &[(7, 5), (3, 2), (4, 6)], trials: None };
    assert_eq!(rows.rows(&[]), [1, 5, 7]);
    assert_eq!(rows.rows(&[2]), [1, 2, 3, 5, 7]);
    assert_eq!(rows.rows(&[6, 2]), [1, 2, 3, 4, 5, 6, 7]);
    assert_eq!((rows.tied_to(&[6]), rows.tied_to(&[1])), (vec![4], vec![]));
    assert_eq!([5, 1, 2, 6, 7].map(|row| rows.is_rough(row)), [true, false, true, true, false]);
}
