//! Linear equations in double-double: Gaussian elimination with partial pivoting by rows scaled to their largest entry
//! (Golub and Van Loan, *Matrix Computations*, 3.4).

use liftoff::scalar::{DoubleDouble, Real, Scalar};

/// Pivots below this part of their row depend on the others: their unknown is zero.
const DEPENDENT: f64 = 1e-24;

/// x of A x = b; rows of A carry b as their last entry.
pub(super) fn solve(mut rows: Vec<Vec<DoubleDouble>>) -> Vec<DoubleDouble> {
    let n = rows.len();
    rows.iter_mut().for_each(|row| scale(row));
    let mut pivots = vec![None; n];
    let mut top = 0;
    for column in 0..n {
        let weight = |row: &Vec<DoubleDouble>| row[column].abs().to_f64();
        let best = (top..n).max_by(|&a, &b| weight(&rows[a]).total_cmp(&weight(&rows[b])));
        let Some(best) = best.filter(|&row| weight(&rows[row]) > DEPENDENT) else { continue };
        rows.swap(top, best);
        let (above, below) = rows.split_at_mut(top + 1);
        for row in below {
            let factor = -(row[column] / above[top][column]);
            for (x, &p) in row.iter_mut().zip(&above[top]).skip(column) {
                *x = factor.mul_add(p, *x);
            }
        }
        pivots[column] = Some(top);
        top += 1;
    }
    let mut x = vec![DoubleDouble::ZERO; n];
    for column in (0..n).rev() {
        if let Some(row) = pivots[column] {
            let known = (column + 1..n).fold(rows[row][n], |rest, j| rest - rows[row][j] * x[j]);
            x[column] = known / rows[row][column];
        }
    }
    x
}

/// Divides a row by its largest coefficient, the right-hand side apart.
fn scale(row: &mut [DoubleDouble]) {
    let coefficients = row.split_last().map_or(&[][..], |(_, coefficients)| coefficients);
    let largest = coefficients.iter().fold(0.0, |most: f64, x| most.max(x.abs().to_f64()));
    if largest > 0.0 {
        row.iter_mut().for_each(|x| *x = *x / DoubleDouble::from_f64(largest));
    }
}
