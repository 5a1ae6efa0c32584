//! Decompositions that come to an end, with what rounding allows: nalgebra's own turn for ever on
//! entries that are not finite, and now and then leave an error in singular values. A matrix that
//! is not finite counts as zero, so that what is asked of it is singular.

use crate::numerics::zero::{RANK, roundoff};
use nalgebra::{Complex, DMatrix, DVector, Dyn, SVD, Schur, SymmetricEigen};

/// A product that differs by more from its matrix, for each row or column in units of rounding of
/// the largest entry, is no decomposition.
const ROUNDING: f64 = roundoff(8.0);
/// Columns are orthogonal up to this part of their lengths.
const ORTHOGONAL: f64 = roundoff(1.0);
/// Beside the square of this, one is rounding.
const LARGE: f64 = 1e8;
/// Sweeps over all pairs of columns at most: few are needed, from a decomposition that is nearly
/// right.
const SWEEPS: usize = 60;

/// Singular values, largest first, with the left and right vectors. nalgebra's step for the last
/// two of them has been seen to leave errors of 8e-2; where its product is not the matrix,
/// [`turned`] goes on from there.
pub(crate) fn svd(matrix: DMatrix<f64>) -> SVD<f64, Dyn, Dyn> {
    decomposed(matrix, |matrix, sweeps| {
        let found = SVD::try_new(matrix.clone(), true, true, 5.0 * f64::EPSILON, sweeps)?;
        let (left, right) = (found.u.as_ref()?, found.v_t.as_ref()?);
        let rest = left * DMatrix::from_diagonal(&found.singular_values) * right - &matrix;
        let size = ROUNDING * matrix.nrows().max(matrix.ncols()) as f64 * matrix.amax();
        if rest.amax() <= size { Some(found) } else { turned(&matrix, found) }
    })
}

/// `A V = U Σ` by rotations of the columns of A V until these are orthogonal (Hestenes, *Inversion
/// of matrices by biorthogonalization*, J. SIAM 6, 1958).
fn turned(matrix: &DMatrix<f64>, found: SVD<f64, Dyn, Dyn>) -> Option<SVD<f64, Dyn, Dyn>> {
    if matrix.nrows() < matrix.ncols() {
        return turned(&matrix.transpose(), flipped(found)).map(flipped);
    }
    let mut right = found.v_t?.transpose();
    let mut left = matrix * &right;
    make_orthogonal(&mut left, |pair, tangent| rotate(&mut right, pair, tangent));
    let singular_values =
        DVector::from_iterator(left.ncols(), left.column_iter().map(|column| column.norm()));
    normalise(&mut left, &singular_values);
    let mut svd = SVD { u: Some(left), v_t: Some(right.transpose()), singular_values };
    svd.sort_by_singular_values();
    Some(svd)
}

/// Turns pairs of columns until all are orthogonal, each turn told with its tangent.
fn make_orthogonal(columns: &mut DMatrix<f64>, mut turn: impl FnMut([usize; 2], f64)) {
    for _ in 0..SWEEPS {
        let mut orthogonal = true;
        for p in 0..columns.ncols() {
            for q in p + 1..columns.ncols() {
                let (a, b) = (columns.column(p).norm_squared(), columns.column(q).norm_squared());
                let dot = columns.column(p).dot(&columns.column(q));
                if dot.abs() > ORTHOGONAL * (a * b).sqrt() {
                    let cotangent = (b - a) / (2.0 * dot);
                    let tangent = cotangent.signum() / (cotangent.abs() + with_one(cotangent));
                    rotate(columns, [p, q], tangent);
                    turn([p, q], tangent);
                    orthogonal = false;
                }
            }
        }
        if orthogonal {
            break;
        }
    }
}

/// An orthonormal basis of the range of a matrix, which may be empty.
pub(crate) fn range(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    if matrix.is_empty() {
        return DMatrix::zeros(matrix.nrows(), 0);
    }
    let svd = svd(matrix.clone());
    let least = RANK * svd.singular_values.amax();
    let kept: Vec<usize> =
        (0..svd.singular_values.len()).filter(|&i| svd.singular_values[i] > least).collect();
    svd.u.map_or_else(|| DMatrix::zeros(matrix.nrows(), 0), |u| u.select_columns(&kept))
}

