//! Methods of numerical analysis, on numbers alone.
//!
//! - `least_squares`: sums of squares by Levenberg and Marquardt's method; `quasi_newton`: a
//!   function with its gradient by L-BFGS, on lines by `line_search`; `linear_program`: a linear
//!   function between linear bounds; `student`: quantiles of Student's distribution.

pub(crate) mod least_squares;
mod line_search;
pub(crate) mod linear_program;
pub(crate) mod quasi_newton;
pub(crate) mod student;
