//! M = L Lᵀ without an allocation for a few coordinates.

use smallvec::smallvec;

use super::sum::CLEAR;
use crate::context::Numbers;

/// L, row by row.
pub(super) struct Cholesky {
    n: usize,
    rows: Numbers,
}

impl Cholesky {
    /// None where a pivot is not clear.
    pub(super) fn factorise(mass: impl Fn(usize, usize) -> f64, n: usize) -> Option<Self> {
        let mut rows: Numbers = smallvec![0.0; n * n];
        for i in 0..n {
            let (above, own) = rows.split_at_mut(i * n);
            for k in 0..i {
                let row = &above[k * n..][..=k];
                own[k] = less(mass(i, k), &own[..k], &row[..k]) / row[k];
            }
            let pivot = less(mass(i, i), &own[..i], &own[..i]);
            if pivot.is_nan() || pivot <= CLEAR * mass(i, i) {
                return None;
            }
            own[i] = pivot.sqrt();
        }
        Some(Self { n, rows })
    }

    /// M⁻¹ b.
    pub(super) fn solution(&self, b: impl Iterator<Item = f64>) -> Numbers {
        let mut x: Numbers = b.collect();
        for i in 0..self.n {
            let row = &self.rows[i * self.n..][..=i];
            x[i] = less(x[i], &row[..i], &x[..i]) / row[i];
        }
        for i in (0..self.n).rev() {
            let row = &self.rows[i * self.n..][..=i];
            x[i] /= row[i];
            for k in 0..i {
                x[k] -= row[k] * x[i];
            }
        }
        x
    }
}

fn less(value: f64, one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).fold(value, |rest, (a, b)| rest - a * b)
}
