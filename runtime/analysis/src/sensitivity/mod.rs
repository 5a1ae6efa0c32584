//! Derivatives of a run with respect to parameters and its start, through its events:
//!
//! ```text
//! δτ = −(∂g/∂y δy⁻ + ∂g/∂p δp) / ġ                        the time of an event, whose guard is g
//! δy⁺ = ∂R/∂y (δy⁻ + f⁻ δτ) + ∂R/∂p δp − f⁺ δτ            the state at a fixed time behind it, y⁺ = R(y⁻, p)
//! ```
//!
//! (the saltation of Leine and Nijmeijer, *Dynamics and Bifurcations of Non-Smooth Mechanical
//! Systems*, 2004, 7.3). The run is computed once more on dual numbers, times of events among them,
//! so that both follow from arithmetic; four directions at once. How the start depends on them is
//! found by differences, since it is solved to rounding.

mod differences;
mod direction;
mod start;

use liftoff::Trajectory;
use liftoff_core::scalar::Dual4;
use liftoff_core::system::ModelOn;
use liftoff_replay::{Reading, ReplayError, Replayed, replay, replay_outputs};

use crate::SensitivityError;
pub(crate) use direction::{Direction, WIDTH, moved, parameters};
pub use start::Variable;

/// Error per step of the computation, of the tolerance of the run.
const TIGHTER: f64 = 0.1;
/// Rounding allows no less.
const LEAST: f64 = 1e-13;

fn error_per_step(run: &Trajectory) -> f64 {
    (TIGHTER * run.tolerance()).max(LEAST)
}

/// Derivatives of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivities {
    /// Of the time of each event of the run, and the coordinates and rates behind it.
    pub events: Vec<Derivatives>,
    /// Of coordinates and rates at the end.
    pub end: Vec<Vec<f64>>,
}

/// Derivatives at an event, one entry for each variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Derivatives {
    /// Of its time; none of what only touches.
    pub time: Option<Vec<f64>>,
    /// Of each coordinate, then of each rate.
    pub state: Vec<Vec<f64>>,
}

impl Sensitivities {
    /// Of a run; `model` makes the model's equations on dual numbers, for a compiled model by
    /// [`varied`](liftoff_core::system::varied); `start` gives the full state that a run starts in
    /// with another value of a variable.
    ///
    /// # Errors
    /// The run cannot be computed once more; its start cannot be varied; it has events without
    /// derivatives, that graze, come apart or are infinitely many.
    pub fn compute(
        run: &Trajectory,
        model: impl Fn(&[Dual4]) -> Result<ModelOn<Dual4>, String>,
        variables: &[Variable],
        start: impl Fn(&Variable, f64) -> Result<Vec<f64>, String>,
    ) -> Result<Self, SensitivityError> {
        let directions = variables.iter().map(|variable| variable.direction(run, &start));
        let directions: Vec<Direction> = directions.collect::<Result<_, _>>()?;
        let replayed = along(run, &model, &directions)?;
        let mut all: Option<Self> = None;
        for (replayed, four) in replayed.iter().zip(directions.chunks(WIDTH)) {
            let found = Self::from_replay(replayed, four);
            match &mut all {
                Some(all) => all.append(found),
                None => all = Some(found),
            }
        }
        all.ok_or(SensitivityError::NoVariable)
    }

    fn from_replay(replayed: &Replayed<Dual4>, directions: &[Direction]) -> Self {
        let row = |x: &Dual4| x.gradient().iter().zip(directions).map(|(x, of)| x / of.unit).collect();
        let rows = |state: &Vec<Dual4>| state.iter().map(row).collect();
        let events = replayed.times.iter().zip(&replayed.states);
        let events = events.map(|(t, state)| Derivatives { time: t.as_ref().map(row), state: rows(state) });
        Self { events: events.collect(), end: rows(&replayed.end) }
    }

    /// Adds those with respect to further variables.
    fn append(&mut self, other: Self) {
        let widen = |rows: &mut Vec<Vec<f64>>, others: Vec<Vec<f64>>| {
            rows.iter_mut().zip(others).for_each(|(row, other)| row.extend(other));
        };
        widen(&mut self.end, other.end);
        for (event, other) in self.events.iter_mut().zip(other.events) {
            widen(&mut event.state, other.state);
            event.time = event.time.take().zip(other.time).map(|(time, other)| [time, other].concat());
        }
    }
}

/// The equations on values with derivatives, given those of the parameters; or why there are none.
pub type Differentiated<'a> = dyn Fn(&[Dual4]) -> Result<ModelOn<Dual4>, String> + 'a;

/// A run once more, with derivatives along four directions at a time.
pub(crate) fn along(
    run: &Trajectory,
    model: &Differentiated<'_>,
    directions: &[Direction],
) -> Result<Vec<Replayed<Dual4>>, SensitivityError> {
    by_fours(run, model, directions, |model, start| replay(run, model, start, error_per_step(run), &[]))
}

/// What is read of a run, with derivatives along four directions at a time.
pub(crate) fn read_along(
    run: &Trajectory,
    model: &Differentiated<'_>,
    directions: &[Direction],
    readings: &[Reading<'_>],
) -> Result<Vec<Vec<Dual4>>, SensitivityError> {
    by_fours(run, model, directions, |model, start| {
        replay_outputs(run, model, start, error_per_step(run), readings)
    })
}

fn by_fours<T>(
    run: &Trajectory,
    model: &Differentiated<'_>,
    directions: &[Direction],
    once_more: impl Fn(ModelOn<Dual4>, &[Dual4]) -> Result<T, ReplayError>,
) -> Result<Vec<T>, SensitivityError> {
    let start = run.events().first().map_or(&[][..], |start| &start.state);
    let each = directions.chunks(WIDTH).map(|four| {
        let model = model(&parameters(run.parameters(), four)).map_err(SensitivityError::Model)?;
        Ok(once_more(model, &moved(start, four))?)
    });
    each.collect()
}
