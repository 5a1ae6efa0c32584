//! Results of a member.

use crate::assembly::StartError;
use crate::error::{ModelError, OutputError, ScheduleError, SupportError};
use crate::event::{Event, EventKind};
use crate::expression::Output;
use crate::simulation::{RunCause, Simulation};

/// The result of a member.
#[derive(Debug, Clone)]
pub struct Member {
    /// Time of the end, s.
    pub t: f64,
    /// Coordinates, then rates.
    pub state: Vec<f64>,
    /// The values of the outputs that were asked for.
    pub outputs: Vec<f64>,
    /// What happened between start and end.
    pub events: Vec<Event>,
    /// How many steps were made.
    pub steps: u64,
}

/// Why a member has no result.
#[derive(Debug, Clone, thiserror::Error)]
pub enum MemberError {
    /// Its parameters describe no system.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Its start allows no motion.
    #[error(transparent)]
    Start(#[from] StartError),
    /// It names an unknown support.
    #[error(transparent)]
    Support(#[from] SupportError),
    /// A scheduled action of it is invalid.
    #[error(transparent)]
    Schedule(#[from] ScheduleError),
    /// A condition of it cannot be parsed.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Its run stopped short.
    #[error(transparent)]
    Run(#[from] RunCause),
    /// Its request is invalid.
    #[error("{0}")]
    Asked(String),
    /// The ensemble was stopped before it began.
    #[error("not run: the ensemble was stopped")]
    NotRun,
}

impl Member {
    /// A run by itself.
    pub(super) fn alone(simulation: &Simulation, outputs: &[Output]) -> Result<Self, MemberError> {
        let run = simulation.observe(&mut ()).map_err(|error| error.cause().clone())?;
        let t = run.end_time();
        let between = |event: &&Event| !matches!(event.kind, EventKind::Start | EventKind::End);
        Ok(Self {
            t,
            state: run.final_state(),
            outputs: outputs.iter().map(|output| run.value(output, t)).collect(),
            events: run.events().iter().filter(between).cloned().collect(),
            steps: run.statistics().steps,
        })
    }
}
