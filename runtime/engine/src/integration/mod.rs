//! One phase of a motion, from its start to its first event.
//!
//! - [`phase_run`]: the steps, and what ends them; [`method`]: what makes them; [`phase_point`]: the motion at one time.
//! - [`form_selection`]: closed form or multipliers; [`chart`]: where a closed form holds.
//! - [`equilibrium`]: phases that never move; [`singular`]: positions where closed loops lose rank.
//! - [`legendre`]: functions over a step by Gauss's points.
//! - [`phase_handle`]: a phase's equations without integrator.

pub(crate) mod chart;
pub(crate) mod equilibrium;
pub(crate) mod form_selection;
pub(crate) mod legendre;
pub mod method;
pub(crate) mod phase_handle;
pub(crate) mod phase_point;
pub(crate) mod phase_run;
pub(crate) mod singular;
