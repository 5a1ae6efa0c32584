//! Series as numbers, where a decision needs one: signs, sides and branches of the nominal figure.
//!
//! The parameters of a model are not known yet, so a decision is taken at several samples of them.

use super::{Definition, System};
use crate::algebra::{Series, Symbol};

/// Values of all parameters and derived constants.
#[derive(Clone, Debug)]
pub struct ParameterValues(Vec<f64>);

impl ParameterValues {
    /// Derived constants after the given parameters.
    pub fn new(parameters: &[f64], constants: &[Definition]) -> Self {
        let mut numbers = Self(parameters.to_vec());
        for constant in constants {
            let value = match constant {
                Definition::Sqrt(a) => numbers.evaluate(a).sqrt(),
                Definition::Ratio(a, b) => numbers.evaluate(a) / numbers.evaluate(b),
            };
            numbers.0.push(value);
        }
        numbers
    }

    /// The same parameters with constants that were derived since.
    pub(super) fn with(&self, parameters: usize, constants: &[Definition]) -> Self {
        Self::new(&self.0[..parameters], constants)
    }

    /// Whether every derived constant is a number: no root of a negative number, no division by
    /// zero.
    pub(super) fn are_finite(&self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }

    /// Of a series of parameters; NaN if it contains anything else.
    pub fn evaluate(&self, series: &Series) -> f64 {
        series.evaluate(&|symbol| match symbol {
            Symbol::Parameter(i) => self.0.get(usize::from(i)).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        })
    }

    /// Of a position.
    pub fn pair(&self, position: &[Series; 2]) -> [f64; 2] {
        [self.evaluate(&position[0]), self.evaluate(&position[1])]
    }
}

impl System {
    /// The value of a series at the first sample: with every parameter 1 where the figure can be
    /// drawn there.
    pub fn nominal_number(&self, series: &Series) -> f64 {
        self.samples.first().map_or(f64::NAN, |numbers| numbers.evaluate(series))
    }

    /// The value of a series of parameters.
    pub fn parameter_value(&self, series: &Series, values: &[f64]) -> f64 {
        ParameterValues::new(values, &self.constants).evaluate(series)
    }
}
