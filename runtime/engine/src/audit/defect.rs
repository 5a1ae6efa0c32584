//! The work within a step, from what its dense output y(t) has beside the equations y' = f(y):
//!
//! ```text
//! W = ∫ E_y f dt = E(y₁) − E(y₀) − ∫ E_y (y' − f) dt
//! ```
//!
//! by Simpson's rule, as the defect δ = h (y' − f) is zero at the start, and with E_y δ ≈ E(y + δ) − E(y): two evaluations of the
//! equations a step, however much the power changes within it. What a projection changes at the end of a step is no work.

use crate::integrate::DenseOutput;
use crate::integration::phase_point::Numbers;
use crate::system::Phase;
use smallvec::smallvec;

/// The middle and the end of a step, which is before what a projection makes of it, and their weights.
const NODES: [(f64, f64); 2] = [(0.5, 4.0 / 6.0), (1.0 - 0.5 * f64::EPSILON, 1.0 / 6.0)];

/// W of a step up to θ = `end`; not a number where the energy is none.
pub(crate) fn work_of(phase: &dyn Phase, dense: &DenseOutput, end: f64) -> f64 {
    let room = || -> Numbers { smallvec![0.0; dense.entries()] };
    let (mut y, mut slope, mut rate) = (room(), room(), room());
    dense.at(0.0, &mut y);
    let start = phase.energy(&y);
    let (mut gained, mut made) = (0.0, 0.0);
    for (node, weight) in NODES {
        let theta = node * end;
        dense.at(theta, &mut y);
        dense.slope(theta, &mut slope);
        phase.derivative(&y, &mut rate);
        let energy = phase.energy(&y);
        gained = energy.gained_since(&start);
        y.iter_mut()
            .zip(&slope)
            .zip(&rate)
            .for_each(|((y, slope), rate)| *y += end * (slope - dense.h * rate));
        made += weight * phase.energy(&y).gained_since(&energy);
    }
    gained - made
}

#[cfg(test)]
mod tests;
