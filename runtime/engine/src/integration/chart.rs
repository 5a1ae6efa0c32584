//! Where a closed form holds. It is a chart of the states that satisfy its contacts: valid where
//!
//! ```text
//! embed(restrict(q, u)) = (q, u)
//! ```
//!
//! and where its pivots are large enough. Elsewhere, on the other branch of sin α = ± sin β or a turn away from it, the
//! same contacts hold and the projected form is integrated. Angles are compared as they are: a turn is a jump too. An
//! eliminated angle is a sum of others and has no fold: a chart that holds at the start of a phase is left at a pivot only.
//!
//! Positions agree within δ, the error of a state. Rates follow from them with the slopes of the gaps: where those are so
//! small that branches meet within δ, as cos α where sin α = sin β, they are some √δ, and rates agree within √δ.

use crate::integration::form_selection::least_pivot;
use crate::integration::phase_point::{Numbers, RunContext};
use crate::model::{ContactSet, Form};
use crate::system::Phase;
use smallvec::smallvec;
use std::sync::Arc;

/// What becomes of a closed form at a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Chart {
    /// It holds.
    Valid,
    /// One of its pivots is too small.
    SmallPivot,
    /// The contacts are closed on a branch that is not its own.
    OtherBranch,
    /// The set has none, or is not asked for it.
    Absent,
}

impl Chart {
    /// The form that the phase is integrated in.
    pub(crate) fn form(self) -> Form {
        if self == Self::Valid { Form::Closed } else { Form::Projected }
    }
}

/// Whether the closed form of `set` holds at a state that is known within `bound`, for a tolerance, and the phase in the form
/// that does.
pub(crate) fn at(
    context: &RunContext,
    set: ContactSet,
    state: &[f64],
    (bound, tolerance): (f64, f64),
) -> (Chart, Arc<dyn Phase>) {
    let phase = context.phase(set, Form::Closed);
    let chart = match image_of(&*phase, state, tolerance) {
        Err(chart) => chart,
        Ok(image) if agree(context, state, &image, bound) => Chart::Valid,
        Ok(_) => Chart::OtherBranch,
    };
    match chart {
        Chart::Valid | Chart::Absent => (chart, phase),
        Chart::SmallPivot | Chart::OtherBranch => (chart, context.phase(set, Form::Projected)),
    }
}

/// The state that the closed form of `set` has for what it keeps of a state; what keeps it from having one.
pub(crate) fn image(
    context: &RunContext,
    set: ContactSet,
    state: &[f64],
    tolerance: f64,
) -> Result<Numbers, Chart> {
    image_of(&*context.phase(set, Form::Closed), state, tolerance)
}

fn image_of(phase: &dyn Phase, state: &[f64], tolerance: f64) -> Result<Numbers, Chart> {
    if phase.info().form == Form::Projected {
        return Err(Chart::Absent);
    }
    let (mut reduced, mut image): (Numbers, Numbers) =
        (smallvec![0.0; phase.info().entries], smallvec![0.0; state.len()]);
    phase.restrict(state, &mut reduced);
    if phase.pivot(&reduced) < least_pivot(tolerance) {
        return Err(Chart::SmallPivot);
    }
    phase.embed(&reduced, &mut image);
    Ok(image)
}

/// Whether two states are one, within `bound` of their positions.
pub(crate) fn agree(context: &RunContext, one: &[f64], other: &[f64], bound: f64) -> bool {
    let [positions, rates] = apart(context, one, other);
    positions <= bound && rates <= bound.sqrt()
}

/// The largest difference of the coordinates of two states, and of their rates, in natural units, relative to the largest
/// entry where that is above one.
pub(crate) fn apart(context: &RunContext, one: &[f64], other: &[f64]) -> [f64; 2] {
    let layout = context.layout();
    let (n, unit) = (layout.coordinates.len(), |i: usize| context.scales.entry(layout, i));
    [0..n, n..2 * n].map(|entries| {
        let largest = entries.clone().fold(1.0, |most: f64, i| most.max(one[i].abs() / unit(i)));
        let difference = |i: usize| (one[i] - other[i]).abs() / unit(i);
        // `max` passes over what is not a number.
        let worse = |most: f64, x: f64| if x > most || x.is_nan() { x } else { most };
        entries.map(difference).fold(0.0, worse) / largest
    })
}
