//! One turn from the section back to it: P(x, p) with its derivatives along the surface.

use liftoff::{EventKind, Trajectory};
use nalgebra::{DMatrix, DVector};

use super::surface::{OrbitParameters, Surface};
use super::{OrbitError, ReturnMap, Section};
use crate::SensitivityError;
use crate::sensitivity::{Direction, WIDTH, along};

/// A run this short, in natural times, has met the section where it started.
const AT_ONCE: f64 = 1e-6;
/// A motion in this time, in natural times, is far below what a state may miss itself by, and above
/// rounding.
const MOMENT: f64 = 1e-14;
/// Half the span of differences, in natural units: their error is its square.
const SPAN: f64 = 1e-5;
/// Such runs in a row.
const RESTARTS: usize = 3;

/// A turn, computed on numbers with derivatives.
pub(super) struct Turn {
    pub(super) run: Trajectory,
    /// P(x) in natural units.
    pub(super) end: DVector<f64>,
    /// ∂P/∂x T.
    pub(super) slopes: DMatrix<f64>,
    /// dP/dp on the surface.
    pub(super) by_parameter: DVector<f64>,
    pub(super) period: f64,
}

impl ReturnMap<'_> {
    /// A run from a state to the section.
    pub(super) fn follow(&self, parameters: &[f64], state: &[f64]) -> Result<Trajectory, OrbitError> {
        let mut state = state.to_vec();
        for _ in 0..=RESTARTS {
            let simulation = (self.simulate)(parameters, &state).map_err(OrbitError::Run)?;
            let run = self.section.end(simulation)?.run();
            let run = run.map_err(|error| OrbitError::Run(error.to_string()))?;
            if !self.section.has_ended(&run) {
                let last = run.events().last().map_or_else(String::new, ToString::to_string);
                return Err(OrbitError::NoReturn { section: self.section.to_string(), last });
            }
            if run.end_time() > AT_ONCE * run.scales().time {
                return Ok(run);
            }
            state = match self.section {
                Section::Event(_) => run.final_state(),
                Section::Condition(_) => self.beyond(parameters, &run)?,
            };
        }
        Err(OrbitError::NoStart { section: self.section.to_string() })
    }

    /// The state a moment after a condition was met: at exactly 0, `phi > 0` does not hold yet, and
    /// is met at once.
    fn beyond(&self, parameters: &[f64], run: &Trajectory) -> Result<Vec<f64>, OrbitError> {
        let simulation = (self.simulate)(parameters, &run.final_state()).map_err(OrbitError::Run)?;
        let run = simulation.limit(MOMENT * run.scales().time).run();
        Ok(run.map_err(|error| OrbitError::Run(error.to_string()))?.final_state())
    }

    /// A turn from a surface.
    pub(super) fn turn(&self, at: &OrbitParameters, surface: &Surface) -> Result<Turn, OrbitError> {
        let run = self.follow(&at.parameters, &surface.state)?;
        let natural = |column: &[f64]| column.iter().zip(&at.units).map(|(x, unit)| x * unit).collect();
        let columns = surface.basis.column_iter();
        let directions =
            columns.map(|column| Direction { start: natural(column.as_slice()), parameter: None, unit: 1.0 });
        let moves = surface.motion.iter().zip(&at.units).map(|(x, unit)| x * unit / at.unit).collect();
        let parameter = Direction { start: moves, parameter: at.varied, unit: at.unit };
        let directions: Vec<Direction> = directions.chain(at.varied.is_some().then_some(parameter)).collect();
        let replayed = along(&run, self.model, &directions)?;
        let first = replayed.first().ok_or(SensitivityError::NoVariable)?;
        let size = at.units.len();
        // Behind the last event: what follows in the run ends at a given time.
        let end = |chunk: usize| replayed[chunk].states.last().unwrap_or(&replayed[chunk].end);
        let slope = |i: usize, k: usize| end(k / WIDTH)[i].gradient()[k % WIDTH] / at.units[i];
        let free = surface.basis.ncols();
        let period = first.times.last().copied().flatten().map_or(run.end_time(), |t| t.value());
        Ok(Turn {
            end: DVector::from_fn(size, |i, _| end(0)[i].value() / at.units[i]),
            slopes: DMatrix::from_fn(size, free, slope),
            by_parameter: DVector::from_fn(size, |i, _| at.varied.map_or(0.0, |_| slope(i, free)))
                + self.by_period(at, &run),
            period: period - run.start_time(),
            run,
        })
    }
}

impl ReturnMap<'_> {
    /// ẋ dT/dp of a section at a time T(p), by differences.
    fn by_period(&self, at: &OrbitParameters, run: &Trajectory) -> DVector<f64> {
        let time = |by: f64| {
            let mut parameters = at.parameters.clone();
            at.varied.iter().for_each(|&i| parameters[i] += by * at.unit);
            self.section.time(&parameters)
        };
        let size = at.units.len();
        let (Some(later), Some(sooner), Some(_)) = (time(SPAN), time(-SPAN), at.varied) else {
            return DVector::zeros(size);
        };
        let h = SPAN * at.scales.time;
        let [now, before, first] = [0.0, 1.0, 2.0].map(|k| run.state(run.end_time() - k * h));
        let rate = |i: usize| (3.0 * now[i] - 4.0 * before[i] + first[i]) / (2.0 * h * at.units[i]);
        DVector::from_fn(size, |i, _| rate(i) * (later - sooner) / (2.0 * SPAN))
    }
}

/// What happens in a turn, and to which supports: orbits of one branch have the same.
pub(super) fn sequence(run: &Trajectory) -> Vec<(EventKind, Vec<&'static str>)> {
    let events = run.events().iter().skip(1).filter(|event| event.kind != EventKind::Touch);
    events.map(|event| (event.kind, event.supports.clone())).collect()
}
