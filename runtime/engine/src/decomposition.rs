//! Decompositions that come to an end: nalgebra's own turn for ever on entries that are not finite. Such a matrix counts as zero,
//! so that what is asked of it is singular.

use nalgebra::{Complex, DMatrix, DVector, Dyn, SVD, Schur, SymmetricEigen};

/// Sweeps that a matrix takes are some times its size.
fn sweeps(matrix: &DMatrix<f64>) -> usize {
    100 * (matrix.nrows() + matrix.ncols()) + 1000
}

/// Singular values, largest first, with the left and right vectors that are asked for.
pub(crate) fn svd(matrix: DMatrix<f64>, left: bool, right: bool) -> SVD<f64, Dyn, Dyn> {
    let of = |matrix: DMatrix<f64>| {
        let most = sweeps(&matrix);
        SVD::try_new(matrix, left, right, 5.0 * f64::EPSILON, most)
    };
    let zero = DMatrix::zeros(matrix.nrows(), matrix.ncols());
    finite(matrix).and_then(of).unwrap_or_else(|| SVD::new(zero, left, right))
}

/// Eigenvalues of a symmetric matrix with their vectors.
pub(crate) fn symmetric_eigen(matrix: DMatrix<f64>) -> SymmetricEigen<f64, Dyn> {
    let of = |matrix: DMatrix<f64>| {
        let most = sweeps(&matrix);
        SymmetricEigen::try_new(matrix, f64::EPSILON, most)
    };
    let zero = DMatrix::zeros(matrix.nrows(), matrix.ncols());
    finite(matrix).and_then(of).unwrap_or_else(|| SymmetricEigen::new(zero))
}

/// Eigenvalues of any square matrix.
pub(crate) fn eigenvalues(matrix: DMatrix<f64>) -> DVector<Complex<f64>> {
    let size = matrix.nrows();
    let of = |matrix: DMatrix<f64>| {
        let most = sweeps(&matrix);
        Schur::try_new(matrix, f64::EPSILON, most).map(|schur| schur.complex_eigenvalues())
    };
    finite(matrix).and_then(of).unwrap_or_else(|| DVector::zeros(size))
}

fn finite(matrix: DMatrix<f64>) -> Option<DMatrix<f64>> {
    matrix.iter().all(|entry| entry.is_finite()).then_some(matrix)
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
