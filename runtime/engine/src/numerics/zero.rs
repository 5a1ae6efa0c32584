//! What counts as zero. A comparison with zero speaks of one of five errors, and names it:
//!
//! | error | of | size |
//! |---|---|---|
//! | [roundoff of a sum](roundoff) | terms that were added, relative to the largest of them | n ε |
//! | [roundoff of a solution](SOLVED) | unknowns of equilibrated equations, relative to their right-hand side | 1e-12 |
//! | local error | one step | tol, or ε |
//! | [place of an event](compute_place_error) | the state in which a guard is at zero | 10 tol, or 64 ε |
//! | [margin of a decision](MARGIN) | a sign on which the rest of the motion depends | 1e-6 |
//! | [rank](RANK) | singular values, pivots and eigenvalues, relative to the largest | 1e-10 |
//!
//! Only the local error and the place of an event follow the tolerance. The other sizes are those
//! of double precision: rows depend on each other, and forces vanish, at any tolerance alike.
//! Everything is relative: to the terms themselves, or to the natural units of the model. Other
//! small numbers are those of a method, and stand with it; in the core these and multiples of ε are
//! all.

/// Roundoff of a sum of terms of size one that come from so many operations: n ε.
pub(crate) const fn roundoff(operations: f64) -> f64 {
    operations * f64::EPSILON
}

/// Roundoff of a solution of equilibrated equations, relative to their right-hand side: the unit
/// roundoff and a condition number of some thousands. Of a sum of such unknowns too.
pub(crate) const SOLVED: f64 = 1e-12;

/// A singular value, pivot or eigenvalue below this part of the largest is zero: directions are
/// known as well as states, which are typed in with ten digits.
pub(crate) const RANK: f64 = 1e-10;

/// A sign is clear above this part of what is natural: half of the digits are left.
pub(crate) const MARGIN: f64 = 1e-6;

/// Error of the place of an event, in natural units: the local errors of ten steps, or the
/// roundings of some.
pub(crate) const fn compute_place_error(tolerance: f64) -> f64 {
    (10.0 * tolerance).max(roundoff(64.0))
}
