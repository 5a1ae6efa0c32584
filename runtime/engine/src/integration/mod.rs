//! The equations of one phase as methods integrate them.
//!
//! - [`method`]: what makes the steps; [`phase_point`]: the motion at one time.
//! - [`form_selection`]: closed form or multipliers; [`chart`]: where a closed form holds.
//! - [`equilibrium`]: phases that never move; [`singular`]: positions where closed loops lose rank.

pub(crate) mod chart;
pub(crate) mod equilibrium;
pub(crate) mod form_selection;
pub mod method;
pub(crate) mod phase_point;
pub(crate) mod singular;
