//! Error against run time: a simulation measured with every method and tolerance asked for.
//!
//! Errors are those of the states, at the end and over the run, and of the times of events against
//! a [`Reference`], which no method measured has a part in. Run times are those of whole runs,
//! start and decisions at contacts included, that record nothing but their events; what is built
//! once for a simulation is not in them.

mod clock;
mod spec;

pub use spec::{PrecisionSpec, PrecisionSpecError, check_tolerance};

use core::ops::ControlFlow;
use core::time::Duration;
use liftoff_replay::ReplayError;
use std::sync::Arc;

pub use clock::ROUNDS;
use clock::Times;
use thiserror::Error;

use crate::judgement::{Verdict, judge};
use crate::reference::{Reference, ReferenceError, Source};
use liftoff::RunError;
use liftoff::Simulation;
use liftoff::Statistics;
use liftoff::Trajectory;
use liftoff::method::Method;
use liftoff::{Event, EventKind};
use liftoff_core::scalar::DoubleDouble;
use liftoff_core::system::System;

/// Tolerance of the run that a reference follows, and where that run fails the one to try next.
const FINEST: [f64; 3] = [1e-13, 1e-11, 1e-9];
/// Time spent on the runs of one method at one tolerance, unless said otherwise.
const MEASURING: Duration = Duration::from_millis(20);

/// Why there is nothing to compare with.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PrecisionError {
    /// The run that the reference is to follow stopped short.
    #[error("{0}")]
    Run(String),
    /// The judge finds another motion.
    #[error("no reference: the judge disagrees")]
    Disagreement,
    /// It has no reference.
    #[error("no reference: {0}")]
    Reference(#[from] ReferenceError),
}

/// A simulation with its reference.
pub struct Precision {
    simulation: Simulation,
    truth: Result<Reference, PrecisionError>,
    verdict: Verdict,
    measuring: Duration,
}

/// Runs that are timed.
struct Timed {
    method: &'static str,
    tolerance: f64,
    simulation: Simulation,
    times: Times,
    last: Option<Result<Trajectory, RunError>>,
}

impl Timed {
    /// A method at each tolerance.
    fn of_method(simulation: &Simulation, method: impl Method, tolerances: &[f64]) -> Vec<Self> {
        let name = method.name();
        let simulation = simulation.clone().method(method);
        let one = |&tolerance: &f64| Self {
            method: name,
            tolerance,
            simulation: simulation.clone().tolerance(tolerance),
            times: Times::default(),
            last: None,
        };
        tolerances.iter().map(one).collect()
    }
}

/// One method at one tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// Name of the method.
    pub method: &'static str,
    /// Relative tolerance of the run.
    pub tolerance: f64,
    /// Error of the final state, see [`Reference::state_error`]; none where there is nothing to
    /// compare.
    pub state_error: Option<f64>,
    /// The largest over the run, see [`Reference::run_error`].
    pub run_error: Option<f64>,
    /// Largest error of an event's time, see [`Reference::time_error`].
    pub event_error: Option<f64>,
    /// Steps and evaluations.
    pub statistics: Statistics,
    /// Median time of a run, s.
    pub median: f64,
    /// Least time of a run, s.
    pub least: f64,
    /// Why there are no errors: the run stopped short, found other events, or has no reference.
    pub reason: Option<String>,
    /// Who computed what it is compared with; none if there is nothing.
    pub source: Option<Source>,
    /// What an independent judge finds of the run whose events the reference has.
    pub verdict: Verdict,
}

impl Precision {
    /// Makes the reference, with the simulation's own method for the order of events. Where that
    /// cannot be made the measurements have times but no errors. `system` makes the model's
    /// equations in double-double, see [`Reference::compute`].
    pub fn new(simulation: Simulation, system: impl Fn(&[f64]) -> Arc<dyn System<DoubleDouble>>) -> Self {
        let verdict = Verdict::NotJudged { why: "there is no motion".to_owned() };
        let truth = Err(ReferenceError::from(ReplayError::Empty).into());
        let mut precision = Self { simulation, truth, verdict, measuring: MEASURING };
        for tolerance in FINEST {
            precision.simulation = precision.simulation.tolerance(tolerance);
            match precision.simulation.run() {
                Ok(run) => {
                    precision.verdict = judge(&run, &precision.simulation.held());
                    let held = precision.simulation.held();
                    precision.truth = match &precision.verdict {
                        Verdict::Disagrees { .. } => Err(PrecisionError::Disagreement),
                        _ => Reference::compute(&run, &held, &system).map_err(PrecisionError::Reference),
                    };
                    break;
                }
                Err(error) => precision.truth = Err(stopped(&error)),
            }
        }
        precision
    }

