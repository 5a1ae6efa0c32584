//! Coordinates read off a figure; called by emitted code.

#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use core::f64::consts::{PI, TAU};

/// Direction from one position to another, counter-clockwise from +x.
pub fn direction(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]).atan2(to[0] - from[0])
}

/// The angle in (−π, π] that differs from `angle` by whole turns.
pub fn wrapped(angle: f64) -> f64 {
    let rest = angle.rem_euclid(TAU);
    if rest > PI { rest - TAU } else { rest }
}
