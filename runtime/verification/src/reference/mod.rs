//! A motion to more digits than doubles have, by a method that had no part in it.
//!
//! By the independent judge, which has of the finished run only its start and what was asked for. What is beyond the judge is
//! replayed: the run tells which contacts were closed when, and which guard ended each phase. Each phase is integrated in
//! double-double by Gragg's extrapolated method, to the root of that guard nearest to where the run found it; impacts are
//! solved from the contacts that acted. What is trusted of the run is then its contact sets, its equations and the order of its
//! events.
//!
//! Either twice over, with series of different order or at two tolerances: their difference bounds the error.

mod error;
mod judged;

pub use error::ReferenceError;

use std::sync::Arc;

use judged::judged;
use liftoff::Scales;
use liftoff::Trajectory;
use liftoff::event::{Event, EventKind};
use liftoff::scalar::{DoubleDouble, Real, Scalar};
use liftoff::system::{ModelOn, System};
use liftoff_replay::{ReplayError, Replayed, replay};

/// Error per step of the two passes.
const FINE: f64 = 1e-27;
const COARSE: f64 = 1e-24;
/// Above this a reference says little of runs in doubles.
const USELESS: f64 = 1e-15;

/// Who computed a reference.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// The independent judge.
    Judge,
    /// The run once more, with its own contact sets and equations: not independent, since the judge cannot do it.
    Replay {
        /// Why.
        why: String,
    },
}

impl core::fmt::Display for Source {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Judge => f.write_str("judge"),
            Self::Replay { .. } => f.write_str("replayed"),
        }
    }
}

/// An event of a reference.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceEvent {
    /// What.
    pub kind: EventKind,
    /// To which supports.
    pub supports: Vec<&'static str>,
    /// When; none of touches, which are double roots.
    pub t: Option<DoubleDouble>,
    /// Whether it is one of infinitely many impacts, which a run may sum up in their end.
    pub summed: bool,
}

/// A motion's events and end to more digits than doubles have.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    source: Source,
    events: Vec<ReferenceEvent>,
    state: Vec<DoubleDouble>,
    units: Vec<f64>,
    time: f64,
    bound: f64,
}

/// Events, and the final state.
type Computed = (Vec<ReferenceEvent>, Vec<DoubleDouble>);

impl Reference {
    /// The motion of a run by the independent judge, with the supports held that were; where that cannot do it, the run
    /// [once more](Self::replayed).
    /// `system` makes the model's equations from the values of its parameters, for a compiled model
    /// [`precise`](liftoff::system::precise). Takes some thousand times as long as the run; the tighter the run's tolerance,
    /// the surer that its events are found again.
    ///
    /// # Errors
    /// The motion cannot be computed, or not to more digits than doubles have; or the judge finds another.
    pub fn of(
        run: &Trajectory,
        held: &[&str],
        system: impl FnOnce(&[f64]) -> Arc<dyn System<DoubleDouble>>,
    ) -> Result<Self, ReferenceError> {
        let system = system(run.parameters());
        match judged(run, held, &system) {
            Err(ReferenceError::NotJudged { why }) => {
                let replayed = Self::replayed_with(run, system)?;
                Ok(Self { source: Source::Replay { why }, ..replayed })
            }
            other => other,
        }
    }

    /// The motion of a run once more in double-double, with the contacts and equations of the run but by another method.
    ///
    /// # Errors
    /// The motion cannot be computed once more, or not to more digits than doubles have.
    pub fn replayed(
        run: &Trajectory,
        system: impl FnOnce(&[f64]) -> Arc<dyn System<DoubleDouble>>,
    ) -> Result<Self, ReferenceError> {
        Self::replayed_with(run, system(run.parameters()))
    }

