//! Observed orders of one step along Kepler's orbit from t = 3.

use super::fields::{distance, orbit};
use crate::integrate::Dense;

/// The order of an error between steps of 2h and h.
pub(in crate::integrate) fn order(error: impl Fn(f64) -> f64, h: f64) -> f64 {
    (error(2.0 * h) / error(h)).log2()
}

/// The largest of what θ = 1/16, …, 15/16 give.
pub(in crate::integrate) fn largest(of: impl Fn(f64) -> f64) -> f64 {
    (1..16).map(|i| of(f64::from(i) / 16.0)).fold(0.0, f64::max)
}

/// The orders of the end and of the dense output of the step that `single` makes of a length.
pub(in crate::integrate) fn step_orders(single: impl Fn(f64) -> Dense<f64, 4>, h: f64) -> [f64; 2] {
    let end = |h: f64| distance(*single(h).end(), orbit(3.0 + h));
    let inside = |h: f64| {
        let step = single(h);
        largest(|theta| distance(step.interpolate(theta), orbit(3.0 + theta * h)))
    };
    [order(end, h), order(inside, h)]
}
