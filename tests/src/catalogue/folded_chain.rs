//! Entry 14: a chain folded tight falls, one end held, energy conserved: with x the fall of the
//! free end as part of the whole length, ẋ² = g/L x(2 − x)/(1 − x) in the one-dimensional limit.

use crate::numerics::integral;
use std::f64::consts::FRAC_PI_2;

/// Time of the whole fall in √(2L/g), 0.84721308: x = sin² u makes ∫ √((1 − x)/(x(2 − x))) dx
/// smooth.
pub fn fall_time() -> f64 {
    let slow = |u: f64| 2.0 * u.cos().powi(2) / (2.0 - u.sin().powi(2)).sqrt();
    integral(slow, 0.0, FRAC_PI_2) / 2.0_f64.sqrt()
}
