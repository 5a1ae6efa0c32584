//! What follows an event: a run of the engine from the state there, over a moment.

use super::projected;
use liftoff::contact_set;
use liftoff::{EventKind, Pose, RunCause, Segment, Simulation, Trajectory};
use liftoff_core::model::ContactSet;
use liftoff_studio::registry::chain;

/// The moment, in natural times: far below any motion.
const MOMENT: f64 = 1e-6;

/// What follows an event.
pub(crate) struct Decision {
    /// Coordinates, then rates.
    pub(crate) state: Vec<f64>,
    /// The phase that begins.
    pub(crate) phase: Segment,
    /// How many events there were at once.
    pub(crate) events: i32,
    /// Whether the motion ends here.
    pub(crate) ended: bool,
    /// Whether contacts were struck.
    struck: bool,
}

/// Decides what follows a state.
///
/// # Errors
/// The state is none of a motion, or nothing follows.
pub(crate) fn decide(simulation: &Simulation, t: f64, state: &[f64]) -> Result<Decision, String> {
    let told = |error: &dyn std::error::Error| chain(error);
    let limit = t + MOMENT * simulation.scales().time.max(t.abs() * MOMENT);
    let begun = simulation.continued(t, &pose(simulation, state)).map_err(|error| told(&error))?.limit(limit);
    let run = match begun.run() {
        Err(error)
            if !matches!(error.cause(), RunCause::Start(_)) && !error.trajectory().segments().is_empty() =>
        {
            // What fails later is told when it comes.
            error.into_trajectory()
        }
        run => run.map_err(|error| told(&error))?,
    };
    decision(&run, t).ok_or_else(|| format!("nothing follows the event at t = {t}"))
}

fn pose(simulation: &Simulation, state: &[f64]) -> Pose {
    Pose::of_state(simulation.layout(), state)
}

fn decision(run: &Trajectory, t: f64) -> Option<Decision> {
    let phase = run.segments().into_iter().rev().find(|phase| phase.t0 <= t)?;
    let now = run.events().iter().filter(|event| event.t <= t && event.kind != EventKind::Start);
    let kinds: Vec<EventKind> = now.map(|event| event.kind).collect();
    Some(Decision {
        state: run.state(t),
        phase,
        events: i32::try_from(kinds.len()).unwrap_or(i32::MAX),
        ended: kinds.contains(&EventKind::Close),
        struck: kinds.iter().any(|kind| matches!(kind, EventKind::Impact | EventKind::Taut)),
    })
}

impl Decision {
    /// The same at rest on its contacts, where impacts that follow one another ever faster come to
    /// their end within √tolerance of the natural time: they fly no higher than the tolerance, in
    /// natural lengths.
    ///
    /// # Errors
    /// Nothing follows that rest.
    pub(crate) fn settled(self, simulation: &Simulation, t: f64, tolerance: f64) -> Result<Self, String> {
        if !self.struck {
            return Ok(self);
        }
        let limit = t + tolerance.sqrt() * simulation.scales().time;
        let ahead = simulation
            .continued(t, &pose(simulation, &self.state))
            .map_err(|error| chain(&error))?
            .limit(limit);
        let Ok(ahead) = ahead.observe(&mut ()) else { return Ok(self) };
        let settle = ahead.events().iter().filter(|event| event.kind == EventKind::Settle);
        let resting = settle.filter_map(|event| contact_set(simulation.layout(), &event.supports).ok());
        let resting = resting.fold(ContactSet::EMPTY, ContactSet::union);
        if resting.is_empty() {
            return Ok(self);
        }
        let set = resting.iter().fold(self.phase.active_basis, ContactSet::with);
        let settled = decide(simulation, t, &projected(simulation, set, t, &self.state))?;
        Ok(Self { events: self.events + settled.events + 1, ..settled })
    }
}
