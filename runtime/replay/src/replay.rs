//! A run's phases and impacts in its order.

use crate::collision::{Collision, generalised};
use crate::extrapolation::{Extrapolation, IntegrationFailure};
use crate::friction;
use crate::instant::Instant;
use crate::model::{ReplayModel, ReplayPhase};
use crate::reading::{Located, Part, Reading, located};
use crate::root::{EventRefinement, TOGETHER};
use crate::{Number, ReplayError};
use liftoff::__private::event::Guard;
use liftoff::{AppliedImpulse, LoggedDecision, Segment, Trajectory};
use liftoff::{Event, EventKind};
use liftoff_core::model::ContactSet;
use liftoff_core::system::ModelOn;

/// The first step, in natural times.
const FIRST: f64 = 0.05;
/// How far, in natural units relative to the largest, the rates after an impact may be from those
/// of the run, and the state in which a phase begins from the one before it.
const APART: f64 = 1e-6;

/// A run once more.
#[derive(Debug, Clone)]
pub struct Replayed<S> {
    /// The time of each event; none of touches, which are double roots.
    pub times: Vec<Option<S>>,
    /// Coordinates and rates behind each event; at the time of a touch, which is fixed.
    pub states: Vec<Vec<S>>,
    /// Coordinates and rates at the times asked for.
    pub samples: Vec<Vec<S>>,
    /// Coordinates and rates at the end.
    pub end: Vec<S>,
}

/// A run once more, from a start of as many entries as a full state has or fewer, with an error per
/// step, relative; its states are wanted at these times, in order.
///
/// # Errors
/// The motion cannot be computed once more.
pub fn replay<S: Number>(
    run: &Trajectory,
    model: ModelOn<S>,
    start: &[S],
    tolerance: f64,
    samples: &[f64],
) -> Result<Replayed<S>, ReplayError> {
    let model = ReplayModel::new(run, model);
    let mut replay = Replay::new(&model, run, start, tolerance, f64::INFINITY)?;
    replay.wanted = samples;
    replay.play(usize::MAX)?;
    replay.state.truncate(2 * model.layout().coordinates.len());
    Ok(Replayed { times: replay.times, states: replay.states, samples: replay.samples, end: replay.state })
}

/// Outputs of a run once more, from a start as of [`replay`], as far as anything is read.
///
/// # Errors
/// The motion cannot be computed once more, an output has no value on these numbers, or the run
/// does not have its moment.
pub fn replay_outputs<S: Number>(
    run: &Trajectory,
    model: ModelOn<S>,
    start: &[S],
    tolerance: f64,
    readings: &[Reading<'_>],
) -> Result<Vec<S>, ReplayError> {
    let readings = located(run, &run.segments(), readings)?;
    let Some(last) = readings.last().copied() else { return Ok(Vec::new()) };
    let model = ReplayModel::new(run, model);
    let mut replay = Replay::new(&model, run, start, tolerance, last.t)?;
    replay.values = vec![S::ZERO; readings.len()];
    replay.readings = readings;
    replay.play(last.segment)?;
    Ok(replay.values)
}

/// A run being computed once more.
struct Replay<'a, S: Number> {
    model: &'a ReplayModel<S>,
    run: &'a Trajectory,
    tolerance: f64,
    t: S,
    state: Vec<S>,
    times: Vec<Option<S>>,
    states: Vec<Vec<S>>,
    /// Times at which the state is still wanted, and the states at those before.
    wanted: &'a [f64],
    samples: Vec<Vec<S>>,
    /// What is read, in the order of the run, and the values, in the order in which they were asked
    /// for.
    readings: Vec<Located<'a>>,
    values: Vec<S>,
}

impl<'a, S: Number> Replay<'a, S> {
    fn new(
        model: &'a ReplayModel<S>,
        run: &'a Trajectory,
        start: &[S],
        tolerance: f64,
        until: f64,
    ) -> Result<Self, ReplayError> {
        let first = run.events().first().ok_or(ReplayError::Empty)?;
        let mut events = run.events().iter().take_while(|event| event.t <= until);
        if let Some(settle) = events.find(|event| event.kind == EventKind::Settle) {
            return Err(ReplayError::Settles { t: settle.t });
        }
        refuse_singular_positions::<S>(run, until)?;
        let t = S::from_f64(first.t);
        let state = (0..model.layout().entries()).map(|i| start.get(i).copied().unwrap_or(t)).collect();
        let (readings, values) = (Vec::new(), Vec::new());
        let (times, states) = (vec![Some(t)], Vec::new());
        let (wanted, samples) = (&[][..], Vec::new());
        let mut replay =
            Self { model, run, tolerance, t, state, times, states, wanted, samples, readings, values };
        replay.keep();
        Ok(replay)
    }

