//! Limit analysis: of all loads of edges that hold a motion, those that keep farthest from zero,
//!
//! ```text
//! s → max,    Σ aₑ (xₑ + s) = Jᵀ λ,    xₑ ≥ 0
//! ```
//!
//! At s = 0 no reactions within the cones are left. The dual is the kinematic theorem: s is the
//! least power `Jᵀ λ · w` of a virtual velocity w with `aₑ · w ≥ 0` and `Σ aₑ · w = 1`, and the
//! contacts slip or open with it (Drucker, *Coulomb friction, plasticity, and limit loads*, J.
//! Appl. Mech. 21, 1954).

use nalgebra::{DMatrix, DVector};

use super::lemke;
use crate::numerics::decomposition::{self, range};
use crate::numerics::zero::RANK;

/// So many edges are looked at before others.
const FEW: usize = 16;

/// The farthest that loads can be from zero.
pub(super) struct Limit {
    /// s.
    pub(super) margin: f64,
    /// aₑ · w of each edge in the motion that follows at s = 0.
    pub(super) velocities: DVector<f64>,
    /// xₑ + s of each edge.
    pub(super) loads: DVector<f64>,
}

/// An orthonormal basis of the combinations of edges' loads that the motion determines, while other
/// rows bear anything.
pub(super) fn row_space(edges: &[DVector<f64>], others: &[DVector<f64>]) -> DMatrix<f64> {
    let mut columns = DMatrix::from_columns(edges);
    if !others.is_empty() {
        let basis = range(&DMatrix::from_columns(others));
        columns -= &basis * basis.tr_mul(&columns);
    }
    range(&columns.transpose())
}

/// The limit for any loads of the edges that hold the motion. `None` where s has no bound. A few
/// edges are solved for first; an edge that their motion violates is added.
pub(super) fn find_limit(space: &DMatrix<f64>, loads: &DVector<f64>) -> Option<Limit> {
    let (m, size) = (space.nrows(), loads.amax());
    if size == 0.0 {
        return Some(Limit {
            margin: 0.0,
            velocities: DVector::repeat(m, 1.0 / m as f64),
            loads: loads.clone(),
        });
    }
    // Loads that are shifted alike on all edges shift s, which is then positive.
    let shift = 1.0 - loads.min().min(0.0) / size;
    let held = space.tr_mul(&(loads / size).add_scalar(shift));
    let mut asked = spread(m, FEW);
    loop {
        let Some(Limit { margin, velocities, loads }) = limit_by(space, &asked, &held) else {
            if asked.len() == m {
                return None;
            }
            asked = spread(m, 2 * asked.len());
            continue;
        };
        let worst = velocities.argmin().0;
        if velocities[worst] >= -RANK * velocities.amax() || asked.contains(&worst) {
            let loads = loads.add_scalar(-shift) * size;
            return Some(Limit { margin: (margin - shift) * size, velocities, loads });
        }
        asked.push(worst);
    }
}

/// So many of some places, the first and the last among them.
fn spread(places: usize, count: usize) -> Vec<usize> {
    let count = count.min(places);
    (0..count).map(|k| k * (places - 1) / (count - 1).max(1)).collect()
}

/// The same where some of the edges alone bound s.
fn limit_by(space: &DMatrix<f64>, asked: &[usize], held: &DVector<f64>) -> Option<Limit> {
    let (m, r) = (asked.len(), space.ncols());
    let edge = |i: usize, j: usize| if i < m { space[(asked[i], j)] } else { space.column(j).sum() };
    let bounds = DMatrix::from_fn(m + 1, r, edge);
    let mut matrix = DMatrix::zeros(2 * r + m + 1, 2 * r + m + 1);
    for (start, sign) in [(0, 1.0), (r, -1.0)] {
        matrix.view_mut((start, 2 * r), (r, m + 1)).copy_from(&(bounds.transpose() * -sign));
        matrix.view_mut((2 * r, start), (m + 1, r)).copy_from(&(&bounds * sign));
    }
    let mut q = DVector::zeros(2 * r + m + 1);
    q.rows_mut(0, r).copy_from(held);
    q.rows_mut(r, r).copy_from(&-held);
    q[2 * r + m] = -1.0;
    let basic = lemke::solve(&matrix, &q, &DVector::repeat(q.len(), 1.0))?;
    // Where loads vanish fewer edges bear than the motion has components: the others of these are
    // zero at the vertex.
    let bearing: Vec<usize> = (0..=m).filter(|&i| basic[2 * r + i]).collect();
    let moving: Vec<usize> = (0..r).filter(|&j| basic[j] || basic[r + j]).collect();
    let tight = bounds.select_rows(&bearing).select_columns(&moving);
    let last = bearing.iter().position(|&i| i == m)?;
    let svd = decomposition::svd(tight.clone());
    let cutoff = RANK * svd.singular_values.amax();
    let unit = DVector::from_fn(bearing.len(), |i, _| if i == last { 1.0 } else { 0.0 });
    let velocities = space.select_columns(&moving) * svd.solve(&unit, cutoff).ok()?;
    let borne = decomposition::svd(tight.transpose()).solve(&held.select_rows(&moving), cutoff).ok()?;
    let mut loads = DVector::repeat(space.nrows(), borne[last]);
    let of_edges = bearing.iter().zip(borne.iter()).filter(|(i, _)| **i < m);
    of_edges.for_each(|(&i, x)| loads[asked[i]] += x);
    Some(Limit { margin: borne[last], velocities, loads })
}

#[cfg(test)]
mod tests;
