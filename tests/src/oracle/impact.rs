//! Impulses: M (q̇⁺ − q̇⁻) = P_applied + Jᵀ P, J q̇⁺ + ∂g/∂t = target, over the joints and the
//! acting supports.

use nalgebra::{DVector, Vector2};

use super::kkt;
use super::{Assembly, Place, State, Unsolvable};

/// What an impact does.
#[derive(Clone, Debug)]
pub struct Impact {
    /// q̇⁺ in the order of [`State::positions`].
    pub rates: DVector<f64>,
    /// Impulse of each support along its free normal; 0 where it does not act.
    pub normal: Vec<f64>,
    /// Tangential impulse of each support along [`Assembly::tangent_row`].
    pub tangential: Vec<f64>,
    /// Whether the impulses are unique; if not, a least-norm set stands for them.
    pub unique: bool,
    /// Smallest over largest pivot of the balanced system.
    pub pivots: f64,
}

impl Assembly {
    /// Impulses that give the acting supports these gap rates, rough ones no slip, with impulses
    /// applied at places at the same instant.
    ///
    /// # Errors
    /// As [`Assembly::solve`].
    pub fn impact(
        &self,
        state: &State,
        acting: &[(usize, f64)],
        applied: &[(Place, Vector2<f64>)],
    ) -> Result<Impact, Unsolvable> {
        let closed: Vec<_> = acting.iter().map(|(support, _)| *support).collect();
        let (free, rows) = (self.dimension(), self.rows(state, &closed));
        let slips = closed.iter().filter(|&&support| self.slips(support)).count();
        let first = rows.len() - slips - closed.len();
        let wanted = |row: usize| acting.get(row.wrapping_sub(first)).map_or(0.0, |(_, rate)| *rate);
        let mut right = DVector::zeros(free + rows.len());
        right.rows_mut(0, free).copy_from(&self.masses().component_mul(&state.rates));
        for &(place, impulse) in applied {
            for (index, entry) in self.projection(state, place, impulse).gradient {
                right[index] += entry;
            }
        }
        for (index, row) in rows.iter().enumerate() {
            right[free + index] = wanted(index) - row.prescribed_gap_rate;
        }
        let solution = kkt::solve(&self.matrix(&rows), &right, free)?;
        let shares = self.shares(&-solution.values.rows(free, rows.len()), &closed);
        Ok(Impact {
            rates: solution.values.rows(0, free).into_owned(),
            normal: shares.normal,
            tangential: shares.tangential,
            unique: solution.unique,
            pivots: solution.pivots,
        })
    }
}