    /// With a closed form of the state for a reference, see [`Reference::closed_form`].
    ///
    /// # Errors
    /// The simulation stops short, or has events on the way.
    pub fn against(
        simulation: Simulation,
        state: impl Fn(f64) -> Vec<DoubleDouble>,
    ) -> Result<Self, PrecisionError> {
        let run = simulation.run().map_err(|error| stopped(&error))?;
        let truth = Ok(Reference::closed_form(&run, state)?);
        let verdict = Verdict::NotJudged { why: "a closed form is known".to_owned() };
        Ok(Self { simulation, truth, verdict, measuring: MEASURING })
    }

    /// What an independent judge finds of the run whose events the reference has.
    pub fn verdict(&self) -> &Verdict {
        &self.verdict
    }

    /// Spends so much time on the runs of one method at one tolerance, if they take less than that.
    #[must_use]
    pub fn measuring(mut self, time: Duration) -> Self {
        self.measuring = time;
        self
    }

    /// The reference, or why there is none.
    pub fn reference(&self) -> Result<&Reference, &PrecisionError> {
        self.truth.as_ref()
    }

    /// Measures a method at each tolerance.
    pub fn measure(&self, method: impl Method, tolerances: &[f64]) -> Vec<Measurement> {
        let all = Timed::of_method(&self.simulation, method, tolerances);
        self.time(all, &mut || ControlFlow::Continue(()))
    }

    /// Measures every method at every tolerance, until `go_on` breaks; that is asked before each in
    /// each of the [`ROUNDS`].
    pub fn measure_all(
        &self,
        spec: &PrecisionSpec,
        go_on: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Vec<Measurement> {
        let by = |&method| Timed::of_method(&self.simulation, method, &spec.tolerances);
        self.time(spec.methods.iter().flat_map(by).collect(), go_on)
    }

    fn time(&self, mut all: Vec<Timed>, go_on: &mut dyn FnMut() -> ControlFlow<()>) -> Vec<Measurement> {
        'rounds: for _ in 0..ROUNDS {
            for timed in &mut all {
                if go_on().is_break() {
                    break 'rounds;
                }
                let Timed { simulation, times, last, .. } = timed;
                times.add_round(self.measuring, || *last = Some(simulation.observe(&mut ())));
            }
        }
        all.into_iter().filter(|timed| !timed.times.is_empty()).map(|timed| self.row(timed)).collect()
    }

    fn row(&self, Timed { method, tolerance, simulation, times, last }: Timed) -> Measurement {
        let [median, least] = times.summarize();
        let run = last.transpose().map_err(|error| (stopped(&error).to_string(), error.into_trajectory()));
        let (trajectory, errors) = match run {
            Ok(Some(run)) => {
                let errors = self.errors(&simulation, &run);
                (Some(run), errors)
            }
            Ok(None) => (None, Err(ReplayError::Empty.to_string())),
            Err((reason, run)) => (Some(run), Err(reason)),
        };
        let (errors, reason) =
            errors.map_or_else(|reason| (None, Some(reason)), |errors| (Some(errors), None));
        Measurement {
            method,
            tolerance,
            state_error: errors.map(|[state, ..]| state),
            run_error: errors.map(|[_, run, _]| run),
            event_error: errors.map(|[.., event]| event),
            statistics: trajectory.map(|run| run.statistics()).unwrap_or_default(),
            median,
            least,
            reason,
            source: self.reference().ok().map(|reference| reference.source().clone()),
            verdict: self.verdict.clone(),
        }
    }

    /// Of the final state, over the run, which is recorded for it, and of the events' times.
    fn errors(&self, simulation: &Simulation, run: &Trajectory) -> Result<[f64; 3], String> {
        let truth = self.truth.as_ref().map_err(ToString::to_string)?;
        let others = || format!("other events: {}", describe_events(run.events()));
        let late = truth.lateness(run.events().iter()).ok_or_else(others)?;
        let recorded = simulation.run().map_err(|error| stopped(&error).to_string())?;
        let over = truth.run_error(&recorded).ok_or_else(others)?;
        Ok([truth.state_error(&run.final_state()), over, late])
    }
}

/// Events in a line; what only touches zero does not count.
fn describe_events(events: &[Event]) -> String {
    let one = |event: &Event| match event.supports.len() {
        0 => event.kind.to_string(),
        _ => format!("{} {}", event.supports.join(" "), event.kind),
    };
    let counts = events.iter().filter(|event| event.kind != EventKind::Touch);
    counts.map(one).collect::<Vec<_>>().join(", ")
}

fn stopped(error: &RunError) -> PrecisionError {
    PrecisionError::Run(error.cause().to_string())
}
