//! Least squares of parameters and starts p to measured values ŷᵢ of standard deviations σᵢ,
//! through the events of a run:
//!
//! ```text
//! rᵢ(p) = (yᵢ(p) − ŷᵢ) / σᵢ,    ‖r(p)‖ → min,    J = ∂r/∂p
//! (JᵀJ + λD²) δ = −Jᵀr,    p ← p + δ              λ such that ‖Dδ‖ ≤ Δ, a trust region
//! s² = ‖r‖² / (m − n),    C = s² (JᵀJ)⁻¹           of m values and n variables
//! pₖ ± t √Cₖₖ                                      t: the 0.975 quantile of Student's distribution of m − n degrees of freedom
//! ```
//!
//! yᵢ is an output at a given time, the time of an event, or an output right behind one. The search
//! is MINPACK's (Moré, *The Levenberg-Marquardt algorithm: implementation and theory*, Lecture
//! Notes in Mathematics 630, 1978); errors are those of the linear approximation at its end (Bates
//! and Watts, *Nonlinear Regression Analysis and Its Applications*, 1988, chapter 2). Derivatives
//! are those of [`Sensitivities`](crate::Sensitivities), for the sequence of events that the run
//! has.
//!
//! - `datum`: what is measured; `trial`: one run with its residuals and their derivatives.
//! - `search`: the way to the least sum of squares; `estimate`: what the data say of the variables
//!   there.

mod datum;
mod error;
mod estimate;
mod search;
pub(crate) mod trial;

use liftoff::Simulation;

use crate::Variable;
use crate::sensitivity::Differentiated;

pub use datum::{Datum, Place};
pub use error::FitError;
pub use estimate::Estimate;
pub use trial::TrialError;

/// The simulation with these values of the variables; or why there is none.
pub type Vary<'a> = dyn Fn(&[f64]) -> Result<Simulation, String> + 'a;

/// Measured values, and what is to be found from them.
pub struct Fit<'a> {
    /// The simulation with these values of the variables, in their order.
    pub simulate: &'a Vary<'a>,
    /// The equations on values with derivatives, given those of the parameters.
    pub model: &'a Differentiated<'a>,
    /// What is to be found, with the values that the search begins with.
    pub variables: Vec<Variable>,
    /// What was measured.
    pub data: Vec<Datum>,
}

/// What the data say.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// Of each variable.
    pub estimates: Vec<Estimate>,
    /// Correlations of the estimates, row by row.
    pub correlations: Vec<Vec<f64>>,
    /// Computed less measured, of each datum in its unit.
    pub residuals: Vec<f64>,
    /// ‖r‖, in standard deviations as they were given.
    pub norm: f64,
    /// m − n.
    pub freedom: usize,
    /// s, by which the standard deviations that were given are to be multiplied; none without a
    /// degree of freedom.
    pub scatter: Option<f64>,
    /// Steps that came nearer.
    pub iterations: usize,
    /// Runs that were computed.
    pub runs: usize,
    /// What ended the search.
    pub ending: Ending,
}

/// What ended a search.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// No step of more than rounding comes nearer.
    Converged,
    /// It stopped before, for this reason; the values are the best until then.
    Stopped(String),
}