    /// All phases up to that of this place.
    fn play(&mut self, last: usize) -> Result<(), ReplayError> {
        let segments = self.run.segments();
        let first = segments.first().ok_or(ReplayError::Empty)?;
        self.pass_events(first.t0, first.set)?;
        for (k, segment) in segments.iter().enumerate() {
            self.follow(k, segment)?;
            if k == last {
                break;
            }
            let next = segments.get(k + 1).map_or(segment.set, |next| next.set);
            self.pass_events(segment.t1, next)?;
        }
        Ok(())
    }

    fn keep(&mut self) {
        self.states.push(self.state[..2 * self.model.layout().coordinates.len()].to_vec());
    }

    /// One phase to its end.
    fn follow(&mut self, k: usize, segment: &Segment) -> Result<(), ReplayError> {
        let model = self.model;
        let phase = model.phase(segment.active_basis, segment.form);
        self.set_switches(&segment.acting);
        let mut reduced = phase.restrict(self.state.clone());
        if !self.is_here(&phase.embed(&reduced)) {
            return Err(ReplayError::Jump { t: segment.t0 });
        }
        let units = phase.units(&model.units);
        let mut integrator = Extrapolation::new(&phase, &units, self.tolerance, FIRST * model.time);
        let readings: Vec<_> = self.readings.iter().filter(|of| of.segment == k).copied().collect();
        for of in readings.iter().filter(|of| of.part != Part::End) {
            if of.part == Part::Within {
                integrator.evaluations = 0;
                self.go(of.t, &phase, &mut reduced, &mut integrator)?;
            }
            self.take(of, &phase, &reduced)?;
        }
        integrator.evaluations = 0;
        while let Some((&t, rest)) = self.wanted.split_first()
            && t < segment.t1
        {
            self.wanted = rest;
            self.go(t, &phase, &mut reduced, &mut integrator)?;
            self.samples.push(self.public(&phase, &reduced));
        }
        self.go(segment.t1, &phase, &mut reduced, &mut integrator)?;
        let guards = self.run.ended_by(k);
        if !guards.is_empty() {
            let conditions = self.run.conditions();
            let event = EventRefinement { model, phase: &phase, t: self.t, state: &reduced, conditions };
            let (after, found) = event.find(guards, &mut integrator)?;
            self.t = self.t + after;
            reduced = found;
            self.refuse_fixed_beside(guards, segment.t1)?;
        }
        for of in readings.iter().filter(|of| of.part == Part::End) {
            self.take(of, &phase, &reduced)?;
        }
        self.state = phase.embed(&reduced);
        if model.layout().timed {
            self.state[2 * model.layout().coordinates.len()] = self.t;
        }
        Ok(())
    }

    /// On within a phase to a time, by way of what touches.
    fn go(
        &mut self,
        to: f64,
        phase: &ReplayPhase<S>,
        reduced: &mut [S],
        integrator: &mut Extrapolation<'_, S>,
    ) -> Result<(), ReplayError> {
        while let Some(touch) = self.next_event().filter(|e| e.kind == EventKind::Touch && e.t < to) {
            self.advance(touch.t, reduced, integrator)?;
            self.times.push(None);
            self.states.push(self.public(phase, reduced));
        }
        self.advance(to, reduced, integrator)
    }

    /// Coordinates and rates of a reduced state.
    fn public(&self, phase: &ReplayPhase<S>, reduced: &[S]) -> Vec<S> {
        let mut state = phase.embed(reduced);
        state.truncate(2 * self.model.layout().coordinates.len());
        state
    }

    fn advance(
        &mut self,
        to: f64,
        reduced: &mut [S],
        integrator: &mut Extrapolation<'_, S>,
    ) -> Result<(), ReplayError> {
        let fixed = S::from_f64(to);
        integrator.advance(reduced, fixed - self.t).map_err(|failure| failed(failure, to))?;
        self.t = fixed;
        Ok(())
    }

