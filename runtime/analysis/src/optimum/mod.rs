//! The least or the greatest value of an output over parameters and starts p, between bounds where
//! there are any, through the events of a run:
//!
//! ```text
//! y(p) → min,    ∇y by dual numbers and saltation
//! p = p₀ + u θ                            of a variable without bounds, u its unit
//! p = a + (b − a)(1 + sin θ)/2            between a and b
//! θ ← θ − α H ∇y                          H: from the last steps, α: such that y falls and its slope flattens
//! ```
//!
//! The search is that of Liu and Nocedal (*On the limited memory BFGS method for large scale
//! optimization*, Mathematical Programming 45, 1989) with the line search of Moré and Thuente (ACM
//! Transactions on Mathematical Software 20, 1994); bounds are those of MINUIT (James and Roos,
//! Computer Physics Communications 10, 1975).
//!
//! - `place`: variables between their bounds; `cost`: runs with their values and slopes; `search`:
//!   the way to the least value.

mod cost;
mod place;
mod search;

use liftoff::Output;
use thiserror::Error;

use crate::fit::{Ending, Place, TrialError, Vary};
use crate::sensitivity::Differentiated;

pub use place::Free;

/// An output that is to be least or greatest.
pub struct Optimum<'a> {
    /// The simulation with these values of the variables, in their order.
    pub simulate: &'a Vary<'a>,
    /// The equations on values with derivatives, given those of the parameters.
    pub model: &'a Differentiated<'a>,
    /// What may be changed, with the values that the search begins with.
    pub variables: Vec<Free>,
    /// When the output is read.
    pub place: Place,
    /// The output; none for the time of an event.
    pub output: Option<Output>,
    /// Whether the greatest value is sought.
    pub greatest: bool,
}

/// The best values that were found.
#[derive(Debug, Clone, PartialEq)]
pub struct Best {
    /// Of the variables, in their order.
    pub values: Vec<f64>,
    /// Whether each of them is at one of its bounds.
    pub at_bounds: Vec<bool>,
    /// The output there.
    pub value: f64,
    /// The output where the search began.
    pub first: f64,
    /// Derivatives of the output with respect to the variables, there.
    pub slopes: Vec<f64>,
    /// Runs that were computed.
    pub runs: usize,
    /// What ended the search.
    pub ending: Ending,
}

/// Why nothing can be sought.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OptimumError {
    /// There is nothing to change.
    #[error("nothing is varied")]
    NoVariable,
    /// A variable does not begin between its bounds.
    #[error("{name} = {value} is not between its bounds, {low} and {high}")]
    Outside {
        /// Its name.
        name: String,
        /// The value that the search begins with.
        value: f64,
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
    },
    /// The run that the search begins with has no such value, or no derivatives.
    #[error("at the initial values: {0}")]
    Start(TrialError),
}
