//! Impulses of joints. Forces are affine in the accelerations a and the reactions λ: with the
//! change of the rates in place of a, and the impulses P of the rows in place of λ,
//!
//! ```text
//! F(q, u, Δu, P) − F(q, u, 0, 0)
//! ```
//!
//! is the impulse; gravity, loads and velocities have none.

use crate::context::Numbers;
use crate::system::System;
use smallvec::smallvec;

/// Beside what is sudden, forces that are not vanish in rounding.
const SUDDEN: f64 = (1_u128 << 127) as f64;

/// The impulse of a force of the model, by its place among
/// [`Layout::quantities`](crate::model::Layout::quantities).
pub(crate) fn compute_joint_impulse(
    system: &dyn System,
    entry: usize,
    state: &[f64],
    change: &[f64],
    impulses: &[f64],
) -> f64 {
    let sudden = |values: &[f64]| -> Numbers { values.iter().map(|value| value * SUDDEN).collect() };
    let still: [Numbers; 2] = [smallvec![0.0; change.len()], smallvec![0.0; impulses.len()]];
    let with = system.quantity(entry, state, &sudden(change), &sudden(impulses));
    (with - system.quantity(entry, state, &still[0], &still[1])) / SUDDEN
}
