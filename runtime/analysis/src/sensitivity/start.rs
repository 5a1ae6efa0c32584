//! What a run is differentiated with respect to, and how its start depends on that.

use liftoff::Trajectory;

use super::Direction;
use super::differences::Differences;
use crate::SensitivityError;

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
        let differences = Differences {
            of: |by: f64| start(self, self.value + by),
            state: run.events().first().map_or(&[][..], |event| &event.state),
            units: run.scales().state(run.layout()),
            unit: self.unit,
        };
        let refused = |why| SensitivityError::Start { variable: self.name.clone(), why };
        let slopes = differences.slopes().map_err(refused)?;
        Ok(Direction { start: slopes, parameter: self.parameter, unit: self.unit })
    }
}
