//! Periodic orbits: fixed points of the map P that takes a state on a section to the next one
//! there,
//!
//! ```text
//! P(x*) = x* + s,    (∂P/∂x T − T) ξ = x + s − P(x),  x ← x + T ξ      Newton's method
//! ∂P/∂x T = T M,     |λ| < 1 of all eigenvalues λ of M                  stable
//! ```
//!
//! with T the tangent directions of the surface of starts ([`surface`]), and s a shift of the
//! coordinates that are said to drift, the distance of a walker's step, say. λ are the multipliers
//! (Nayfeh and Balachandran, *Applied Nonlinear Dynamics*, 1995, 3.2 and 3.3; through events Leine
//! and Nijmeijer, *Dynamics and Bifurcations of Non-Smooth Mechanical Systems*, 2004, chapter 9).
//! Derivatives are those of [`Sensitivities`](crate::Sensitivities).
//!
//! - `section`: where a motion is looked at; `surface`: where its starts lie; `turn`: one run with
//!   its derivatives.
//! - `newton`: the search; `branch`: orbits followed in a parameter.

mod branch;
mod error;
mod newton;
mod section;
mod surface;
mod turn;

use liftoff::{EventKind, Simulation};
use nalgebra::Complex;

use crate::sensitivity::Differentiated;

pub use branch::{Branch, BranchEnd, BranchPoint, Special};
pub use error::OrbitError;
pub use section::Section;

/// The simulation with some parameters from a state, coordinates then rates; or why there is none.
pub type Simulate<'a> = dyn Fn(&[f64], &[f64]) -> Result<Simulation, String> + 'a;

/// What makes the map of a section.
pub struct ReturnMap<'a> {
    /// The simulation with these parameters from a state, coordinates then rates.
    pub simulate: &'a Simulate<'a>,
    /// The equations on values with derivatives, given those of the parameters.
    pub model: &'a Differentiated<'a>,
    /// Where the motion is looked at.
    pub section: Section,
    /// Coordinates by their places that need not come back.
    pub drifting: Vec<usize>,
}

/// A periodic orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Parameters of the model.
    pub parameters: Vec<f64>,
    /// Coordinates and rates on the section.
    pub state: Vec<f64>,
    /// Time of a turn, s.
    pub period: f64,
    /// By how much each coordinate has changed after a turn; zero where it does not drift.
    pub shift: Vec<f64>,
    /// Multipliers, the largest first.
    pub multipliers: Vec<Complex<f64>>,
    /// By how much the state misses itself, in natural units.
    pub residual: f64,
    /// What happens in a turn, to which supports.
    pub events: Vec<(EventKind, Vec<&'static str>)>,
}

/// Multipliers as near to the unit circle as this are on it: the error of a turn splits a double
/// one by the root of itself.
const ON_CIRCLE: f64 = 1e-6;

/// What multipliers say of small deviations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrbitStability {
    /// They die out.
    Stable,
    /// None grows to first order, and one does not die out: a multiplier is on the unit circle.
    Neutral,
    /// One grows.
    Unstable,
}

impl Orbit {
    /// By the multiplier farthest out.
    pub fn stability(&self) -> OrbitStability {
        match self.multipliers.iter().map(|multiplier| multiplier.norm()).fold(0.0, f64::max) {
            outermost if outermost < 1.0 - ON_CIRCLE => OrbitStability::Stable,
            outermost if outermost <= 1.0 + ON_CIRCLE => OrbitStability::Neutral,
            _ => OrbitStability::Unstable,
        }
    }
}

/// The events of a turn in a line.
pub fn describe_events(events: &[(EventKind, Vec<&'static str>)]) -> String {
    let each =
        events.iter().map(|(kind, supports)| format!("{} {kind}", supports.join(", ")).trim().to_owned());
    each.collect::<Vec<_>>().join("; ")
}
