//! Masked equations of motion: over the closed rows of a [`Kernel`],
//!
//! ```text
//! [ M  −Jᵀ ] [ a ]   [  f ]
//! [ J   0  ] [ λ ] = [ −b ]
//! ```
//!
//! (with friction the column of a sliding contact is −(J_N − σμ J_t)ᵀ) by elimination with partial
//! pivoting of the system balanced to unit inertias and unit constraint rows, so that a massless
//! row (a row of M that vanishes) is never a pivot where a constraint can be one. Redundant
//! constraints leave columns without a pivot; of the reactions the least-norm ones are returned. A
//! singular system gives NaN, which the integrator refuses. Nothing allocates.

mod balance;
mod elimination;
mod emitted;
mod lever;
mod refinement;
mod view;

#[cfg(feature = "std")]
pub(crate) use balance::balance;
pub use elimination::{Room, Workspace};
pub use lever::lever;
#[cfg(feature = "std")]
pub(crate) use refinement::{MatrixShape, factorise};

pub use emitted::{are_trusted, mass_by_paths, write_mass};

use crate::model::{ContactSet, Kernel, KernelView, Layout};
use crate::scalar::{Real, Scalar};
use elimination::{Load, solve};

/// Time derivative of the full state, `Y` entries: rates, then accelerations with the rows of `set`
/// closed, then those of [`Layout::slope`].
pub fn derivative<S, const N: usize, const C: usize, const D: usize, const Y: usize>(
    kernel: &Kernel<S, N, C, D>,
    layout: &Layout,
    set: &ContactSet,
    state: &[S; Y],
) -> [S; Y]
where
    S: Scalar,
{
    let (mut accelerations, mut multipliers) = ([S::ZERO; N], [S::ZERO; C]);
    solution(kernel, layout, set, &mut accelerations, &mut multipliers);
    slopes(layout, state, &accelerations)
}

/// ẏ of a full state: its rates, their accelerations, then the slopes of the time and the switches.
#[inline]
pub(crate) fn slopes<S: Real, const Y: usize>(layout: &Layout, state: &[S], accelerations: &[S]) -> [S; Y] {
    let n = accelerations.len();
    core::array::from_fn(|i| match i {
        _ if i < n => state[n + i],
        _ if i < 2 * n => accelerations[i - n],
        _ => S::ratio(layout.slope(i), 1),
    })
}

/// Reactions of the contacts, zero where open, then the friction forces; `R` in all.
pub fn reactions<S, const N: usize, const C: usize, const D: usize, const R: usize>(
    kernel: &Kernel<S, N, C, D>,
    layout: &Layout,
    set: &ContactSet,
) -> [S; R]
where
    S: Scalar,
{
    if set.is_empty() {
        return [S::ZERO; R];
    }
    let (mut accelerations, mut multipliers) = ([S::ZERO; N], [S::ZERO; C]);
    solution(kernel, layout, set, &mut accelerations, &mut multipliers);
    core::array::from_fn(|entry| multipliers[layout.row_of_reaction(entry)])
}

/// Writes the motion with the rows of `set` closed: accelerations, and the multiplier of every row,
/// zero where open; whether the multipliers are the only ones. One copy for all models of these
/// dimensions.
#[inline(never)]
pub(crate) fn solution<S: Scalar, const N: usize, const C: usize, const D: usize>(
    kernel: &Kernel<S, N, C, D>,
    layout: &Layout,
    set: &ContactSet,
    accelerations: &mut [S; N],
    multipliers: &mut [S; C],
) -> bool {
    let mut room = Room::<S, C, D>::default();
    solve_in(room.workspace(), kernel, layout, set, accelerations, multipliers)
}

/// The same for equations of any dimension.
#[inline(always)]
pub fn solve_in<S: Scalar>(
    workspace: Workspace<'_, S>,
    kernel: &impl KernelView<S>,
    layout: &Layout,
    set: &ContactSet,
    accelerations: &mut [S],
    multipliers: &mut [S],
) -> bool {
    let n = accelerations.len();
    let (closed, solution, unique) = solve(workspace, kernel, layout, set, Load::Motion);
    accelerations.copy_from_slice(&solution[..n]);
    multipliers.fill(S::ZERO);
    for (&row, multiplier) in closed.iter().zip(&solution[n..]) {
        multipliers[row] = *multiplier;
    }
    for (_, friction) in layout.sliding(set) {
        multipliers[friction.row] = -kernel.friction()[friction.row] * multipliers[friction.contact];
    }
    unique
}

/// Writes the least change d in the mass metric with `J d = −r` over the rows closed in `set`.
#[inline(always)]
pub fn correct_in<S: Scalar>(
    workspace: Workspace<'_, S>,
    kernel: &impl KernelView<S>,
    layout: &Layout,
    set: &ContactSet,
    residual: &dyn Fn(usize) -> S,
    change: &mut [S],
) {
    let (_, solution, _) = solve(workspace, kernel, layout, set, Load::Residual(residual));
    change.copy_from_slice(&solution[..change.len()]);
}
