//! The linear system of Newton's own iteration, with the Jacobian of every stage, for stiff
//! directions that turn: Σⱼ (A⁻¹)ᵢⱼ Δzⱼ/h − Jᵢ Δzᵢ = f(y + zᵢ) − Σⱼ (A⁻¹)ᵢⱼ zⱼ/h.

use super::coefficients::{ALPHA, BACK, BETA, FORWARD, GAMMA};
use super::newton::Stages;
use crate::integrate::JacobianFn;

/// A row of the matrix, one block for each stage, and its right-hand side.
type MatrixRow<const N: usize> = ([[f64; N]; 3], f64);

/// Room for the system of size 3N.
pub(super) struct Full<const N: usize> {
    rows: Vec<MatrixRow<N>>,
    /// The entry of the state that each row is of.
    entries: Vec<usize>,
    /// A⁻¹.
    pub(super) inverse: [[f64; 3]; 3],
}

impl<const N: usize> Full<N> {
    pub(super) fn new() -> Self {
        let rows = vec![([[0.0; N]; 3], 0.0); 3 * N];
        let blocks = [[GAMMA, 0.0, 0.0], [0.0, ALPHA, -BETA], [0.0, BETA, ALPHA]];
        let product = |a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]| {
            a.map(|row| core::array::from_fn(|j| (0..3).map(|k| row[k] * b[k][j]).sum::<f64>()))
        };
        Self {
            rows,
            entries: Vec::with_capacity(3 * N),
            inverse: product(&product(&FORWARD, &blocks), &BACK),
        }
    }

    /// The change of the stages z with the slopes `f`; None if the system is singular. 3 Jacobians.
    pub(super) fn change(
        &mut self,
        jacobian: JacobianFn<f64, N>,
        (y, h, unit): (&[f64; N], f64, &[f64; N]),
        f: &Stages<N>,
        z: &Stages<N>,
    ) -> Option<Stages<N>> {
        for stage in 0..3 {
            let derivative = jacobian(&core::array::from_fn(|i| y[i] + z[stage][i]));
            for i in 0..N {
                let (blocks, right) = &mut self.rows[stage * N + i];
                *right = f[stage][i];
                for other in 0..3 {
                    let weight = self.inverse[stage][other] / h;
                    blocks[other] = [0.0; N];
                    blocks[other][i] = weight;
                    *right -= weight * z[other][i];
                }
                for (entry, by_y) in blocks[stage].iter_mut().zip(&derivative[i]) {
                    *entry -= by_y;
                }
            }
        }
        self.eliminate(unit)
    }

    /// Gaussian elimination with partial pivoting, each row in the unit of its entry.
    fn eliminate(&mut self, unit: &[f64; N]) -> Option<Stages<N>> {
        self.entries.clear();
        self.entries.extend((0..3 * N).map(|i| i % N));
        let (size, entry) = (3 * N, |row: &MatrixRow<N>, j: usize| row.0[j / N][j % N]);
        for k in 0..size {
            let extent = |i: usize| entry(&self.rows[i], k).abs() / unit[self.entries[i]];
            let larger = |best: usize, i: usize| if extent(i) > extent(best) { i } else { best };
            let pivot = (k + 1..size).fold(k, larger);
            self.rows.swap(k, pivot);
            self.entries.swap(k, pivot);
            let (above, below) = self.rows.split_at_mut(k + 1);
            let top = &above[k];
            if !(entry(top, k).abs() > 0.0 && entry(top, k).is_finite()) {
                return None;
            }
            for row in below {
                let factor = entry(row, k) / entry(top, k);
                for j in k + 1..size {
                    row.0[j / N][j % N] -= factor * entry(top, j);
                }
                row.1 -= factor * top.1;
            }
        }
        let mut x = [[0.0; N]; 3];
        for k in (0..size).rev() {
            let row = &self.rows[k];
            let known: f64 = (k + 1..size).map(|j| entry(row, j) * x[j / N][j % N]).sum();
            x[k / N][k % N] = (row.1 - known) / entry(row, k);
        }
        Some(x)
    }
}
