//! The full equations at a state, of any dimension.

use crate::model::KernelView;

/// `M a = f + Jᵀ λ`, and `g`, `J a + b = g̈` for each row: contacts, then joints, then tangents.
#[derive(Clone, Debug)]
pub struct Equations<S> {
    coordinates: usize,
    rows: usize,
    /// f, M, then g, b, ∂g/∂t and J, row by row.
    values: Vec<S>,
}

impl<S: Copy> Equations<S> {
    /// What has been computed of them.
    pub fn from_kernel(kernel: &impl KernelView<S>) -> Self {
        let (n, rows) = (kernel.force().len(), kernel.gap().len());
        let mut values = Vec::with_capacity(n * (n + 1) + rows * (n + 3));
        values.extend_from_slice(kernel.force());
        (0..n).for_each(|i| values.extend_from_slice(kernel.mass(i)));
        [kernel.gap(), kernel.bias(), kernel.prescribed_gap_rate()]
            .iter()
            .for_each(|column| values.extend_from_slice(column));
        (0..rows).for_each(|row| values.extend_from_slice(kernel.jacobian(row)));
        Self { coordinates: n, rows, values }
    }

    /// Row `i` of M.
    pub fn mass(&self, i: usize) -> &[S] {
        &self.values[(i + 1) * self.coordinates..][..self.coordinates]
    }

    /// f = Q − h: generalised forces less velocity terms.
    pub fn force(&self) -> &[S] {
        &self.values[..self.coordinates]
    }

    /// g.
    pub fn gap(&self) -> &[S] {
        self.column(0)
    }

    /// Row `i` of J = ∂g/∂q.
    pub fn jacobian(&self, i: usize) -> &[S] {
        &self.of_rows()[3 * self.rows + i * self.coordinates..][..self.coordinates]
    }

    /// b = J̇ u + ∂²g/∂t²: what g̈ is without accelerations.
    pub fn bias(&self) -> &[S] {
        self.column(1)
    }

    /// ∂g/∂t, so that ġ = J u + ∂g/∂t.
    pub fn prescribed_gap_rate(&self) -> &[S] {
        self.column(2)
    }

    /// What belongs to the rows, behind f and M.
    fn of_rows(&self) -> &[S] {
        &self.values[self.coordinates * (self.coordinates + 1)..]
    }

    fn column(&self, k: usize) -> &[S] {
        &self.of_rows()[k * self.rows..][..self.rows]
    }
}

impl Equations<f64> {
    /// ġ of a row at these rates.
    pub fn gap_rate(&self, row: usize, rates: &[f64]) -> f64 {
        let along = self.jacobian(row).iter().zip(rates).map(|(entry, u)| entry * u);
        along.sum::<f64>() + self.prescribed_gap_rate()[row]
    }

    /// Σ |Jᵢ xᵢ|, the size of the terms that J x of a row is made of: its rounding, however small
    /// it is.
    pub fn terms(&self, row: usize, x: &[f64]) -> f64 {
        self.jacobian(row).iter().zip(x).map(|(entry, x)| (entry * x).abs()).sum()
    }

    /// g̈ = J a + γ of a row at these accelerations.
    pub fn gap_acceleration(&self, row: usize, accelerations: &[f64]) -> f64 {
        let along = self.jacobian(row).iter().zip(accelerations).map(|(entry, a)| entry * a);
        along.sum::<f64>() + self.bias()[row]
    }
}
