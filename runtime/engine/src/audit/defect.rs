//! The work within a step, from what its dense output y(t) has beside the equations y' = f(y):
//!
//! ```text
//! W = ∫ E_y f dt = E(y₁) − E(y₀) − ∫ E_y (y' − f) dt
//! ```
//!
//! by Simpson's rule, as the defect δ = h (y' − f) is zero at the start, and with E_y δ ≈ ½ (E(y +
//! δ) − E(y − δ)): two evaluations of the equations a step, however much the power changes within
//! it. What a projection changes at the end of a step is no work. A stiff f makes of the error of a
//! state a defect that is too large for that.

use crate::context::{Numbers, RunContext};
use crate::system::{DenseOutput, PhaseEquations};
use smallvec::smallvec;

/// The middle and the end of a step, and their weights.
const NODES: [(f64, f64); 2] = [(0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)];

/// W of a step up to θ = `end`; none where the defect is so large that its third power matters
/// beside the tolerance, or the energy is no number.
pub(crate) fn work_of(
    context: &RunContext,
    phase: &dyn PhaseEquations,
    (dense, end): (&DenseOutput, f64),
    tolerance: f64,
) -> Option<f64> {
    let room = || -> Numbers { smallvec![0.0; dense.entries()] };
    let (mut y, mut defect, mut rate) = (room(), room(), room());
    let unit = |entry: usize| context.scales.entry(context.layout(), entry);
    let most = 0.5 * tolerance.cbrt();
    dense.interpolate(0.0, &mut y);
    let start = phase.energy(&y);
    let (mut gained, mut made) = (0.0, 0.0);
    for (theta, weight) in NODES.map(|(node, weight)| (node * end, weight)) {
        dense.with_slope(theta, &mut y, &mut defect);
        phase.derivative(&y, &mut rate);
        defect.iter_mut().zip(&rate).for_each(|(slope, rate)| *slope = end * (*slope - dense.h * rate));
        let is_small =
            |((&kept, y), defect): ((&usize, &f64), &f64)| defect.abs() <= most * unit(kept).max(y.abs());
        if !phase.kept().iter().zip(&y).zip(&defect).all(is_small) {
            return None;
        }
        gained = phase.energy(&y).gained_since(&start);
        y.iter_mut().zip(&defect).for_each(|(y, defect)| *y += defect);
        let ahead = phase.energy(&y);
        y.iter_mut().zip(&defect).for_each(|(y, defect)| *y -= 2.0 * defect);
        made += 0.5 * weight * ahead.gained_since(&phase.energy(&y));
    }
    Some(gained - made).filter(|work| work.is_finite())
}

#[cfg(test)]
mod tests;
