//! Independent vectors with their orthonormal basis, N = Q R, one added or removed at a time.

use crate::numerics::zero::RANK;
use nalgebra::DVector;

/// Independent unit vectors, each with the name of its row.
#[derive(Default)]
pub(crate) struct ActiveRows {
    pub(crate) rows: Vec<usize>,
    vectors: Vec<DVector<f64>>,
    q: Vec<DVector<f64>>,
    /// The columns of R.
    r: Vec<Vec<f64>>,
}

/// A vector as seen from others: what is independent of them, and its components along their basis.
pub(super) struct Split {
    pub(super) independent: DVector<f64>,
    along: Vec<f64>,
}

impl Split {
    pub(super) fn depends(&self) -> bool {
        self.independent.norm() <= RANK
    }
}

impl ActiveRows {
    /// Splits a unit vector; the second pass takes away what rounding has left in the first.
    pub(super) fn split(&self, vector: &DVector<f64>) -> Split {
        let mut independent = vector.clone();
        let mut along = vec![0.0; self.q.len()];
        for _ in 0..2 {
            for (q, along) in self.q.iter().zip(&mut along) {
                let part = q.dot(&independent);
                independent.axpy(-part, q, 1.0);
                *along += part;
            }
        }
        Split { independent, along }
    }

    /// The combination c of the vectors that a split one has in their space: R c = Qᵀ y.
    pub(super) fn combination(&self, split: &Split) -> Vec<f64> {
        let mut c = split.along.clone();
        for k in (0..c.len()).rev() {
            c[k] /= self.r[k][k];
            for i in 0..k {
                c[i] -= self.r[k][i] * c[k];
            }
        }
        c
    }

    /// Adds a vector, if it is independent.
    pub(crate) fn push(&mut self, row: usize, vector: &DVector<f64>) -> bool {
        let Split { independent, mut along } = self.split(vector);
        let length = independent.norm();
        if length <= RANK {
            return false;
        }
        along.push(length);
        self.rows.push(row);
        self.vectors.push(vector.clone());
        self.q.push(independent / length);
        self.r.push(along);
        true
    }

    /// Removes the vector at a place.
    pub(super) fn remove(&mut self, place: usize) {
        let rows = self.rows.split_off(place);
        let vectors = self.vectors.split_off(place);
        self.q.truncate(place);
        self.r.truncate(place);
        for (row, vector) in rows.into_iter().zip(vectors).skip(1) {
            self.push(row, &vector);
        }
    }
}
