//! Drift removal in the mass metric: the nearest q with g(q, t) = 0, then the nearest u with J u +
//! ∂g/∂t = 0, over the closed rows; those of rough contacts have no gap, their positions are
//! corrected without slip (Eich-Soellner and Führer, *Numerical Methods in Multibody Dynamics*,
//! 5.3).

use crate::model::{Array, BarSystem, ContactSet, KernelView, Layout};
use crate::scalar::Scalar;

/// Newton corrections of the positions; drift over one step is far below the square root of the
/// roundoff.
const CORRECTIONS: usize = 4;
/// Newton's method leaves less than this part of a drift, and rounding no more than so many units
/// of it.
const LESS: f64 = 0.5;
const NOISE: f64 = 256.0;

/// Projects a full state of a model; `work` has one entry per coordinate, `length` is the natural
/// one.
pub fn project<M: BarSystem, S: Scalar>(
    constants: &M::Constants<S>,
    set: &ContactSet,
    state: &mut M::State<S>,
    length: f64,
    work: &mut [S],
) {
    let kernel = |state: &[S]| M::kernel(constants, &M::State::from_fn(|i| state[i]));
    project_by(kernel, (M::LAYOUT, set), state.as_mut(), length, work);
}

/// The same for equations that `kernel` evaluates.
pub fn project_by<S: Scalar, K: KernelView<S>>(
    kernel: impl Fn(&[S]) -> K,
    (layout, set): (&Layout, &ContactSet),
    state: &mut [S],
    length: f64,
    work: &mut [S],
) {
    let n = work.len();
    let drift = |kernel: &K| {
        let closed = (0..layout.rows()).filter(|&row| layout.is_closed(row, set));
        closed.map(|row| kernel.gap()[row].abs().to_f64() / layout.unit(row, length)).fold(0.0, f64::max)
    };
    let mut known = kernel(state);
    let mut before = f64::INFINITY;
    for _ in 0..CORRECTIONS {
        let now = drift(&known);
        // So little that a correction did not make it less is rounding.
        let rounded = if now > LESS * before { NOISE } else { 2.0 };
        if now <= rounded * S::EPSILON.to_f64() {
            break;
        }
        known.correction(layout, set, &|row| known.gap()[row], work);
        add(work, &mut state[..n]);
        (known, before) = (kernel(state), now);
    }
    let rates = &state[n..2 * n];
    let drift = |row: usize| {
        let along = known.jacobian(row).iter().zip(rates);
        along.fold(known.prescribed_gap_rate()[row], |sum, (&entry, &u)| entry.mul_add(u, sum))
    };
    known.correction(layout, set, &drift, work);
    add(work, &mut state[n..2 * n]);
}

fn add<S: Scalar>(change: &[S], to: &mut [S]) {
    for (x, d) in to.iter_mut().zip(change) {
        *x = *x + *d;
    }
}
