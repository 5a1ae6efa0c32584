//! Events of a scalar function over one step, θ from 0 to 1, none missed: a polynomial is fitted, its
//! turning points isolated, and the function followed from one to the next, monotone in between.
//!
//! The step is half open: an event at θ = 0 belongs to the step before or is known, one at θ = 1 counts.
//! A minimum so near the seam of two steps that its depth is within the noise is seen by the step
//! before, at θ = 1, and may be seen again by the step after.

mod bracket;
mod decide;
mod isolate;
mod locate;
mod partition;
mod polynomial;
#[cfg(test)]
mod tests;
mod zigzag;

pub use decide::{Verdict, watch, watch_sampled};
pub use locate::{extrema, first_root};
pub use partition::{NODES, Samples};
pub use zigzag::{Extremum, ExtremumKind};

/// What is known of the function at θ = 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Start {
    /// Nothing: the step continues another, or the value is whatever it is.
    Free,
    /// It is zero there, within the error bound, and that is no event.
    Root,
}

/// The function is infinite or not a number.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
#[error("not finite at θ = {theta}")]
pub struct NotFinite {
    /// Where in the step.
    pub theta: f64,
}
