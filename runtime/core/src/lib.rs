//! What derived code runs on, and what is the same for every model: without its feature `std` this
//! crate is `no_std` and allocates nothing.
//!
//! - [`model`]: the traits that the derive implements; a phase, the full equations.
//! - [`kernel`], [`figure`], [`chain`]: what emitted code calls.
//! - [`scalar`]: the numbers that emitted code runs on; [`series`]: Taylor series of a phase, order
//!   by order.
//! - [`integrate`]: steppers (Taylor, DOP853, Tsitouras, Radau, Gauss) and what they share.
//! - [`project`]: back onto the constraints; [`scales`]: natural units.
//! - [`flow`](fn@flow): a motion without events.
//! - [`batch`], with `std`: a phase's equations for many states at once.
//! - [`system`], with `std`: a model with its type erased, which everything above works with.

#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("without the feature `std` elementary functions come from the feature `libm`");

#[cfg(feature = "std")]
pub mod batch;
pub mod chain;
pub mod figure;
mod flow;
pub mod hinge;
pub mod integrate;
pub mod kernel;
pub mod model;
pub mod project;
pub mod scalar;
pub mod scales;
pub mod series;
#[cfg(feature = "std")]
pub mod system;

pub use flow::{FlowError, flow};
pub use model::BarSystem;

/// What emitted code calls, by a path that the front crate has too.
#[doc(hidden)]
pub mod __private {
    pub use crate::{chain, figure, hinge, kernel, model, scalar};
}
