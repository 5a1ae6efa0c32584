//! How a start depends on a variable, by differences of the sixth order (Fornberg, Mathematics of Computation 51, 1988):
//!
//! ```text
//! 60 h x′ = 45 (x₁ − x₋₁) − 9 (x₂ − x₋₂) + (x₃ − x₋₃)
//! 60 h x′ = −147 x₀ + 360 x₁ − 450 x₂ + 400 x₃ − 225 x₄ + 72 x₅ − 10 x₆     where there is nothing on one side
//! ```

use liftoff::Trajectory;

use super::Direction;
use crate::SensitivityError;

/// A step, in units of the variable: its sixth power is rounding.
const STEP: f64 = 1e-3;
const CENTRAL: [(f64, f64); 6] =
    [(-3.0, -1.0), (-2.0, 9.0), (-1.0, -45.0), (1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
const ONE_SIDED: [(f64, f64); 7] =
    [(0.0, -147.0), (1.0, 360.0), (2.0, -450.0), (3.0, 400.0), (4.0, -225.0), (5.0, 72.0), (6.0, -10.0)];

/// What a run is differentiated with respect to.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// As users write it: `m`, `phi`, `phi'`.
    pub name: String,
    /// Its place among the parameters, if it is one.
    pub parameter: Option<usize>,
    /// Its value in the run.
    pub value: f64,
    /// What it varies on: of a parameter its value, of a coordinate its natural unit.
    pub unit: f64,
}

impl Variable {
    /// That of the starts of runs.
    pub(crate) fn direction(
        &self,
        run: &Trajectory,
        start: &impl Fn(&Self, f64) -> Result<Vec<f64>, String>,
    ) -> Result<Direction, SensitivityError> {
        let n = run.events().first().map_or(0, |start| start.state.len());
        let h = STEP * self.unit;
        let difference = |weights: &[(f64, f64)], h: f64| -> Result<Vec<f64>, String> {
            let mut slopes = vec![0.0; n];
            for (k, weight) in weights {
                let state = start(self, self.value + k * h)?;
                slopes.iter_mut().zip(state).for_each(|(slope, x)| *slope += weight * x / (60.0 * h));
            }
            Ok(slopes)
        };
        let either = difference(&CENTRAL, h).or_else(|_| difference(&ONE_SIDED, h));
        let found = either.or_else(|_| difference(&ONE_SIDED, -h));
        let slopes = found.map_err(|why| SensitivityError::Start { variable: self.name.clone(), why })?;
        Ok(Direction { start: slopes, parameter: self.parameter, unit: self.unit })
    }
}
