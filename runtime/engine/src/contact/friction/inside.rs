//! Reactions inside the bounds of their contacts. Contacts that share a load can bear it in many
//! ways, some of them with a contact at its limit or without load. Only what no way of sharing
//! avoids is left to the next order: the loads of the cones' edges are moved as far inside as they
//! can be ([`super::limit`]).

use nalgebra::{DMatrix, DVector};

use super::limit::{Limit, find_limit, row_space};
use super::modes::ModeChoice;
use super::problem::{BalancedProblem, Trial};
use crate::numerics::decomposition::range;
use crate::numerics::zero::MARGIN;

impl BalancedProblem<'_> {
    /// The same motion with reactions moved inside. `None` where they are determined, or where
    /// some are at their bounds, or all but, however the load is shared.
    pub(super) fn move_inside(&self, chosen: &[usize], trial: &Trial) -> Option<Trial> {
        if self.units.iter().any(|unit| unit.given.is_some()) {
            return None;
        }
        let choices: Vec<&ModeChoice> =
            self.units.iter().zip(chosen).map(|(unit, &k)| &unit.choices[k]).collect();
        let closed = self.closed(&choices.iter().map(|choice| choice.mode).collect::<Vec<_>>());
        let (edges, signed) = self.edges(&choices, &closed);
        let of_edges = closed.build_edge_matrix(&edges)?;
        let multipliers =
            DVector::from_iterator(closed.rows.len(), closed.rows.iter().map(|&row| trial.reactions[row]));
        let loads = of_edges.clone().lu().solve(&multipliers)?;
        let n = self.kkt.n;
        let columns =
            self.kkt.equations(&closed).ok()?.matrix.view((0, n), (n, closed.rows.len())) * &of_edges;
        let column = |k: &usize| columns.column(*k).into_owned();
        let (pressing, others): (Vec<usize>, Vec<usize>) = (0..edges.len()).partition(|&k| signed[k]);
        if pressing.is_empty() {
            return None;
        }
        let determined = row_space(
            &pressing.iter().map(column).collect::<Vec<_>>(),
            &others.iter().map(column).collect::<Vec<_>>(),
        );
        let is_free = |k: &usize| determined.row(*k).norm_squared() < 1.0 - MARGIN * MARGIN;
        let free: Vec<usize> = (0..pressing.len()).filter(is_free).collect();
        if free.is_empty() {
            return None;
        }
        let found = move_loads(
            &range(&determined.select_rows(&free)),
            &DVector::from_iterator(free.len(), free.iter().map(|&k| loads[pressing[k]])),
        )?;
        let mut moved = loads;
        free.iter().zip(found.iter()).for_each(|(&k, load)| moved[pressing[k]] = *load);
        let x = DVector::from_iterator(
            n + closed.rows.len(),
            trial.a.iter().chain((of_edges * moved).iter()).copied(),
        );
        Some(Trial { unique: trial.unique, determined: trial.determined, ..self.trial(&closed, &x) })
    }
}

/// Loads that are clearly positive and as far from zero as can be, but no farther than the largest
/// of them was.
fn move_loads(determined: &DMatrix<f64>, loads: &DVector<f64>) -> Option<DVector<f64>> {
    let (m, r) = determined.shape();
    // An edge of its own whose load is determined bounds the margin.
    let mut bounded = determined.clone().resize(m + 1, r + 1, 0.0);
    bounded[(m, r)] = 1.0;
    let largest = loads.amax();
    let Limit { margin, loads, .. } = find_limit(&bounded, &loads.push(largest))?;
    (margin > MARGIN * largest).then(|| loads.rows(0, m).into_owned())
}

#[cfg(test)]
mod tests;
