//! One run with given values of the variables, compared with the data.

use liftoff::{EventKind, Simulation, Trajectory};
use liftoff_replay::Moment;
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

use super::{Datum, Fit, Place};
use crate::sensitivity::{Direction, WIDTH, read_along};
use crate::{SensitivityError, Variable};
use liftoff::__private::event::Occurrence;

/// A residual is smaller than this, so that its square is a number.
const FAR: f64 = 1e100;

/// Why a run cannot be compared with the data.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TrialError {
    /// It cannot be computed.
    #[error("{0}")]
    Run(String),
    /// It ends too soon.
    #[error("the run has no {what}: it ends with `{last}`")]
    Short {
        /// What is measured later.
        what: String,
        /// Its last event.
        last: String,
    },
    /// Something that was measured does not happen.
    #[error("there is no {event} in the run: it ends with `{last}`")]
    NoEvent {
        /// What.
        event: String,
        /// Its last event.
        last: String,
    },
    /// Too far from a measured value for a sum of squares.
    #[error("{what} is {computed:e}, too far from the measured value for a sum of squares")]
    TooFar {
        /// What is measured.
        what: String,
        /// Its value in the run.
        computed: f64,
    },
    /// Something that was measured has no value.
    #[error("{what} is not finite")]
    NotFinite {
        /// What.
        what: String,
    },
    /// It has no derivatives.
    #[error(transparent)]
    Sensitivity(#[from] SensitivityError),
}

/// A run with its residuals.
pub(crate) struct Trial {
    pub(super) values: Vec<f64>,
    run: Trajectory,
    moments: Vec<Moment>,
    /// yᵢ.
    pub(super) computed: Vec<f64>,
    /// rᵢ.
    pub(crate) residuals: DVector<f64>,
}

impl Fit<'_> {
    /// The run with these values.
    pub(crate) fn trial(&self, values: &[f64]) -> Result<Trial, TrialError> {
        let simulation = (self.simulate)(values).map_err(TrialError::Run)?;
        let run = self.as_far_as_needed(simulation)?.run();
        let run = run.map_err(|error| TrialError::Run(error.to_string()))?;
        let moments: Vec<Moment> =
            self.data.iter().map(|datum| datum.moment(&run)).collect::<Result<_, _>>()?;
        let computed = self.data.iter().zip(&moments).map(|(datum, &at)| datum.computed(&run, at));
        let computed: Vec<f64> = computed.collect::<Result<_, _>>()?;
        let residual = |(datum, y): (&Datum, &f64)| (y - datum.value) / datum.deviation;
        let residuals = DVector::from_iterator(computed.len(), self.data.iter().zip(&computed).map(residual));
        if let Some(i) = residuals.iter().position(|residual| residual.abs() >= FAR) {
            return Err(TrialError::TooFar { what: self.data[i].to_string(), computed: computed[i] });
        }
        Ok(Trial { values: values.to_vec(), run, moments, computed, residuals })
    }

    /// Up to the last time of a series, or the last of first events.
    fn as_far_as_needed(&self, mut simulation: Simulation) -> Result<Simulation, TrialError> {
        let times: Option<Vec<f64>> = self.data.iter().map(|datum| datum.place.time()).collect();
        if let Some(last) = times.and_then(|times| times.into_iter().reduce(f64::max)) {
            let limit = simulation.time_limit().min(last);
            return Ok(if last > 0.0 { simulation.limit(limit) } else { simulation });
        }
        let first = |datum: &Datum| match datum.place {
            Place::Event(Occurrence::Nth(1), filter) => Some(filter),
            _ => None,
        };
        let filters: Option<Vec<_>> = self.data.iter().map(first).collect();
        for filter in filters.into_iter().flatten().filter(|filter| filter.kind != EventKind::Start) {
            let ended = simulation.until_event(filter.kind, filter.support);
            simulation = ended.map_err(|error| TrialError::Run(error.to_string()))?;
        }
        Ok(simulation)
    }

    /// ∂r/∂p, for the events of this run.
    pub(crate) fn jacobian(&self, trial: &Trial) -> Result<DMatrix<f64>, SensitivityError> {
        let start = |variable: &Variable, value: f64| {
            let mut values = trial.values.clone();
            let place = self.variables.iter().position(|known| known.name == variable.name);
            place.into_iter().for_each(|k| values[k] = value);
            (self.simulate)(&values)?.start_state().map_err(|error| error.to_string())
        };
        let direction = |(variable, &value): (&Variable, &f64)| {
            Variable { value, ..variable.clone() }.direction(&trial.run, &start)
        };
        let directions = self.variables.iter().zip(&trial.values).map(direction);
        let directions: Vec<Direction> = directions.collect::<Result<_, _>>()?;
        let readings = self.data.iter().zip(&trial.moments).map(|(datum, &moment)| datum.reading(moment));
        let readings: Vec<_> = readings.collect();
        let read = read_along(&trial.run, self.model, &directions, &readings)?;
        let slope = |i: usize, k: usize| {
            let slope: f64 = read[k / WIDTH][i].gradient()[k % WIDTH];
            slope / directions[k].unit / self.data[i].deviation
        };
        Ok(DMatrix::from_fn(self.data.len(), self.variables.len(), slope))
    }
}