    fn replayed_with(
        run: &Trajectory,
        system: Arc<dyn System<DoubleDouble>>,
    ) -> Result<Self, ReferenceError> {
        let on = |values: &[f64]| values.iter().map(|&x| DoubleDouble::from_f64(x)).collect::<Vec<_>>();
        let parameters = on(run.parameters());
        let model = ModelOn { system, parameters, restitution: on(&run.model().restitution) };
        let start = run.events().first().ok_or(ReplayError::Empty)?.state.clone();
        let one = |tolerance: f64| -> Result<Computed, ReferenceError> {
            let Replayed { times, end: state, .. } = replay(run, model.clone(), &on(&start), tolerance)?;
            let events = run.events().iter().zip(times);
            let event = |(event, t): (&liftoff::Event, _)| ReferenceEvent {
                kind: event.kind,
                supports: event.supports.clone(),
                t,
                summed: false,
            };
            Ok((events.map(event).collect(), state))
        };
        let source = Source::Replay { why: "asked for".to_owned() };
        Self::of_two(run, source, one(FINE)?, one(COARSE)?)
    }

    /// What was computed twice: the first, and how far they are apart.
    fn of_two(
        run: &Trajectory,
        source: Source,
        (events, state): Computed,
        coarse: Computed,
    ) -> Result<Self, ReferenceError> {
        let Scales { time, .. } = run.scales();
        let units = run.scales().state(run.layout())[..state.len()].to_vec();
        let mut reference = Self { source, events, state, units, time, bound: 0.0 };
        // Of infinitely many impacts the last may be counted or not.
        let own = |events: &[ReferenceEvent]| -> Vec<Option<DoubleDouble>> {
            events.iter().filter(|event| !event.summed).map(|event| event.t).collect()
        };
        let late = own(&reference.events).into_iter().zip(own(&coarse.0));
        let late = late.filter_map(|(fine, coarse)| Some(reference.time_difference(fine?, coarse?)));
        let bound = late.fold(reference.difference(&coarse.1), f64::max);
        if bound.is_nan() || bound > USELESS {
            return Err(ReferenceError::Bound { bound });
        }
        reference.bound = bound;
        Ok(reference)
    }

    /// Who computed it.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// Its events, in order of time.
    pub fn events(&self) -> &[ReferenceEvent] {
        &self.events
    }

    /// The largest error of the times of these events; none if they are others. Touches count in neither.
    pub fn lateness<'e>(&self, events: impl Iterator<Item = &'e Event>) -> Option<f64> {
        let counts = |kind: EventKind| kind != EventKind::Touch;
        let mut own = self.events.iter().filter(|event| counts(event.kind));
        let mut late = 0.0;
        for event in events.filter(|event| counts(event.kind)) {
            let same =
                |known: &&ReferenceEvent| (known.kind, &known.supports) == (event.kind, &event.supports);
            let known = own.find(|known| same(known) || !known.summed).filter(same)?;
            let t = DoubleDouble::from_f64(event.t);
            late = f64::max(late, known.t.map_or(0.0, |known| self.time_difference(known, t)));
        }
        own.all(|known| known.summed).then_some(late)
    }

    /// The state at the end, coordinates then rates.
    pub fn state(&self) -> &[DoubleDouble] {
        &self.state
    }

    /// Largest difference of the two computations, measured as errors are.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// The error of a time in natural times √(length / gravity).
    pub fn time_error(&self, event: usize, t: f64) -> Option<f64> {
        let time = self.events.get(event)?.t?;
        Some(self.time_difference(time, DoubleDouble::new(t, 0.0)))
    }

    /// The error of a final state: the largest deviation of a coordinate or rate in natural units
    /// of the model, angles in radians.
    pub fn state_error(&self, state: &[f64]) -> f64 {
        let state: Vec<_> = state.iter().map(|&x| DoubleDouble::new(x, 0.0)).collect();
        self.difference(&state)
    }

    fn time_difference(&self, time: DoubleDouble, other: DoubleDouble) -> f64 {
        (other - time).abs().to_f64() / self.time
    }

    fn difference(&self, other: &[DoubleDouble]) -> f64 {
        let entries = self.state.iter().zip(other).zip(&self.units);
        let deviations = entries.map(|((&x, &other), &unit)| (other - x).abs().to_f64() / unit);
        // `f64::max` passes over what is not a number.
        deviations.fold(0.0, |most: f64, x| if x.is_nan() || x > most { x } else { most })
    }
}
