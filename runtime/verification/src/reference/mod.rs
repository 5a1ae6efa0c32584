//! A motion to more digits than doubles have, by a method that had no part in it.
//!
//! By the independent judge, which has of the finished run only its start and what was asked for.
//! What is beyond the judge is replayed: the run tells which contacts were closed when, and which
//! guard ended each phase. Each phase is integrated in double-double by Gragg's extrapolated
//! method, to the root of that guard nearest to where the run found it; impacts are solved from the
//! contacts that acted. What is trusted of the run is then its contact sets, its equations and the
//! order of its events.
//!
//! Either twice over, with series of different order or at two tolerances: their difference bounds
//! the error.

mod error;
mod judged;

pub use error::ReferenceError;

use std::sync::Arc;

use judged::judged;
use liftoff::Scales;
use liftoff::Trajectory;
use liftoff::{Event, EventKind};
use liftoff_core::scalar::{DoubleDouble, Real, Scalar};
use liftoff_core::system::{ModelOn, System};
use liftoff_replay::{ReplayError, replay};

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
    /// A closed form.
    ClosedForm,
    /// The run once more, with its own contact sets and equations: not independent, since the judge
    /// cannot do it.
    Replay {
        /// Why.
        why: String,
    },
}

impl core::fmt::Display for Source {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Judge => f.write_str("judge"),
            Self::ClosedForm => f.write_str("closed form"),
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

/// Parts of a run in the middle of which the state is compared.
const PARTS: usize = 32;

/// A motion's events and states to more digits than doubles have.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    source: Source,
    events: Vec<ReferenceEvent>,
    samples: Vec<(f64, Vec<DoubleDouble>)>,
    state: Vec<DoubleDouble>,
    units: Vec<f64>,
    time: f64,
    bound: f64,
}

/// What is computed twice.
#[derive(Clone)]
struct Computed {
    events: Vec<ReferenceEvent>,
    samples: Vec<(f64, Vec<DoubleDouble>)>,
    end: Vec<DoubleDouble>,
}

/// The middles of equal parts of a run.
fn samples(run: &Trajectory) -> Vec<f64> {
    let [start, end] = run.interval();
    (0..PARTS).map(|k| start + (end - start) * (k as f64 + 0.5) / PARTS as f64).collect()
}

