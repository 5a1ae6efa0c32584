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

use crate::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};
use crate::moment::seen;
use crate::pivot::least_pivot;
use crate::scales::Scales;

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

/// Whether the closed form of `set` holds at a state that is known within `bound`, for a tolerance.
pub(crate) fn at<M: BarSystem>(
    (constants, scales): (&M::Constants<f64>, &Scales),
    set: ContactSet,
    state: &M::State<f64>,
    (bound, tolerance): (f64, f64),
) -> Chart {
    match image::<M>(constants, set, state, tolerance) {
        Err(chart) => chart,
        Ok(image) if agree::<M>(scales, state, &image, bound) => Chart::Valid,
        Ok(_) => Chart::OtherBranch,
    }
}

/// The state that the closed form of `set` has for what it keeps of a state; what keeps it from having one.
pub(crate) fn image<M: BarSystem>(
    constants: &M::Constants<f64>,
    set: ContactSet,
    state: &M::State<f64>,
    tolerance: f64,
) -> Result<M::State<f64>, Chart> {
    M::phase(set, Form::Closed, Image { constants, state, least: least_pivot(tolerance) })
}

/// Whether two states are one, within `bound` of their positions.
pub(crate) fn agree<M: BarSystem>(
    scales: &Scales,
    one: &M::State<f64>,
    other: &M::State<f64>,
    bound: f64,
) -> bool {
    let [positions, rates] = apart::<M>(scales, one, other);
    positions <= bound && rates <= bound.sqrt()
}

/// The largest difference of the coordinates of two states, and of their rates, in natural units, relative to the largest
/// entry where that is above one.
pub(crate) fn apart<M: BarSystem>(scales: &Scales, one: &M::State<f64>, other: &M::State<f64>) -> [f64; 2] {
    let (one, other, units) = (seen::<M>(one), seen::<M>(other), scales.state::<M>());
    let n = M::LAYOUT.coordinates.len();
    [0..n, n..2 * n].map(|entries| {
        let largest = entries.clone().fold(1.0, |most: f64, i| most.max(one[i].abs() / units[i]));
        let difference = |i: usize| (one[i] - other[i]).abs() / units[i];
        // `max` passes over what is not a number.
        let worse = |most: f64, x: f64| if x > most || x.is_nan() { x } else { most };
        entries.map(difference).fold(0.0, worse) / largest
    })
}

struct Image<'a, M: BarSystem> {
    constants: &'a M::Constants<f64>,
    state: &'a M::State<f64>,
    least: f64,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Image<'_, M> {
    type Output = Result<M::State<f64>, Chart>;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Self::Output {
        let reduced = (phase.restrict)(self.state);
        match phase.form {
            Form::Projected => Err(Chart::Absent),
            Form::Closed if (phase.pivot)(self.constants, &reduced) >= self.least => {
                Ok((phase.embed)(self.constants, &reduced))
            }
            Form::Closed => Err(Chart::SmallPivot),
        }
    }
}