    /// The first event that is not passed yet.
    fn next_event(&self) -> Option<&'a Event> {
        self.run.events().get(self.times.len())
    }

    /// Refuses what happens at a given time together with an event whose time varies: to one side
    /// it comes first.
    fn refuse_fixed_beside(&self, guards: &[Guard], t: f64) -> Result<(), ReplayError> {
        let varies = |k: usize| self.t.part(k).abs() > TOGETHER * self.model.time;
        let on_condition = guards.iter().any(|guard| matches!(guard, Guard::Condition(_)));
        let is_fixed = |event: &Event| match event.kind {
            EventKind::End | EventKind::Impulse => true,
            EventKind::Stop | EventKind::Release | EventKind::Cut => !on_condition,
            _ => false,
        };
        let mut here = self.run.events()[self.times.len()..].iter().take_while(|event| event.t <= t);
        if (1..S::PARTS).any(varies) && here.any(is_fixed) {
            return Err(ReplayError::Simultaneous { t });
        }
        Ok(())
    }

    /// What is read here.
    fn take(&mut self, of: &Located<'_>, phase: &ReplayPhase<S>, reduced: &[S]) -> Result<(), ReplayError> {
        self.values[of.place] = match of.output {
            None => self.t,
            Some(output) => Instant::new(self.model, phase, self.t, reduced)
                .output(output)
                .map_err(|why| ReplayError::Output { output: output.to_string(), feature: why.0 })?,
        };
        Ok(())
    }

    /// Lets what is switched act as in a phase.
    fn set_switches(&mut self, acting: &[usize]) {
        let layout = self.model.layout();
        for i in 0..layout.switches.len() {
            let acts = f64::from(u8::from(acting.contains(&i)));
            self.state[layout.switch(i)] = S::from_f64(acts);
        }
    }

    /// Whether a state is the one reached.
    fn is_here(&self, state: &[S]) -> bool {
        let entries = state.iter().zip(&self.state).zip(&self.model.units);
        let n = 2 * self.model.layout().coordinates.len();
        entries.take(n).all(|((entered, reached), unit)| {
            let apart = (*entered - *reached).abs().to_f64();
            apart <= APART * unit.max(reached.to_f64().abs())
        })
    }

    /// The events up to and at the time `t` of the run, where a phase ended.
    fn pass_events(&mut self, t: f64, next: ContactSet) -> Result<(), ReplayError> {
        let events = self.run.events();
        while let Some(event) = self.next_event().filter(|event| event.t <= t) {
            let touch = event.kind == EventKind::Touch;
            self.times.push((!touch).then_some(self.t));
            let follows = events.get(self.times.len()).filter(|next| next.t == event.t);
            match event.kind {
                EventKind::Taut | EventKind::Impact
                    if follows.is_some_and(|next| next.kind == EventKind::Taut) => {}
                EventKind::Impact | EventKind::Taut => self.collide(event, next, None)?,
                EventKind::Impulse => {
                    let impulses = self.run.impulses().iter().filter(|impulse| impulse.t == event.t);
                    let mut load = vec![S::ZERO; self.model.layout().coordinates.len()];
                    for AppliedImpulse { point, impulse, .. } in impulses {
                        let part = generalised(self.model, &self.state, *point, *impulse);
                        load.iter_mut().zip(part).for_each(|(sum, part)| *sum = *sum + part);
                    }
                    self.collide(event, next, Some(load))?;
                }
                _ => {}
            }
            self.keep();
        }
        Ok(())
    }

    /// The rates after a collision: of those that a law of impact allows the ones nearest to the
    /// run's.
    fn collide(
        &mut self,
        event: &Event,
        stays: ContactSet,
        applied: Option<Vec<S>>,
    ) -> Result<(), ReplayError> {
        let n = self.model.layout().coordinates.len();
        let struck = event.impulses.iter().filter(|impulse| impulse.value > 0.0);
        let acting = struck.fold(stays, |set, impulse| set.with(impulse.contact));
        let after = self.model.layout().state_at(&event.state, event.t);
        let after: Vec<S> = after.into_iter().map(S::from_f64).collect();
        let acting = friction::ending(self.model, &after, acting);
        let applied = applied.unwrap_or_else(|| vec![S::ZERO; n]);
        let answers = Collision::new(self.model, &self.state, acting).answers(&applied, stays);
        let units = &self.model.units[n..2 * n];
        let recorded = &event.state[n..2 * n];
        let largest = recorded.iter().zip(units).fold(1.0, |most: f64, (u, unit)| most.max((u / unit).abs()));
        let apart = |rates: &[S]| {
            let apart = rates
                .iter()
                .zip(recorded)
                .zip(units)
                .map(|((u, recorded), unit)| (u.to_f64() - recorded).abs() / unit);
            apart.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
        };
        let nearest = answers.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let rates = nearest.filter(|rates| apart(rates) <= APART * largest);
        let rates = rates.ok_or(ReplayError::Impact { t: event.t })?;
        self.state[n..2 * n].copy_from_slice(rates);
        Ok(())
    }
}

/// Refuses derivatives through a singular position of a loop, across which the run was continued
/// along its branch.
fn refuse_singular_positions<S: Number>(run: &Trajectory, until: f64) -> Result<(), ReplayError> {
    let passed = |decision: &LoggedDecision| *decision == LoggedDecision::SingularPosition;
    let until = until.min(run.end_time());
    match run.log().iter().find(|entry| passed(&entry.decision) && entry.t <= until) {
        Some(entry) if S::infinitesimal().is_some() => Err(ReplayError::Singular { t: entry.t }),
        _ => Ok(()),
    }
}

pub(crate) fn failed(failure: IntegrationFailure, t: f64) -> ReplayError {
    match failure {
        IntegrationFailure::Step => ReplayError::Step { t },
        IntegrationFailure::Work => ReplayError::Work { t },
    }
}
