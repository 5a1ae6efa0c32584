//! Variables between their bounds.

use super::OptimumError;
use crate::Variable;

/// A value that the search begins with comes no nearer to a bound than this part of the range: at the bound the slope of θ vanishes.
const INSIDE: f64 = 0.005;
/// A variable that is nearer to a bound than this part of its range is at it.
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
        let part = ((value - low) / (high - low)).clamp(INSIDE, 1.0 - INSIDE);
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

    pub(super) fn is_at_bound(&self, value: f64) -> bool {
        self.bounds.is_some_and(|[low, high]| (value - low).min(high - value) < AT * (high - low))
    }
}
