//! What follows from a model without running it: where it rests, what its contacts bear there, and
//! how it moves nearby.
//!
//! ```text
//! model, figure → subject → local equations of a contact set → equilibrium, linearisation → modes of vibration
//! ```
//!
//! All derivatives at rest are central differences of the model's own equations in double-double:
//! with steps of 1e-9 they are exact to all digits of a double.
//!
//! - `numeric`: least squares, minima, linear programs and quantiles, on numbers alone.
//! - [`Subject`]: a model with its parameters, its natural units, and a figure to begin with.
//! - `local`: the motion of one contact set near a position at rest, in tangent coordinates that
//!   are orthonormal in the mass metric.
//! - [`Linearisation`], and its [`Mode`]s of vibration; [`BySymmetry`]: what keeps the symmetry of
//!   a position, and what breaks it.
//! - [`equilibria`]: `newton`, of one contact set; `bearing`, what the contacts bear, between which
//!   bounds where that is not unique; `search`, of all sets; [`load_limit`], how far a parameter
//!   may go.
//! - [`Sensitivities`]: derivatives of a run, of its event times and states, through its events;
//!   `start`, of what it starts in.
//! - [`Fit`]: parameters and starts by least squares from measured series and event times, with
//!   their errors.
//! - [`Optimum`]: parameters and starts with which an output is least or greatest.
//! - [`ReturnMap`]: periodic orbits ([`Orbit`]) and their multipliers.

mod equilibrium;
mod error;
mod fit;
mod linear;
mod local;
mod mode;
mod numeric;
mod optimum;
mod orbit;
mod sensitivity;
mod subject;
mod symmetry;

pub use equilibrium::{
    Equilibrium, JointForce, LimitEnd, Load, LoadLimit, Stability, equilibria, load_limit,
};
pub use error::{AnalysisError, SensitivityError};
pub use fit::{Datum, Ending, Estimate, Fit, FitError, Fitted, Place, TrialError};
pub use linear::Linearisation;
pub use mode::Mode;
pub use optimum::{Best, Free, Optimum, OptimumError};
pub use orbit::{
    Branch, BranchEnd, BranchPoint, Orbit, OrbitError, OrbitStability, ReturnMap, Section, Simulate, Special,
    describe_events,
};
pub use sensitivity::{Derivatives, Differentiated, Sensitivities, Variable};
pub use subject::Subject;
pub use symmetry::BySymmetry;