/// Singular values alone, largest first: for small matrices a fraction of the work.
pub(crate) fn singular_values(matrix: DMatrix<f64>) -> Vec<f64> {
    let mut columns = if matrix.nrows() < matrix.ncols() { matrix.transpose() } else { matrix };
    if columns.iter().any(|entry| !entry.is_finite()) {
        columns.fill(0.0);
    }
    make_orthogonal(&mut columns, |_, _| {});
    let mut values: Vec<f64> = columns.column_iter().map(|column| column.norm()).collect();
    values.sort_unstable_by(f64::total_cmp);
    values.reverse();
    values
}

/// A lower bound of the least singular value of a wide matrix in units of the largest: 1/(‖A‖
/// ‖L⁻¹‖) with `A Aᵀ = L Lᵀ`, in Frobenius's norm; zero where rows depend on each other or are not
/// finite. The ratio is at most as many times as large as there are rows.
pub(crate) fn least_ratio_bound(matrix: &DMatrix<f64>) -> f64 {
    let rows = matrix.nrows();
    let Some(factor) = (matrix * matrix.transpose()).cholesky() else { return 0.0 };
    let inverse = factor.l_dirty().solve_lower_triangular(&DMatrix::identity(rows, rows));
    inverse.map_or(0.0, |inverse| (1.0 / (matrix.norm() * inverse.norm())).max(0.0))
}

/// That of the transposed matrix.
fn flipped(svd: SVD<f64, Dyn, Dyn>) -> SVD<f64, Dyn, Dyn> {
    let SVD { u, v_t, singular_values } = svd;
    SVD { u: v_t.map(|v| v.transpose()), v_t: u.map(|u| u.transpose()), singular_values }
}

/// √(1 + x²), without the square of a large x.
fn with_one(x: f64) -> f64 {
    if x.abs() < LARGE { (1.0 + x * x).sqrt() } else { x.abs() }
}

fn rotate(matrix: &mut DMatrix<f64>, [p, q]: [usize; 2], tangent: f64) {
    let cosine = 1.0 / with_one(tangent);
    let sine = cosine * tangent;
    for i in 0..matrix.nrows() {
        let (x, y) = (matrix[(i, p)], matrix[(i, q)]);
        (matrix[(i, p)], matrix[(i, q)]) = (cosine * x - sine * y, sine * x + cosine * y);
    }
}

/// Divides columns by their lengths; those without any become unit vectors across all others.
fn normalise(columns: &mut DMatrix<f64>, lengths: &DVector<f64>) {
    for (k, &length) in lengths.iter().enumerate() {
        columns.column_mut(k).scale_mut(if length > 0.0 { 1.0 / length } else { 0.0 });
    }
    for k in (0..lengths.len()).filter(|&k| lengths[k] == 0.0) {
        let rows = columns.nrows();
        let across = |i: usize| {
            let mut unit = DVector::from_fn(rows, |j, _| f64::from(u8::from(i == j)));
            for _ in 0..2 {
                unit -= &*columns * columns.tr_mul(&unit);
            }
            unit
        };
        let longest = (0..rows).map(across).max_by(|x, y| x.norm().total_cmp(&y.norm()));
        longest.into_iter().for_each(|unit| columns.set_column(k, &unit.normalize()));
    }
}

/// Eigenvalues of a symmetric matrix with their vectors.
pub(crate) fn symmetric_eigen(matrix: DMatrix<f64>) -> SymmetricEigen<f64, Dyn> {
    decomposed(matrix, |matrix, sweeps| SymmetricEigen::try_new(matrix, f64::EPSILON, sweeps))
}

/// Eigenvalues of any square matrix, none of an empty one.
pub(crate) fn eigenvalues(matrix: DMatrix<f64>) -> DVector<Complex<f64>> {
    if matrix.is_empty() {
        return DVector::zeros(0);
    }
    let schur = decomposed(matrix, |matrix, sweeps| Schur::try_new(matrix, f64::EPSILON, sweeps));
    schur.complex_eigenvalues()
}

/// Of a matrix within some sweeps for each row and column, or else of zeros.
fn decomposed<T>(matrix: DMatrix<f64>, by: impl Fn(DMatrix<f64>, usize) -> Option<T>) -> T {
    let (rows, columns) = matrix.shape();
    let sweeps = 100 * (rows + columns) + 1000;
    let finite = matrix.iter().all(|entry| entry.is_finite());
    let found = finite.then(|| by(matrix, sweeps)).flatten();
    found.or_else(|| by(DMatrix::zeros(rows, columns), sweeps)).expect("zeros are diagonal")
}

