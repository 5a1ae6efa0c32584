//! How fast a motion grows at most: the largest real part of the eigenvalues of a Jacobian, by
//! Francis's QR steps (Golub & Van Loan, *Matrix Computations*, 4th ed., 7.4, 7.5).
//!
//! R(z) of a Runge–Kutta method is e^z for small z only: a step too long for what grows makes it
//! grow too slowly, turns or damps it. What grows from below the tolerance is not seen in an error
//! estimate.

use super::{StepState, is_finite};
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::Scalar;
use core::ops::Range;

/// So many steps without an eigenvalue; the last subdiagonal entry then counts as none.
const MOST: u32 = 60;
/// Steps in a row with the same kind of shift.
const USUAL: u32 = 10;

/// The error of R(z), relative to e^z, within which what grows is followed in any case: it keeps a
/// fall from 1e-15 right to 1e-6 of its time, and leaves to the error estimate what a tighter
/// tolerance can see.
const FOLLOWED: f64 = 4e-8;

/// h λ ≤ 1 of a step over which what grows as e^(λ t) grows right to the tolerance, where
/// |e^z − R(z)| is at most so many times z^(p + 1) for z ≤ 1.
pub(super) fn compute_reach(relative: f64, order: f64, error_constant: f64) -> f64 {
    (relative.max(FOLLOWED) / error_constant).powf(1.0 / (order + 1.0)).min(1.0)
}

/// The part of the size of an entry over which a slope is a difference: √ε.
const DIFFERENCE: f64 = 1.5e-8;

/// The growth at the state, where f is `slope`, by differences: an evaluation of f for each entry.
/// Zero where f is not finite beside it.
pub(super) fn estimate_growth<S: Scalar, const N: usize>(
    f: &impl Fn(&[S; N]) -> [S; N],
    step_state: &mut StepState<S, N>,
    slope: &[S; N],
) -> f64 {
    let StepState { tolerance, state, counts, .. } = step_state;
    let (scale, size) = (tolerance.scale(state, state), tolerance.measure(state));
    let mut jacobian = [[0.0; N]; N];
    // An entry that only fills up the state has an infinite scale.
    for j in (0..N).filter(|j| scale[*j] < f64::INFINITY) {
        let mut beside = *state;
        beside[j] = state[j] + S::from_f64(DIFFERENCE * size * scale[j]);
        let (step, moved) = ((beside[j] - state[j]).to_f64(), f(&beside));
        counts.evaluations += 1;
        for (i, row) in jacobian.iter_mut().enumerate() {
            row[j] = (moved[i] - slope[i]).to_f64() / step;
        }
    }
    if jacobian.iter().all(is_finite) { compute_growth(&jacobian, &scale) } else { 0.0 }
}

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

/// Where the last block begins whose subdiagonal entries do not vanish: beside the diagonal, or
/// where that is rounding, as it is of vibrations, beside the entries next to them.
fn find_block<const N: usize>(a: &[[f64; N]; N], end: usize) -> usize {
    let subdiagonal = |k: usize| if (1..end).contains(&k) { a[k][k - 1].abs() } else { 0.0 };
    let vanishes = |k: &usize| {
        let diagonal = a[k - 1][k - 1].abs() + a[*k][*k].abs();
        let around = subdiagonal(k - 1) + subdiagonal(k + 1);
        let beside = if diagonal > f64::EPSILON * around { diagonal } else { around };
        subdiagonal(*k) <= f64::EPSILON * beside
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
