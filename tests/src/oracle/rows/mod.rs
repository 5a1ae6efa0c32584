//! Constraint rows: each constraint g(q, t) = 0 as its value, its gradient J, ∂g/∂t and what g̈ is
//! without accelerations: ġ = J q̇ + ∂g/∂t, g̈ = J q̈ + b.

mod joints;
mod points;
mod supports;

use nalgebra::{DMatrix, DVector, Vector2};

use super::{Assembly, Place, State};

/// One scalar constraint at one state.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// g.
    pub value: f64,
    /// ∂g/∂t.
    pub prescribed_gap_rate: f64,
    /// b.
    pub bias: f64,
    /// Non-zero entries of J (an index may occur twice: its entries add).
    pub gradient: Vec<(usize, f64)>,
    /// Where a unit multiplier exerts which force; couples are not among these.
    pub forces: Vec<(Place, Vector2<f64>)>,
}

impl Row {
    /// J q̇, or J q̈ for accelerations.
    pub fn along(&self, rates: &DVector<f64>) -> f64 {
        self.gradient.iter().map(|&(index, entry)| entry * rates[index]).sum()
    }

    /// ġ.
    pub fn rate(&self, rates: &DVector<f64>) -> f64 {
        self.along(rates) + self.prescribed_gap_rate
    }

    /// Σ cᵢ θᵢ, of this value.
    pub(super) fn of_angles(terms: &[(usize, f64)], value: f64) -> Self {
        let gradient = terms.iter().map(|&(body, c)| (3 * body + 2, c)).collect();
        Self { value, gradient, ..Self::default() }
    }

    fn plus(mut self, other: Self) -> Self {
        self.value += other.value;
        self.prescribed_gap_rate += other.prescribed_gap_rate;
        self.bias += other.bias;
        self.gradient.extend(other.gradient);
        self.forces.extend(other.forces);
        self
    }

    fn scaled(mut self, factor: f64) -> Self {
        for x in [&mut self.value, &mut self.prescribed_gap_rate, &mut self.bias] {
            *x *= factor;
        }
        self.gradient.iter_mut().for_each(|(_, entry)| *entry *= factor);
        self.forces.iter_mut().for_each(|(_, force)| *force *= factor);
        self
    }

    fn minus(self, other: Self) -> Self {
        self.plus(other.scaled(-1.0))
    }
}

impl Assembly {
    /// The two-sided rows, those of the closed supports, then the tangential ones of those that are
    /// rough.
    pub(super) fn rows(&self, state: &State, closed: &[usize]) -> Vec<Row> {
        let mut rows = self.joint_rows(state);
        rows.extend(closed.iter().map(|&support| self.support_row(state, support)));
        rows.extend(closed.iter().filter_map(|&support| self.tangent_row(state, support)));
        rows
    }

    /// Largest error of the two-sided constraints, in position or velocity.
    pub fn residual(&self, state: &State) -> f64 {
        let size = |row: &Row| row.value.abs().max(row.rate(&state.rates).abs());
        self.joint_rows(state).iter().map(size).fold(0.0, f64::max)
    }
}

/// J as a dense matrix.
pub(super) fn jacobian(rows: &[Row], dimension: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(rows.len(), dimension);
    for (index, row) in rows.iter().enumerate() {
        for &(column, entry) in &row.gradient {
            matrix[(index, column)] += entry;
        }
    }
    matrix
}
