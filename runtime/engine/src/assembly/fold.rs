//! Positions at a fold. Where the gaps that complete a pose are flat along what is left open, as x² +
//! y² = r² is along x at y = r, they leave it unknown by the square root of a rounding. The fold
//! itself is known: there the gap has no slope,
//!
//! ```text
//! uᵀ J(q) v = 0,    u and v those of the least singular value of J
//! ```

use super::problem::AssemblyProblem;
use crate::numerics::decomposition::{singular_values, svd};
use crate::numerics::zero::{MARGIN, roundoff};

/// A singular value below this is that of a fold nearby, in natural units.
const FLAT: f64 = 1e-6;
/// Half the span of the difference that gives the curvature.
const SPAN: f64 = 1e-4;
/// Gaps with this many roundings are closed at the fold as well as beside it.
const ROUNDED: f64 = roundoff(4.0);

/// Moves what was left open onto a fold of the closed rows, if that is within the rounding of their
/// gaps.
pub(super) fn settle_on_fold(
    assembly: &AssemblyProblem<'_>,
    (closed, free): (&[usize], &[usize]),
    unit: &[f64],
    q: &mut [f64],
) {
    let jacobian = |q: &[f64]| assembly.jacobian(q, (closed, free));
    let here = jacobian(q);
    // By a fraction of the work, where no fold is near.
    if singular_values(here.clone()).last().is_none_or(|least| *least > 2.0 * FLAT) {
        return;
    }
    let svd = svd(here);
    let (Some(left), Some(right)) = (&svd.u, &svd.v_t) else { return };
    let least = svd.singular_values.argmin().0;
    let slope = svd.singular_values[least];
    let (row, along) = (left.column(least), right.row(least).transpose());
    if slope > FLAT {
        return;
    }
    let moved = |by: f64| -> Vec<f64> {
        let mut moved = q.to_vec();
        free.iter().enumerate().for_each(|(k, &i)| moved[i] += by * along[k] * unit[k]);
        moved
    };
    let slope_at = |by: f64| row.dot(&(jacobian(&moved(by)) * &along));
    let curvature = (slope_at(SPAN) - slope_at(-SPAN)) / (2.0 * SPAN);
    // Where more rows are closed than needed they are flat along the motion too, and stay so.
    if curvature.abs() < MARGIN {
        return;
    }
    let fold = moved(-slope / curvature);
    if fold.iter().all(|x| x.is_finite()) && assembly.gaps(&fold, closed).amax() <= ROUNDED {
        q.copy_from_slice(&fold);
    }
}
