//! Gaussian elimination with partial pivoting at a fixed size (Golub & Van Loan, 3.4), each row in
//! its unit: which rows are pivots is the same in all units of length and time, and so is each
//! digit where these are powers of two.

use core::ops::{Div, Mul, Sub};

use num_complex::Complex;

/// An entry of a matrix.
pub(super) trait Entry: Copy + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    /// A norm.
    fn size(self) -> f64;
}

impl Entry for f64 {
    fn size(self) -> f64 {
        self.abs()
    }
}

impl Entry for Complex<f64> {
    fn size(self) -> f64 {
        self.l1_norm()
    }
}

/// P A = L U; L has a unit diagonal.
#[derive(Clone, Copy)]
pub(super) struct Lu<T, const N: usize> {
    factors: [[T; N]; N],
    /// Rows of A in the order of the pivots.
    order: [usize; N],
}

impl<T: Entry, const N: usize> Lu<T, N> {
    /// `unit`: that of each row. None if a pivot vanishes or is not finite.
    pub(super) fn new(mut a: [[T; N]; N], unit: &[f64; N]) -> Option<Self> {
        let mut order: [usize; N] = core::array::from_fn(|i| i);
        for k in 0..N {
            let size = |i: usize| a[i][k].size() / unit[order[i]];
            let larger = |best: usize, i: usize| if size(i) > size(best) { i } else { best };
            let pivot = (k + 1..N).fold(k, larger);
            a.swap(k, pivot);
            order.swap(k, pivot);
            if !(a[k][k].size() > 0.0 && a[k][k].size().is_finite()) {
                return None;
            }
            for i in k + 1..N {
                let factor = a[i][k] / a[k][k];
                a[i][k] = factor;
                for j in k + 1..N {
                    a[i][j] = a[i][j] - factor * a[k][j];
                }
            }
        }
        Some(Self { factors: a, order })
    }

    /// x of A x = `right`.
    pub(super) fn solve(&self, right: &[T; N]) -> [T; N] {
        let a = &self.factors;
        let mut x = self.order.map(|row| right[row]);
        for i in 0..N {
            x[i] = (0..i).fold(x[i], |rest, j| rest - a[i][j] * x[j]);
        }
        for i in (0..N).rev() {
            x[i] = (i + 1..N).fold(x[i], |rest, j| rest - a[i][j] * x[j]) / a[i][i];
        }
        x
    }
}
