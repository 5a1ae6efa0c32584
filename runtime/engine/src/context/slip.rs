//! Slip velocities and coefficients of friction at a state.

use smallvec::SmallVec;

use crate::model::SlipState;
use crate::system::System;

/// Some slips; those of few contacts need no allocation.
pub(crate) type Slips = SmallVec<[SlipState<f64>; 4]>;

/// The slips of all contacts with friction at a state.
pub(crate) fn slips(system: &dyn System, state: &[f64]) -> Slips {
    let zero = SlipState { velocity: 0.0, kinetic: 0.0, limit: 0.0 };
    let mut slips = Slips::from_elem(zero, system.layout().frictions.len());
    system.slips(state, &mut slips);
    slips
}