impl Reference {
    /// The motion of a run by the independent judge, with the supports held that were; where that
    /// cannot do it, the run [once more](Self::replayed). `system` makes the model's equations from
    /// the values of its parameters, for a compiled model
    /// [`precise`](liftoff_core::system::precise). Takes some thousand times as long as the run;
    /// the tighter the run's tolerance, the surer that its events are found again.
    ///
    /// # Errors
    /// The motion cannot be computed, or not to more digits than doubles have; or the judge finds
    /// another.
    pub fn compute(
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

    /// The motion of a run once more in double-double, with the contacts and equations of the run
    /// but by another method.
    ///
    /// # Errors
    /// The motion cannot be computed once more, or not to more digits than doubles have.
    pub fn replayed(
        run: &Trajectory,
        system: impl FnOnce(&[f64]) -> Arc<dyn System<DoubleDouble>>,
    ) -> Result<Self, ReferenceError> {
        Self::replayed_with(run, system(run.parameters()))
    }

    /// A closed form of the state, coordinates then rates, over a run that ends at a given time and
    /// has no event before: a motion so stiff that nothing else follows it, for instance.
    ///
    /// # Errors
    /// The run has events on the way.
    pub fn closed_form(
        run: &Trajectory,
        state: impl Fn(f64) -> Vec<DoubleDouble>,
    ) -> Result<Self, ReferenceError> {
        let is_given =
            |event: &Event| matches!(event.kind, EventKind::Start | EventKind::Stop | EventKind::End);
        if let Some(event) = run.events().iter().find(|event| !is_given(event)) {
            return Err(ReplayError::Event { t: event.t }.into());
        }
        let event = |event: &Event| ReferenceEvent {
            kind: event.kind,
            supports: event.supports.clone(),
            t: Some(DoubleDouble::from_f64(event.t)),
            summed: false,
        };
        let known = Computed {
            events: run.events().iter().map(event).collect(),
            samples: samples(run).into_iter().map(|t| (t, state(t))).collect(),
            end: state(run.end_time()),
        };
        Self::of_two(run, Source::ClosedForm, known.clone(), known)
    }

    fn replayed_with(
        run: &Trajectory,
        system: Arc<dyn System<DoubleDouble>>,
    ) -> Result<Self, ReferenceError> {
        let on = |values: &[f64]| values.iter().map(|&x| DoubleDouble::from_f64(x)).collect::<Vec<_>>();
        let parameters = on(run.parameters());
        let model = ModelOn { system, parameters, restitution: on(&run.model().restitution) };
        let start = run.events().first().ok_or(ReplayError::Empty)?.state.clone();
        let times = samples(run);
        let one = |tolerance: f64| -> Result<Computed, ReferenceError> {
            let replayed = replay(run, model.clone(), &on(&start), tolerance, &times)?;
            let events = run.events().iter().zip(replayed.times);
            let event = |(event, t): (&liftoff::Event, _)| ReferenceEvent {
                kind: event.kind,
                supports: event.supports.clone(),
                t,
                summed: false,
            };
            let samples = times.iter().copied().zip(replayed.samples).collect();
            Ok(Computed { events: events.map(event).collect(), samples, end: replayed.end })
        };
        let source = Source::Replay { why: "asked for".to_owned() };
        Self::of_two(run, source, one(FINE)?, one(COARSE)?)
    }

    /// What was computed twice: the first, and how far they are apart.
    fn of_two(
        run: &Trajectory,
        source: Source,
        Computed { events, samples, end: state }: Computed,
        coarse: Computed,
    ) -> Result<Self, ReferenceError> {
        let Scales { time, .. } = run.scales();
        let units = run.scales().state(run.layout())[..state.len()].to_vec();
        let mut reference = Self { source, events, samples, state, units, time, bound: 0.0 };
        // Of infinitely many impacts the last may be counted or not.
        let own = |events: &[ReferenceEvent]| -> Vec<Option<DoubleDouble>> {
            events.iter().filter(|event| !event.summed).map(|event| event.t).collect()
        };
        let late = own(&reference.events).into_iter().zip(own(&coarse.events));
        let late = late.filter_map(|(fine, coarse)| Some(reference.time_difference(fine?, coarse?)));
        let states = reference.samples.iter().zip(&coarse.samples);
        let states = states.map(|((_, fine), (_, coarse))| reference.difference(fine, coarse));
        let last = reference.difference(&reference.state, &coarse.end);
        let bound = late.chain(states).fold(last, larger);
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

    /// The largest error of the times of these events; none if they are others. Touches count in
    /// neither.
    pub fn lateness<'e>(&self, events: impl Iterator<Item = &'e Event>) -> Option<f64> {
        let pairs = self.paired(events)?;
        let late = pairs.iter().map(|&(known, t)| self.time_difference(known, DoubleDouble::from_f64(t)));
        Some(late.fold(0.0, f64::max))
    }

    /// The times of its events and of these; none if they are others.
    fn paired<'e>(&self, events: impl Iterator<Item = &'e Event>) -> Option<Vec<(DoubleDouble, f64)>> {
        let counts = |kind: EventKind| kind != EventKind::Touch;
        let mut own = self.events.iter().filter(|event| counts(event.kind));
        let mut pairs = Vec::new();
        for event in events.filter(|event| counts(event.kind)) {
            let same =
                |known: &&ReferenceEvent| (known.kind, &known.supports) == (event.kind, &event.supports);
            let known = own.find(|known| same(known) || !known.summed).filter(same)?;
            pairs.extend(known.t.map(|known| (known, event.t)));
        }
        own.all(|known| known.summed).then_some(pairs)
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
        self.deviation(&self.state, state)
    }

    /// The largest error of a run's states at its end and, as its dense output has them, in the
    /// middles of 32 equal parts, measured as that of the final state is; none if its events are
    /// others. A place between an event of the run and the same of the reference counts as an error
    /// of that event's time; nothing else is left out.
    pub fn run_error(&self, run: &Trajectory) -> Option<f64> {
        let pairs = self.paired(run.events().iter())?;
        let is_between = |at: f64| pairs.iter().any(|(known, t)| (known.to_f64() - at) * (t - at) <= 0.0);
        let places = self.samples.iter().filter(|(t, _)| *t < run.end_time() && !is_between(*t));
        let errors = places.map(|(t, known)| self.deviation(known, &run.state(*t)));
        Some(errors.fold(self.state_error(&run.final_state()), larger))
    }

    fn deviation(&self, known: &[DoubleDouble], state: &[f64]) -> f64 {
        let state: Vec<_> = state.iter().map(|&x| DoubleDouble::from_f64(x)).collect();
        self.difference(known, &state)
    }

    fn time_difference(&self, time: DoubleDouble, other: DoubleDouble) -> f64 {
        (other - time).abs().to_f64() / self.time
    }

    fn difference(&self, known: &[DoubleDouble], other: &[DoubleDouble]) -> f64 {
        let entries = known.iter().zip(other).zip(&self.units);
        let deviations = entries.map(|((&x, &other), &unit)| (other - x).abs().to_f64() / unit);
        deviations.fold(0.0, larger)
    }
}

/// Where one is not a number, that; `f64::max` passes over it.
fn larger(most: f64, x: f64) -> f64 {
    if x.is_nan() || x > most { x } else { most }
}