/// The connected parts of a matrix, numbered from zero.
pub(crate) fn parts(matrix: &DMatrix<f64>) -> Vec<usize> {
    let size = matrix.nrows();
    let mut part = vec![usize::MAX; size];
    let mut count = 0;
    for first in 0..size {
        if part[first] < count {
            continue;
        }
        let mut next = vec![first];
        while let Some(i) = next.pop() {
            if part[i] == usize::MAX {
                part[i] = count;
                next.extend((0..size).filter(|&j| matrix[(i, j)] != 0.0 && part[j] == usize::MAX));
            }
        }
        count += 1;
    }
    part
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_decomposed_as_by_nalgebra() {
        let matrix = DMatrix::from_row_slice(3, 3, &[2.0, 1.0, 0.5, 1.0, 3.0, 0.2, 0.5, 0.2, 1.0]);
        let own = svd(matrix.clone()).singular_values;
        assert!((own - matrix.singular_values()).amax() < 1e-14);
        assert_eq!(symmetric_eigen(matrix.clone()).eigenvalues, matrix.clone().symmetric_eigen().eigenvalues);
        assert_eq!(eigenvalues(matrix.clone()), matrix.complex_eigenvalues());
    }

    fn is_decomposed(matrix: &DMatrix<f64>) {
        let SVD { u, v_t, singular_values } = svd(matrix.clone());
        let (u, v) = (u.unwrap(), v_t.unwrap());
        let least = matrix.nrows().min(matrix.ncols());
        let identity = DMatrix::identity(least, least);
        // The unit roundoff of sums of up to nine terms, each rotated some times.
        assert!((u.tr_mul(&u) - &identity).amax() < 1e-14 && (&v * v.transpose() - identity).amax() < 1e-14);
        assert!(singular_values.as_slice().is_sorted_by(|a, b| a >= b && *b >= 0.0), "{singular_values}");
        let alone = DVector::from_vec(super::singular_values(matrix.clone()));
        assert!((alone - &singular_values).amax() <= 2e-14 * matrix.amax(), "{singular_values}");
        let rest = u * DMatrix::from_diagonal(&singular_values) * v - matrix;
        assert!(rest.amax() <= 2e-14 * matrix.amax(), "{:e} {matrix}", rest.amax());
        let ratio = singular_values[least - 1] / singular_values[0];
        if matrix.nrows() == least && ratio > 1e-6 {
            let bound = least_ratio_bound(matrix);
            assert!(bound <= ratio * (1.0 + 1e-4) && ratio <= least as f64 * bound * (1.0 + 1e-4));
        }
    }

    /// [M −Jᵀ; J 0] with M = 1 and simple rows, of full rank or not, whole, wide and high: nalgebra
    /// alone has errors from 1e-13 to 8e-2 in some of them.
    #[test]
    fn the_product_is_the_matrix() {
        is_decomposed(&DMatrix::from_row_slice(
            2,
            2,
            &[1.0, 1.589002421797936e-5, -1.589002421797936e-5, 0.0],
        ));
        let mut seed = 5_u64;
        let mut below = |count: u64| {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            ((seed >> 33) % count) as usize
        };
        for k in 0..3000 {
            let (n, m) = (1 + below(5), 1 + below(4));
            let rows = DMatrix::from_fn(m, n, |_, _| match k % 2 {
                0 => [-1.0, 0.0, 0.0, 1.0, 0.5][below(5)],
                _ => [0.0, 0.0, 1.0][below(3)] * (below(2_000_000) as f64 * 1e-6 - 1.0),
            });
            let mut matrix = DMatrix::identity(n + m, n + m);
            matrix.view_mut((n, n), (m, m)).fill(0.0);
            matrix.view_mut((n, 0), (m, n)).copy_from(&rows);
            matrix.view_mut((0, n), (n, m)).copy_from(&-rows.transpose());
            [&matrix, &matrix.rows(0, n).into_owned(), &matrix.columns(0, n).into_owned()]
                .into_iter()
                .for_each(is_decomposed);
        }
    }

    #[test]
    fn nonfinite_singular_values_are_zero() {
        for entry in [f64::NAN, f64::INFINITY, f64::MAX] {
            let matrix = DMatrix::from_row_slice(2, 2, &[1.0, entry, entry, -entry]);
            let values = svd(matrix.clone()).singular_values;
            assert!(entry == f64::MAX || values.iter().all(|&value| value == 0.0), "{values}");
            assert!(entry == f64::MAX || singular_values(matrix.clone()) == [0.0; 2]);
            assert_eq!(least_ratio_bound(&matrix), 0.0);
            assert_eq!(symmetric_eigen(matrix.clone()).eigenvalues.len(), 2);
            assert_eq!(eigenvalues(matrix).len(), 2);
        }
    }
}
