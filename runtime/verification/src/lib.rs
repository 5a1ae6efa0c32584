//! Numerical checks of motions computed by [`liftoff`].
//!
//! - [`reference`](mod@reference): a motion computed once more in double-double, by extrapolation.
//! - [`precision`]: error against run time, method by method and tolerance by tolerance.
//! - [`cases`]: cases with the outcome that mechanics, a closed form or another way of computing demands, and verdicts on
//!   them.
//! - [`failure`]: why there is no motion, or only part of one.

pub mod cases;
pub mod failure;
pub mod precision;
pub mod reference;

pub use failure::Failure;
pub use precision::{Measurement, Precision, PrecisionError, PrecisionSpec};
pub use reference::{Reference, ReferenceError};
