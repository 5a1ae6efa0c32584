//! Decompositions that come to an end: nalgebra's own turn for ever on entries that are not finite. Such a matrix counts as zero,
//! so that what is asked of it is singular.

use nalgebra::{Complex, DMatrix, DVector, Dyn, SVD, Schur, SymmetricEigen};

/// Singular values, largest first, with the left and right vectors that are asked for.
pub(crate) fn svd(matrix: DMatrix<f64>, left: bool, right: bool) -> SVD<f64, Dyn, Dyn> {
    decomposed(matrix, |matrix, sweeps| SVD::try_new(matrix, left, right, 5.0 * f64::EPSILON, sweeps))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_decomposed_as_by_nalgebra() {
        let matrix = DMatrix::from_row_slice(3, 3, &[2.0, 1.0, 0.5, 1.0, 3.0, 0.2, 0.5, 0.2, 1.0]);
        let own = svd(matrix.clone(), true, true).singular_values;
        assert!((own - matrix.singular_values()).amax() < 1e-14);
        assert_eq!(symmetric_eigen(matrix.clone()).eigenvalues, matrix.clone().symmetric_eigen().eigenvalues);
        assert_eq!(eigenvalues(matrix.clone()), matrix.complex_eigenvalues());
    }

    #[test]
    fn what_is_not_finite_is_zero() {
        for entry in [f64::NAN, f64::INFINITY, f64::MAX] {
            let matrix = DMatrix::from_row_slice(2, 2, &[1.0, entry, entry, -entry]);
            let values = svd(matrix.clone(), true, true).singular_values;
            assert!(entry == f64::MAX || values.iter().all(|&value| value == 0.0), "{values}");
            assert_eq!(symmetric_eigen(matrix.clone()).eigenvalues.len(), 2);
            assert_eq!(eigenvalues(matrix).len(), 2);
        }
    }
}
