//! Error against run time as a table: rows of our methods and, beside them, of other tools.

mod chart;
mod file;

pub use chart::{charts, figure, figure_so_wide};
pub use file::{FileError, peers, written};

use crate::registry::{Entry, MotionError, PrecisionSpec};
use crate::run_spec::RunSpec;
use liftoff_verification::Measurement;
use serde::Serialize;

/// A median over the least time above which the machine did something else too.
const DISTURBED: f64 = 1.3;
/// What the star behind a time says.
pub const DISTURBED_NOTE: &str =
    "* The median is more than 1.3 times the least: the machine was busy with something else.";

/// One method at one tolerance on one system.
#[derive(Serialize, Clone, PartialEq, Debug)]
pub struct WorkPrecisionRow {
    /// Name of the model or scene.
    pub model: String,
    /// The method, or a tool that is not ours.
    pub method: String,
    /// Relative tolerance of the run.
    pub tolerance: f64,
    /// Error of the final state; none where there is nothing to compare.
    pub state_error: Option<f64>,
    /// Largest error of a state over the run, in the middles of 32 equal parts and at its end.
    pub run_error: Option<f64>,
    /// Largest error of an event's time.
    pub event_error: Option<f64>,
    /// Evaluations of the right-hand side; none where a tool does not tell.
    pub evaluations: Option<u64>,
    /// Evaluations of its Jacobian.
    pub jacobians: Option<u64>,
    /// Accepted steps.
    pub steps: Option<u64>,
    /// Rejected steps.
    pub rejected: Option<u64>,
    /// Least time of a run, µs.
    pub microseconds: f64,
    /// Median time of a run, µs.
    pub median_microseconds: Option<f64>,
    /// Why there are no errors.
    pub reason: Option<String>,
    /// Who computed what the errors refer to: the independent `judge`, a closed form, or `replayed`
    /// by the run's own equations; none where there is nothing to compare with.
    pub reference: Option<String>,
    /// What an independent judge finds of the motion that the errors refer to.
    pub judge: Option<String>,
    /// Whether it is a tool that is not ours.
    #[serde(skip)]
    pub is_peer: bool,
}

impl WorkPrecisionRow {
    /// Whether the judge finds another motion.
    pub fn is_refuted(&self) -> bool {
        self.judge.as_ref().is_some_and(|judge| judge.starts_with("disagrees"))
    }

    /// Whether the machine did something else too while it was measured.
    pub fn is_disturbed(&self) -> bool {
        self.median_microseconds.is_some_and(|median| median > DISTURBED * self.microseconds)
    }

    /// The star behind its time where that is so, see [`DISTURBED_NOTE`].
    pub fn mark_disturbed(&self) -> &'static str {
        if self.is_disturbed() { "*" } else { "" }
    }

    /// Whether there is nothing to compare it with.
    pub fn is_not_judged(&self) -> bool {
        self.state_error.is_none() && self.reference.is_none()
    }

    /// A measurement on a model.
    pub fn new(model: &str, measured: Measurement) -> Self {
        let work = measured.statistics;
        Self {
            model: model.into(),
            method: measured.method.into(),
            tolerance: measured.tolerance,
            state_error: measured.state_error,
            run_error: measured.run_error,
            event_error: measured.event_error,
            evaluations: Some(work.evaluations),
            jacobians: Some(work.jacobians),
            steps: Some(work.steps),
            rejected: Some(work.rejected),
            microseconds: 1e6 * measured.least,
            median_microseconds: Some(1e6 * measured.median),
            reason: measured.reason,
            reference: measured.source.map(|source| source.to_string()),
            judge: Some(measured.verdict.to_string()),
            is_peer: false,
        }
    }

    /// A run of a tool that is not ours.
    pub fn peer(
        (scene, tool, tolerance): (&str, &str, f64),
        [state_error, event_error]: [Option<f64>; 2],
        microseconds: f64,
    ) -> Self {
        Self {
            model: scene.into(),
            method: tool.into(),
            tolerance,
            state_error,
            run_error: None,
            event_error,
            evaluations: None,
            jacobians: None,
            steps: None,
            rejected: None,
            microseconds,
            median_microseconds: None,
            reason: None,
            reference: None,
            judge: None,
            is_peer: true,
        }
    }
}

/// Measures a model.
pub fn rows(
    model: &Entry,
    spec: &RunSpec,
    request: &PrecisionSpec,
) -> Result<Vec<WorkPrecisionRow>, MotionError> {
    let measured = model.precision(spec, request)?;
    Ok(measured.into_iter().map(|measured| WorkPrecisionRow::new(model.name(), measured)).collect())
}
