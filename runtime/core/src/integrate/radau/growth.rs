//! How fast a motion grows at most: the largest real part of the eigenvalues of a Jacobian, by
//! Francis's QR steps (Golub & Van Loan, *Matrix Computations*, 4th ed., 7.4, 7.5).
//!
//! Radau's R(z) has a pole at z = γ and vanishes at infinity: a step too long for what grows turns
//! or damps it. What grows from below the tolerance is not seen in an error estimate.

use core::ops::Range;

/// So many steps without an eigenvalue; the last subdiagonal entry then counts as none.
const MOST: u32 = 60;
/// Steps in a row with the same kind of shift.
const USUAL: u32 = 10;

/// The largest real part of the eigenvalues, or zero; `unit`: that of each entry of the state.
pub(super) fn compute_growth<const N: usize>(jacobian: &[[f64; N]; N], unit: &[f64; N]) -> f64 {
    let entry = |i: usize, j: usize| match jacobian[i][j] {
        // An entry that only fills up the state has an infinite unit.
        0.0 => 0.0,
        entry => entry * unit[j] / unit[i],
    };
    let mut a: [[f64; N]; N] = core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)));
    for k in 2..N {
        let column: [f64; N] = core::array::from_fn(|i| if i < k - 1 { 0.0 } else { a[i][k - 2] });
        reflect(&mut a, k - 1, &column[k - 1..], [k - 2..N, 0..N]);
    }
    let (mut end, mut steps, mut growth) = (N, 0, 0.0_f64);
    while end > 0 {
        let start = find_block(&a, end);
        if end - start > 2 && steps < MOST {
            step(&mut a, start..end, steps % (2 * USUAL) == USUAL);
            steps += 1;
            continue;
        }
        let size = (end - start).min(2);
        growth = growth.max(match size {
            1 => a[start][start],
            _ => compute_larger_root(&a, end),
        });
        (end, steps) = (end - size, 0);
    }
    growth
}

/// Where the last block begins whose subdiagonal entries do not vanish.
fn find_block<const N: usize>(a: &[[f64; N]; N], end: usize) -> usize {
    let vanishes = |k: &usize| {
        let beside = a[k - 1][k - 1].abs() + a[*k][*k].abs();
        a[*k][k - 1].abs() <= f64::EPSILON * beside
    };
    (1..end).rev().find(vanishes).unwrap_or(0)
}

/// The larger real part of the eigenvalues of the last two rows.
fn compute_larger_root<const N: usize>(a: &[[f64; N]; N], end: usize) -> f64 {
    let (m, n) = (end - 2, end - 1);
    let half = 0.5 * (a[m][m] - a[n][n]);
    0.5 * (a[m][m] + a[n][n]) + half.mul_add(half, a[m][n] * a[n][m]).max(0.0).sqrt()
}

/// An implicit step with both eigenvalues of the last two rows as shifts, or with others where
/// those go round in circles.
fn step<const N: usize>(a: &mut [[f64; N]; N], rows: Range<usize>, is_unusual: bool) {
    let (first, m, n) = (rows.start, rows.end - 2, rows.end - 1);
    let off = a[n][m].abs() + a[m][m - 1].abs();
    let (sum, product) = if is_unusual {
        (1.5 * off, off * off)
    } else {
        (a[m][m] + a[n][n], a[m][m] * a[n][n] - a[m][n] * a[n][m])
    };
    let [h00, h01, h10, h11] =
        [a[first][first], a[first][first + 1], a[first + 1][first], a[first + 1][first + 1]];
    let mut bulge =
        [h00 * (h00 - sum) + h01 * h10 + product, h10 * (h00 + h11 - sum), h10 * a[first + 2][first + 1]];
    for k in rows.start..n {
        let size = (rows.end - k).min(3);
        let columns = k.saturating_sub(1).max(rows.start)..rows.end;
        reflect(a, k, &bulge[..size], [columns, rows.start..(k + 4).min(rows.end)]);
        bulge = core::array::from_fn(|i| if k + 1 + i < rows.end { a[k + 1 + i][k] } else { 0.0 });
    }
}

/// P A P with the Householder matrix P that turns the entries `x` from `at` on into a multiple of
/// the first, on these columns and rows.
fn reflect<const N: usize>(a: &mut [[f64; N]; N], at: usize, x: &[f64], [columns, rows]: [Range<usize>; 2]) {
    let mut v = [0.0; N];
    v[..x.len()].copy_from_slice(x);
    let size = x.iter().map(|x| x * x).sum::<f64>().sqrt();
    v[0] += size.copysign(v[0]);
    let square: f64 = v.iter().map(|v| v * v).sum();
    if square <= 0.0 {
        return;
    }
    let v = &v[..x.len()];
    for j in columns {
        let along = 2.0 / square * v.iter().zip(&a[at..]).map(|(v, row)| v * row[j]).sum::<f64>();
        v.iter().zip(&mut a[at..]).for_each(|(v, row)| row[j] -= along * v);
    }
    for row in &mut a[rows] {
        let along = 2.0 / square * v.iter().zip(&row[at..]).map(|(v, x)| v * x).sum::<f64>();
        v.iter().zip(&mut row[at..]).for_each(|(v, x)| *x -= along * v);
    }
}
