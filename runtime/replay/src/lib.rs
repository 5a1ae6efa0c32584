//! A run once more on other numbers: in double-double to see its error, on dual numbers to know its
//! derivatives.
//!
//! The run tells which contacts were closed when, and which guard ended each phase. Each phase is
//! integrated by Gragg's extrapolated method, to the root of that guard nearest to where the run
//! found it; impacts are solved from the contacts that acted. What is taken from the run is then
//! its contact sets, its equations and the order of its events.
//!
//! - [`replay`]: phases and impacts in their order; [`replay_outputs`]: outputs at times and behind
//!   events on the way ([`Reading`]).
//! - `model`: the equations of a phase; `extrapolation` integrates them, `root` finds its end,
//!   `instant` evaluates guards, with the `arithmetic` of conditions; [`difference`]: those on
//!   positions and rates alone.
//! - `collision`: rates after an impact, `friction`: of contacts with friction; `linear`: equations
//!   for it.
//! - [`Number`]: what can be computed with.

mod arithmetic;
mod collision;
mod error;
mod extrapolation;
mod friction;
mod instant;
mod kinematic;
mod linear;
mod model;
mod number;
mod reading;
mod replay;
mod root;

pub use error::ReplayError;
pub use kinematic::difference;
pub use number::Number;
pub use reading::{Moment, Reading};
pub use replay::{Replayed, replay, replay_outputs};
