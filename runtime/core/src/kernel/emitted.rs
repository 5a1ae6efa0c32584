//! What emitted code of trees and of held motions needs of the dense equations.

use crate::scalar::{Real, Scalar};

/// M of bodies that hang from each other as trees: `M_ij = e_i · s_j` for every j that i carries,
/// directly or not, e_i the `reach` of i towards j, kept with the body that begins there; s the
/// first `moments`; `own` the diagonal.
pub fn mass_by_paths<S: Real, const N: usize>(
    parents: &[Option<usize>; N],
    reach: &[[S; 2]; N],
    moments: &[[S; 2]; N],
    own: &[S; N],
) -> [[S; N]; N] {
    let mut mass = [[S::ratio(0, 1); N]; N];
    write_mass(parents, reach, moments, own, mass.as_flattened_mut());
    mass
}

/// The same for any number of bodies, row by row into what is zero.
#[inline(always)]
pub fn write_mass<S: Real>(
    parents: &[Option<usize>],
    reach: &[[S; 2]],
    moments: &[[S; 2]],
    own: &[S],
    mass: &mut [S],
) {
    let n = own.len();
    for j in 0..n {
        mass[j * n + j] = own[j];
        let mut child = j;
        while let Some(i) = parents[child] {
            let entry = reach[child][0].mul_add(moments[j][0], reach[child][1] * moments[j][1]);
            (mass[i * n + j], mass[j * n + i]) = (entry, entry);
            child = i;
        }
    }
}

/// A Schur complement loses the inverse of its relative pivot: below this, more than four digits.
const LEAST_PIVOT: (i64, i64) = (1, 10_000);

/// Whether pivots are no small parts of the diagonal entries they came from (`[entry, pivot]` of
/// each).
#[inline]
pub fn are_trusted<S: Scalar>(pivots: &[[S; 2]]) -> bool {
    let least = S::ratio(LEAST_PIVOT.0, LEAST_PIVOT.1);
    pivots.iter().all(|[entry, pivot]| *pivot > *entry * least)
}
