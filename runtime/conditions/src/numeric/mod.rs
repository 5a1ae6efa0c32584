//! Zeros for given parameters, certain and to the last digit.
//!
//! - [`values`]: exact numbers for variables; [`chart`]: a circle by two polynomials; [`roots`]:
//!   real roots by signs of integers.
//! - [`zeros`]: those of all reactions on an energy level; `way`: which comes first.

pub(crate) mod chart;
pub(crate) mod roots;
pub(crate) mod values;
mod way;
pub(crate) mod zeros;
