//! Variables between their bounds.

use super::OptimumError;
use crate::Variable;

/// A value that begins at a bound is moved inwards by this part of the range: at the bound the
/// slope of θ vanishes.
const INSIDE: f64 = 0.005;
/// A variable without bounds that has come so many times its unit, or its first value, goes on
/// without end.
const FAR: f64 = 1e4;
/// A variable is at a bound to which it is nearer than this part of its range and of its size.
const AT: f64 = 1e-6;

/// A variable, and the bounds that it may have.
#[derive(Debug, Clone, PartialEq)]
pub struct Free {
    /// The variable, with the value that the search begins with.
    pub variable: Variable,
    /// Its least and its greatest value; none if it may have any.
    pub bounds: Option<[f64; 2]>,
}

impl Free {
    /// θ where the search begins.
    pub(super) fn theta(&self) -> Result<f64, OptimumError> {
        let Some([low, high]) = self.bounds else { return Ok(0.0) };
        let Variable { name, value, .. } = &self.variable;
        if !(low..=high).contains(value) || low == high {
            return Err(OptimumError::Outside { name: name.clone(), value: *value, low, high });
        }
        let part = match (value - low) / (high - low) {
            0.0 => INSIDE,
            1.0 => 1.0 - INSIDE,
            part => part,
        };
        Ok((2.0 * part - 1.0).asin())
    }

    /// The value, and its derivative by θ.
    pub(super) fn value(&self, theta: f64) -> [f64; 2] {
        match self.bounds {
            None => [self.variable.value + self.variable.unit * theta, self.variable.unit],
            Some([low, high]) => {
                let half = 0.5 * (high - low);
                [(low + half * (1.0 + theta.sin())).clamp(low, high), half * theta.cos()]
            }
        }
    }

    pub(super) fn runs_away(&self, value: f64) -> bool {
        let Variable { value: first, unit, .. } = &self.variable;
        self.bounds.is_none() && (value - first).abs() > FAR * unit.max(first.abs())
    }

    pub(super) fn is_at_bound(&self, value: f64) -> bool {
        [-1.0, 1.0].into_iter().any(|side| self.is_at(side, value))
    }

    /// Whether it is at its lower bound, for a side of −1, or at its upper one.
    fn is_at(&self, side: f64, value: f64) -> bool {
        let Some([low, high]) = self.bounds else { return false };
        let away = if side < 0.0 { value - low } else { high - value };
        away < AT * (high - low).min(self.variable.unit.max(value.abs()))
    }

    /// Whether a bound keeps it from a better value, where what is to be least has this slope.
    pub(super) fn is_held(&self, value: f64, slope: f64) -> bool {
        slope != 0.0 && self.is_at(-slope.signum(), value)
    }
}
