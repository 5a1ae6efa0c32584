//! A run's phases and impacts in its order, in double-double.

use super::ReferenceError;
use super::collision::{Collision, generalised};
use super::extrapolation::{Extrapolation, IntegrationFailure};
use super::model::PreciseModel;
use super::root::EventRefinement;
use liftoff::event::Guard;
use liftoff::event::{Event, EventKind};
use liftoff::model::ContactSet;
use liftoff::scalar::{DoubleDouble, Real, Scalar};
use liftoff::{AppliedImpulse, Segment, Trajectory};

/// The first step, in natural times.
const FIRST: f64 = 0.05;
/// How far, in natural units relative to the largest, the rates after an impact may be from those of the run, and the state
/// in which a phase begins from the one before it.
const APART: f64 = 1e-6;

/// Times of the events, and the final state.
pub(super) type Played = (Vec<Option<DoubleDouble>>, Vec<DoubleDouble>);

/// A run being computed once more.
pub(super) struct Replay<'a> {
    model: &'a PreciseModel,
    run: &'a Trajectory,
    tolerance: f64,
    t: DoubleDouble,
    state: Vec<DoubleDouble>,
    times: Vec<Option<DoubleDouble>>,
}

impl<'a> Replay<'a> {
    /// At the start of the run, whose state is exact by definition.
    pub(super) fn new(
        model: &'a PreciseModel,
        run: &'a Trajectory,
        tolerance: f64,
    ) -> Result<Self, ReferenceError> {
        let start = run.events().first().ok_or(ReferenceError::Empty)?;
        if let Some(settle) = run.events().iter().find(|event| event.kind == EventKind::Settle) {
            return Err(ReferenceError::Settles { t: settle.t });
        }
        let t = DoubleDouble::from_f64(start.t);
        let entry = |i: usize| start.state.get(i).map_or(t, |&x| DoubleDouble::from_f64(x));
        let state = (0..model.layout().entries()).map(entry).collect();
        Ok(Self { model, run, tolerance, t, state, times: vec![Some(t)] })
    }

    pub(super) fn play(mut self) -> Result<Played, ReferenceError> {
        let segments = self.run.segments();
        let first = segments.first().ok_or(ReferenceError::Empty)?;
        self.pass_events(first.t0, first.set)?;
        for (k, segment) in segments.iter().enumerate() {
            let guards = self.run.ended_by(k);
            self.follow(segment, guards)?;
            let next = segments.get(k + 1).map_or(segment.set, |next| next.set);
            self.pass_events(segment.t1, next)?;
        }
        self.state.truncate(2 * self.model.layout().coordinates.len());
        Ok((self.times, self.state))
    }

    /// One phase to its end.
    fn follow(&mut self, segment: &Segment, guards: &[Guard]) -> Result<(), ReferenceError> {
        let model = self.model;
        let phase = model.phase(segment.bearing, segment.form);
        self.set_switches(&segment.acting);
        let mut reduced = phase.restrict(self.state.clone());
        if !self.is_here(&phase.embed(&reduced)) {
            return Err(ReferenceError::Jump { t: segment.t0 });
        }
        let mut integrator = Extrapolation {
            field: &phase,
            units: &phase.units(&model.units),
            tolerance: self.tolerance,
            step: FIRST * model.time,
            evaluations: 0,
        };
        let end = DoubleDouble::from_f64(segment.t1);
        let span = end - self.t;
        integrator.advance(&mut reduced, span).map_err(|failure| failed(failure, segment.t1))?;
        self.t = end;
        if !guards.is_empty() {
            let conditions = self.run.conditions();
            let event = EventRefinement { model, phase: &phase, t: end, state: &reduced, conditions };
            let (after, found) = event.find(guards, &mut integrator)?;
            self.t = end + after;
            reduced = found;
        }
        self.state = phase.embed(&reduced);
        if model.layout().timed {
            self.state[2 * model.layout().coordinates.len()] = self.t;
        }
        Ok(())
    }

    /// Lets what is switched act as in a phase.
    fn set_switches(&mut self, acting: &[usize]) {
        let layout = self.model.layout();
        for i in 0..layout.switches.len() {
            let acts = f64::from(u8::from(acting.contains(&i)));
            self.state[layout.switch(i)] = DoubleDouble::from_f64(acts);
        }
    }

    /// Whether a state is the one reached.
    fn is_here(&self, state: &[DoubleDouble]) -> bool {
        let entries = state.iter().zip(&self.state).zip(&self.model.units);
        let n = 2 * self.model.layout().coordinates.len();
        entries.take(n).all(|((entered, reached), unit)| {
            let apart = (*entered - *reached).abs().to_f64();
            apart <= APART * unit.max(reached.to_f64().abs())
        })
    }

    /// The events up to and at the time `t` of the run, where a phase ended.
    fn pass_events(&mut self, t: f64, next: ContactSet) -> Result<(), ReferenceError> {
        let events = self.run.events();
        while let Some(event) = events.get(self.times.len()).filter(|event| event.t <= t) {
            let touch = event.kind == EventKind::Touch;
            self.times.push((!touch).then_some(self.t));
            let follows = events.get(self.times.len()).filter(|next| next.t == event.t);
            match event.kind {
                EventKind::Taut | EventKind::Impact
                    if follows.is_some_and(|next| next.kind == EventKind::Taut) => {}
                EventKind::Impact | EventKind::Taut => self.collide(event, next, None)?,
                EventKind::Impulse => {
                    let impulses = self.run.impulses().iter().filter(|impulse| impulse.t == event.t);
                    let mut load = vec![DoubleDouble::ZERO; self.model.layout().coordinates.len()];
                    for AppliedImpulse { point, impulse, .. } in impulses {
                        let part = generalised(self.model, &self.state, *point, *impulse);
                        load.iter_mut().zip(part).for_each(|(sum, part)| *sum = *sum + part);
                    }
                    self.collide(event, next, Some(load))?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The rates after a collision: of those that a law of impact allows the ones nearest to the run's.
    fn collide(
        &mut self,
        event: &Event,
        stays: ContactSet,
        applied: Option<Vec<DoubleDouble>>,
    ) -> Result<(), ReferenceError> {
        let n = self.model.layout().coordinates.len();
        let struck = event.impulses.iter().filter(|impulse| impulse.value > 0.0);
        let acting = struck.fold(stays, |set, impulse| set.with(impulse.contact));
        let applied = applied.unwrap_or_else(|| vec![DoubleDouble::ZERO; n]);
        let answers = Collision::new(self.model, &self.state, acting).answers(&applied, stays);
        let units = &self.model.units[n..2 * n];
        let recorded = &event.state[n..2 * n];
        let largest = recorded.iter().zip(units).fold(1.0, |most: f64, (u, unit)| most.max((u / unit).abs()));
        let apart = |rates: &[DoubleDouble]| {
            let apart = rates
                .iter()
                .zip(recorded)
                .zip(units)
                .map(|((u, recorded), unit)| (u.to_f64() - recorded).abs() / unit);
            apart.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
        };
        let nearest = answers.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let rates = nearest.filter(|rates| apart(rates) <= APART * largest);
        let rates = rates.ok_or(ReferenceError::Impact { t: event.t })?;
        self.state[n..2 * n].copy_from_slice(rates);
        Ok(())
    }
}

pub(super) fn failed(failure: IntegrationFailure, t: f64) -> ReferenceError {
    match failure {
        IntegrationFailure::Step => ReferenceError::Step { t },
        IntegrationFailure::Work => ReferenceError::Work { t },
    }
}
