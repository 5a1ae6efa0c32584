//! Numerical checks of motions computed by [`liftoff`].
//!
//! - [`reference`](mod@reference): a motion computed once more in double-double, by extrapolation.
//! - [`precision`]: error against run time, method by method and tolerance by tolerance.
//! - [`cases`]: cases with the outcome that mechanics, a closed form or another way of computing
//!   demands, and verdicts on them.
//! - [`judgement`]: a motion before an independent judge, in maximal coordinates and with contact
//!   decisions of its own.
//! - [`motion_error`]: why there is no motion, or only part of one.

pub mod cases;
pub mod judgement;
pub mod motion_error;
pub mod precision;
pub mod reference;

pub use liftoff_replay::ReplayError;
pub use motion_error::MotionError;
pub use precision::{Measurement, Precision, PrecisionError, PrecisionSpec};
pub use reference::{Reference, ReferenceError, ReferenceEvent, Source};
