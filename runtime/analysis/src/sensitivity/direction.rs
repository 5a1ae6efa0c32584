//! Directions in which starts and parameters are varied, four on one dual number.

use liftoff_core::scalar::Dual4;

/// Directions on one number.
pub(crate) const WIDTH: usize = 4;

/// A direction s of starts, and of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Direction {
    /// ∂y/∂s of coordinates and rates.
    pub(crate) start: Vec<f64>,
    /// The parameter that s is, if it is one.
    pub(crate) parameter: Option<usize>,
    /// What s varies on.
    pub(crate) unit: f64,
}

/// Values of parameters with their derivatives by s in its unit.
pub(crate) fn parameters(values: &[f64], directions: &[Direction]) -> Vec<Dual4> {
    let slope = |i: usize| move |of: &Direction| if of.parameter == Some(i) { 1.0 } else { 0.0 };
    values.iter().enumerate().map(|(i, &value)| Dual4::new(value, gradient(directions, slope(i)))).collect()
}

/// A state with its derivatives by s in its unit.
pub(crate) fn moved(state: &[f64], directions: &[Direction]) -> Vec<Dual4> {
    let entry = |(i, &x): (usize, &f64)| Dual4::new(x, gradient(directions, |of| of.start[i]));
    state.iter().enumerate().map(entry).collect()
}

fn gradient(directions: &[Direction], slope: impl Fn(&Direction) -> f64) -> [f64; WIDTH] {
    core::array::from_fn(|k| directions.get(k).map_or(0.0, |direction| slope(direction) * direction.unit))
}
