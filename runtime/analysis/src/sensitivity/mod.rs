//! Derivatives of a run with respect to parameters and its start, through its events:
//!
//! ```text
//! δτ = −(∂g/∂y δy⁻ + ∂g/∂p δp) / ġ                        the time of an event, whose guard is g
//! δy⁺ = ∂R/∂y (δy⁻ + f⁻ δτ) + ∂R/∂p δp − f⁺ δτ            the state at a fixed time behind it, y⁺ = R(y⁻, p)
//! ```
//!
//! (the saltation of Leine and Nijmeijer, *Dynamics and Bifurcations of Non-Smooth Mechanical Systems*, 2004, 7.3). The run is
//! computed once more on dual numbers, times of events among them, so that both follow from arithmetic; four variables at once.
//! How the start depends on them is found by differences, since it is solved to rounding.

mod start;

use liftoff::Trajectory;
use liftoff::scalar::Dual4;
use liftoff::system::ModelOn;
use liftoff_replay::{Replayed, replay};

use crate::SensitivityError;
pub use start::Variable;

/// Error per step of the computation.
const TOLERANCE: f64 = 1e-12;
/// Variables of one computation.
const WIDTH: usize = 4;

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
    /// Of a run; `model` makes the model's equations on dual numbers, for a compiled model by [`varied`](liftoff::system::varied);
    /// `start` gives the full state that a run starts in with another value of a variable.
    ///
    /// # Errors
    /// The run cannot be computed once more; its start cannot be varied; it has events without derivatives, that graze, come
    /// apart or are infinitely many.
    pub fn of(
        run: &Trajectory,
        model: impl Fn(&[Dual4]) -> Result<ModelOn<Dual4>, String>,
        variables: &[Variable],
        start: impl Fn(&Variable, f64) -> Result<Vec<f64>, String>,
    ) -> Result<Self, SensitivityError> {
        let slopes = variables.iter().map(|variable| variable.slopes(run, &start));
        let slopes: Vec<Vec<f64>> = slopes.collect::<Result<_, _>>()?;
        let mut all: Option<Self> = None;
        for (four, slopes) in variables.chunks(WIDTH).zip(slopes.chunks(WIDTH)) {
            let start = initial(run, four, slopes);
            let model = model(&parameters(run, four)).map_err(SensitivityError::Model)?;
            let replayed = replay(run, model, &start, TOLERANCE)?;
            let found = Self::read(&replayed, four);
            match &mut all {
                Some(all) => all.append(found),
                None => all = Some(found),
            }
        }
        all.ok_or(SensitivityError::NoVariable)
    }

    fn read(replayed: &Replayed<Dual4>, variables: &[Variable]) -> Self {
        let row = |x: &Dual4| x.gradient().iter().zip(variables).map(|(x, of)| x / of.unit).collect();
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

/// Values of the parameters, with derivatives with respect to variables in their units.
fn parameters(run: &Trajectory, variables: &[Variable]) -> Vec<Dual4> {
    let own = |i: usize| move |of: &Variable| if of.parameter == Some(i) { 1.0 } else { 0.0 };
    let values = run.parameters().iter().enumerate();
    values.map(|(i, &value)| Dual4::new(value, gradient(variables, own(i)))).collect()
}

/// The start with its derivatives.
fn initial(run: &Trajectory, variables: &[Variable], slopes: &[Vec<f64>]) -> Vec<Dual4> {
    let state = run.events().first().map_or(&[][..], |start| &start.state);
    let entry =
        |i: usize| core::array::from_fn(|k| slopes.get(k).map_or(0.0, |of| of[i] * variables[k].unit));
    state.iter().enumerate().map(|(i, &x)| Dual4::new(x, entry(i))).collect()
}

fn gradient(variables: &[Variable], slope: impl Fn(&Variable) -> f64) -> [f64; WIDTH] {
    core::array::from_fn(|k| variables.get(k).map_or(0.0, |variable| slope(variable) * variable.unit))
}
