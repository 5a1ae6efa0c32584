//! Events of a scalar function over one step, θ from 0 to 1, none missed: a polynomial is fitted,
//! its turning points isolated, and the function followed from one to the next, monotone in
//! between.
//!
//! The step is half open: an event at θ = 0 belongs to the step before or is known, one at θ = 1
//! counts. A minimum so near the seam of two steps that its depth is within the noise is seen by
//! the step before, at θ = 1, and may be seen again by the step after.

mod bernstein;
mod bracket;
mod decide;
mod extrema;
mod isolate;
mod locate;
mod nonsmooth;
mod partition;
mod polynomial;
mod search;
mod series;
mod sign_history;
mod smooth;
#[cfg(test)]
mod tests;

pub use decide::{watch, watch_series};
pub use extrema::ExtremumKind;
pub use locate::{Root, extrema, find_root, find_root_series};
pub use partition::{Accuracy, NODES};
pub use polynomial::last_coefficients;
pub use series::{TERMS, is_above, rest, stays_above, tail, without_zeros};
pub use sign_history::Crossing;
pub use smooth::Smooth;

impl GuardError {
    /// Maps θ to the enclosing step.
    pub fn map_theta(self, at: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::NotFinite { theta } => Self::NotFinite { theta: at(theta) },
            Self::Unresolved { theta } => Self::Unresolved { theta: at(theta) },
        }
    }
}

/// What is known of the function at θ = 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RootStart {
    /// Nothing: its value there is taken as it is.
    Free,
    /// It is zero there, within the error bound, and that is no event.
    Root,
    /// It is zero there, its first nonzero derivative is of this order, and that is no event. A
    /// series is divided by this power of θ, so that every sign after the root counts; values of a
    /// function are too inaccurate for that and are treated as for [`RootStart::Root`].
    Order(usize),
    /// The step continues one at whose end it had this sign, whatever rounding makes of it here.
    Continues {
        /// Above zero.
        positive: bool,
    },
}

/// Why a function is not followed over a step.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
pub enum GuardError {
    /// It is infinite or not a number.
    #[error("not finite at θ = {theta}")]
    NotFinite {
        /// Where in the step.
        theta: f64,
    },
    /// It turns so often that no fit shows where it is zero.
    #[error("not resolved near θ = {theta}")]
    Unresolved {
        /// Where in the step.
        theta: f64,
    },
}
