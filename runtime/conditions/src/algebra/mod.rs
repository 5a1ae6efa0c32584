//! Rational functions in sines, cosines, coordinates and parameters, with exact integers of any
//! size.
//!
//! - [`polynomial`]: integer polynomials, greatest common divisors, resultants; [`ring`]: series as
//!   such polynomials.
//! - [`form`]: quotients in factors; [`unknown`]: conditions as polynomials in one unknown;
//!   [`critical`]: parameters at which they change.

pub(crate) mod critical;
pub(crate) mod form;
pub(crate) mod polynomial;
pub(crate) mod ring;
pub(crate) mod unknown;
