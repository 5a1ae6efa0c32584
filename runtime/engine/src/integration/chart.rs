//! Where a closed form holds. It is a chart of the states that satisfy its contacts: valid where
//!
//! ```text
//! embed(restrict(q, u)) = (q, u)
//! ```
//!
//! and where its pivots are large enough. Elsewhere, on the other branch of sin α = ± sin β or a
//! turn away from it, the same contacts hold and the projected form is integrated. Angles are
//! compared without reduction by full turns, since a turn would be a jump as well. Eliminated
//! angles are sums of the kept ones, so that a chart that holds at the start of a phase can fail
//! later only at a small pivot.
//!
//! Positions are compared to within δ, the error of a state. Rates depend on positions through the
//! Jacobian of the gaps. Where branches meet, as those of sin α = sin β at cos α = 0, positions
//! within δ leave the Jacobian, and with it the rates, unknown by √δ; rates are compared to within
//! √δ.

use crate::context::{Numbers, ROUNDINGS, RunContext, reduce};
use crate::integration::form_selection::{eliminates, least_pivot};
use crate::model::{ContactSet, Form};
use crate::system::PhaseEquations;
use smallvec::smallvec;
use std::sync::Arc;

/// Whether a closed form holds at a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Chart {
    /// It holds.
    Valid,
    /// One of its pivots is too small.
    SmallPivot,
    /// The contacts are closed on a branch that is not its own.
    OtherBranch,
    /// The set has no closed form, or it was not asked for.
    Absent,
}

/// Whether the closed form of `set` holds at a state that is known within `bound`, for a tolerance,
/// and the phase in the form that does.
pub(crate) fn choose_chart(
    context: &RunContext,
    set: ContactSet,
    state: &[f64],
    (bound, tolerance): (f64, f64),
) -> (Chart, Arc<dyn PhaseEquations>) {
    let phase = context.phase(set, Form::Reduced);
    let chart = match image_of(&*phase, state, tolerance) {
        Err(chart) => chart,
        Ok(image) if agree(context, state, &image, bound) => Chart::Valid,
        Ok(_) => Chart::OtherBranch,
    };
    match chart {
        Chart::Valid | Chart::Absent => (chart, phase),
        Chart::SmallPivot | Chart::OtherBranch => (chart, context.phase(set, Form::Multipliers)),
    }
}

/// embed(restrict(state)), or why the closed form is not to be used there.
fn image_of(phase: &dyn PhaseEquations, state: &[f64], tolerance: f64) -> Result<Numbers, Chart> {
    if phase.info().form == Form::Multipliers {
        return Err(Chart::Absent);
    }
    if !eliminates(phase) {
        return Ok(Numbers::from_slice(state));
    }
    let (reduced, image) = image(phase, state);
    if phase.pivots(&reduced).least < least_pivot(tolerance) { Err(Chart::SmallPivot) } else { Ok(image) }
}

/// restrict(state) and embed(restrict(state)), however small the pivots.
pub(crate) fn image(phase: &dyn PhaseEquations, state: &[f64]) -> (Numbers, Numbers) {
    let (reduced, mut image): (_, Numbers) = (reduce(phase, state), smallvec![0.0; state.len()]);
    phase.embed(&reduced, &mut image);
    (reduced, image)
}

/// Whether two states are one, within `bound` of their positions.
pub(crate) fn agree(context: &RunContext, one: &[f64], other: &[f64], bound: f64) -> bool {
    let [positions, rates] = apart(context, one, other);
    positions <= bound && rates <= bound.sqrt()
}

/// The largest difference of the coordinates of two states by more than their rounding, in natural
/// units, and of their rates, relative to the largest where that is above one: wherever the origin
/// is, a state is as far from another.
pub(crate) fn apart(context: &RunContext, one: &[f64], other: &[f64]) -> [f64; 2] {
    let layout = context.layout();
    let (n, unit) = (layout.coordinates.len(), |i: usize| context.scales.entry(layout, i));
    let [[far, positions], [fastest, rates]] = [0..n, n..2 * n].map(|entries| {
        let largest = entries.clone().fold(1.0, |most: f64, i| most.max(one[i].abs() / unit(i)));
        let difference = |i: usize| (one[i] - other[i]).abs() / unit(i);
        [largest, entries.map(difference).fold(0.0, nan_max)]
    });
    let rounding = ROUNDINGS * far;
    [if positions <= rounding { 0.0 } else { positions - rounding }, rates / fastest]
}

/// The larger, not a number if one is none: `max` passes over that.
pub(crate) fn nan_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}
