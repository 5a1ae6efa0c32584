//! Linear equations: Gaussian elimination with partial pivoting by rows scaled to their largest
//! entry (Golub and Van Loan, *Matrix Computations*, 3.4).

use crate::Number;

/// Pivots below so many roundings of their row depend on the others: their unknown is zero.
const DEPENDENT: f64 = 4e7;

/// x of A x = b; rows of A carry b as their last entry.
pub(crate) fn solve<S: Number>(mut rows: Vec<Vec<S>>) -> Vec<S> {
    let n = rows.len();
    rows.iter_mut().for_each(|row| scale(row));
    let mut pivots = vec![None; n];
    let mut top = 0;
    for column in 0..n {
        let weight = |row: &Vec<S>| row[column].abs().to_f64();
        let best = (top..n).max_by(|&a, &b| weight(&rows[a]).total_cmp(&weight(&rows[b])));
        let Some(best) = best.filter(|&row| weight(&rows[row]) > DEPENDENT * S::EPSILON.to_f64()) else {
            continue;
        };
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
    let mut x = vec![S::ZERO; n];
    for column in (0..n).rev() {
        if let Some(row) = pivots[column] {
            let known = (column + 1..n).fold(rows[row][n], |rest, j| rest - rows[row][j] * x[j]);
            x[column] = known / rows[row][column];
        }
    }
    x
}

/// Divides a row by its largest coefficient, the right-hand side apart.
fn scale<S: Number>(row: &mut [S]) {
    let coefficients = row.split_last().map_or(&[][..], |(_, coefficients)| coefficients);
    let largest = coefficients.iter().fold(0.0, |most: f64, x| most.max(x.abs().to_f64()));
    if largest > 0.0 {
        row.iter_mut().for_each(|x| *x = *x / S::from_f64(largest));
    }
}
