//! Steps of an integrator, one after the other.

use core::f64::consts::PI;

use super::super::{Crossing, RootStart, extrema, watch};
use crate::integrate::{Dop853, StepState, Stepper, Tolerance};

/// A harmonic motion y = sin t by DOP853: what happens to 1 + η − y within a hundred periods.
fn swings(eta: f64) -> [usize; 3] {
    let field = |s: &[f64; 2]| [s[1], -s[0]];
    let tolerance = Tolerance::new(1e-13, [1e-13; 2]).expect("a valid tolerance");
    let end = 200.0 * PI;
    let mut solver = Dop853::new(&field, StepState::new(tolerance, 0.0, [0.0, 1.0]).with_end(end));
    let (mut touches, mut crossings, mut turns) = (Vec::new(), 0, Vec::new());
    while solver.step_state().time() < end {
        solver.step().expect("a smooth motion");
        let dense = solver.dense();
        let gap = |theta| 1.0 + eta - dense.interpolate(theta)[0];
        match watch(gap, RootStart::Free, 1e-9).expect("finite") {
            Crossing::Touch { theta, .. } => touches.push(dense.t0 + theta * dense.h),
            Crossing::At { .. } => crossings += 1,
            Crossing::Clear | Crossing::LeavesAtStart => (),
        }
        extrema(gap, 1e-12, |e| turns.push(dense.t0 + e.theta * dense.h)).expect("finite");
    }
    // The same one may be seen on either side of a seam, as far apart as 1e-12 in height.
    touches.dedup_by(|a, b| *a - *b < 1e-5);
    turns.dedup_by(|a, b| *a - *b < 1e-5);
    [touches.len(), crossings, turns.len()]
}

/// The energy drifts by 2.5e-14 a period and less, far below η.
#[test]
fn every_swing_touches_or_crosses_once() {
    assert_eq!(swings(0.0), [100, 0, 200]);
    assert_eq!(swings(1e-8), [0, 0, 200]);
    assert_eq!(swings(-1e-8), [0, 100, 200]);
}
