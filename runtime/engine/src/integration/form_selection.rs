//! Where a closed form can be trusted. A coordinate is eliminated by 1/p with p its pivot relative
//! to its natural size, its second derivative by 1/p³: rounding ε/p³ must stay below the tolerance.

use crate::model::Form;
use crate::numerics::zero::roundoff;
use crate::system::PhaseEquations;

/// Least pivot at any tolerance: below it the elimination is nearly singular.
const SINGULAR: f64 = 1e-3;
/// Above this pivot the closed form is kept at any tolerance.
const REGULAR: f64 = 0.3;

/// Whether a phase is in closed form and has pivots: not one that keeps all entries of the state.
pub(crate) fn eliminates(phase: &dyn PhaseEquations) -> bool {
    phase.info().form == Form::Reduced && phase.kept().len() < phase.system().layout().entries()
}

/// The least pivot for a tolerance.
pub(crate) fn least_pivot(tolerance: f64) -> f64 {
    (roundoff(27.0) / tolerance).cbrt().clamp(SINGULAR, REGULAR)
}
