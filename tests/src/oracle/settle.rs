//! Bringing a state onto its constraints: Newton's method on positions, then the nearest rates.

use nalgebra::DVector;

use super::rows::{Row, jacobian};
use super::{Assembly, State};

/// Singular values below this times the largest belong to redundant rows.
const RANK_TOLERANCE: f64 = 1e-9;

impl Assembly {
    /// The nearby state on all two-sided constraints and on the closed supports (g = 0, ġ = 0);
    /// `None` where Newton's method does not get there.
    pub fn settle(&self, mut state: State, closed: &[usize]) -> Option<State> {
        for _ in 0..30 {
            let rows = self.rows(&state, closed);
            let error = DVector::from_iterator(rows.len(), rows.iter().map(|row| row.value));
            let correction = self.correction(&rows, &error)?;
            state.positions -= &correction;
            if correction.amax() < 1e-13 * (1.0 + state.positions.amax()) {
                // Rows that contradict each other have a least-squares state on none of them.
                if error.amax() > 1e-12 * (1.0 + state.positions.amax()) {
                    return None;
                }
                let rows = self.rows(&state, closed);
                let error = rows.iter().map(|row| row.rate(&state.rates));
                let error = DVector::from_iterator(rows.len(), error);
                state.rates -= self.correction(&rows, &error)?;
                return Some(state);
            }
        }
        None
    }

    fn correction(&self, rows: &[Row], error: &DVector<f64>) -> Option<DVector<f64>> {
        if rows.is_empty() {
            return Some(DVector::zeros(self.dimension()));
        }
        let svd = jacobian(rows, self.dimension()).svd(true, true);
        let cut = RANK_TOLERANCE * svd.singular_values.max();
        svd.solve(error, cut).ok()
    }

    /// Degrees of freedom at a state, and how many two-sided and closed rows are redundant there.
    pub fn mobility(&self, state: &State, closed: &[usize]) -> (usize, usize) {
        let rows = self.rows(state, closed);
        if rows.is_empty() {
            return (self.dimension(), 0);
        }
        let rank = jacobian(&rows, self.dimension()).rank(1e-6);
        (self.dimension() - rank, rows.len() - rank)
    }
}
