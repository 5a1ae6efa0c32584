//! What is planned for a run: supports that vanish, threads that are cut, impulses; at a time or on a condition.

use nalgebra::DVector;

use super::Driver;
use crate::contact::Series;
use crate::error::{RunCause, ScheduleError};
use crate::event::EventKind;
use crate::model::{Array, BarSystem, ContactKind, ContactSet};
use crate::output::Condition;
use crate::trajectory::Blow;

/// Something that is to happen once.
#[derive(Debug, Clone)]
pub(crate) struct Planned {
    pub(crate) action: Action,
    pub(crate) when: When,
}

/// What is to happen.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Action {
    /// A contact ceases to exist.
    Remove(usize),
    /// An impulse at a point.
    Impulse { point: usize, impulse: [f64; 2] },
}

/// When it is to happen.
#[derive(Debug, Clone)]
pub(crate) enum When {
    At(f64),
    If(Condition),
}

impl When {
    pub(crate) fn at(at: f64) -> Result<Self, ScheduleError> {
        if at >= 0.0 && at.is_finite() { Ok(Self::At(at)) } else { Err(ScheduleError::Time { at }) }
    }
}

impl<M: BarSystem> Driver<'_, M> {
    /// Times at which something is still to happen.
    pub(super) fn planned_times(&self) -> impl Iterator<Item = f64> {
        let plan = self.setup.plan.iter().zip(&self.done);
        plan.filter_map(|(planned, done)| match planned.when {
            When::At(at) if !done => Some(at),
            _ => None,
        })
    }

    /// The plan's conditions that are still to be met, as guards: their indices follow those of the stops.
    pub(super) fn awaited(&self, condition: usize) -> bool {
        self.planned_on(condition).is_none_or(|k| !self.done[k])
    }

    /// The entry of the plan that a condition belongs to.
    pub(super) fn planned_on(&self, condition: usize) -> Option<usize> {
        let conditional = self.setup.plan.iter().enumerate().filter(|(_, p)| matches!(p.when, When::If(_)));
        let stops = self.setup.conditions.len();
        conditional.map(|(k, _)| k).nth(condition.checked_sub(stops)?)
    }

    /// Does what is due at this time.
    pub(super) fn do_due(&mut self) -> Result<(), RunCause> {
        let due = |planned: &Planned| matches!(planned.when, When::At(at) if at <= self.t);
        let due: Vec<usize> =
            (0..self.done.len()).filter(|&k| !self.done[k] && due(&self.setup.plan[k])).collect();
        self.carry_out(&due)
    }

    /// Removals first, then all impulses as one.
    pub(super) fn carry_out(&mut self, due: &[usize]) -> Result<(), RunCause> {
        let mut removed = ContactSet::EMPTY;
        let mut applied: Option<DVector<f64>> = None;
        let mut told = Vec::new();
        for &k in due {
            self.done[k] = true;
            match self.setup.plan[k].action {
                Action::Remove(contact) => removed = removed.with(contact),
                Action::Impulse { point, impulse } => {
                    let load = self.generalised(point, impulse);
                    self.trajectory.blows.push(Blow { t: self.t, point, impulse });
                    told.push(format!("({}, {}) at {}", impulse[0], impulse[1], M::LAYOUT.points[point]));
                    applied = Some(applied.map_or(load.clone(), |sum| sum + load));
                }
            }
        }
        let removed = ContactSet(removed.0 & !self.removed.0);
        if !removed.is_empty() {
            self.remove(removed)?;
        }
        applied.map_or(Ok(()), |load| self.push(load, &told.join(", ")))
    }

    fn remove(&mut self, due: ContactSet) -> Result<(), RunCause> {
        self.removed = ContactSet(self.removed.0 | due.0);
        self.touching = ContactSet(self.closed.0 & !due.0);
        let before = self.touching;
        self.decide(ContactSet::EMPTY)?;
        let (threads, supports) = split::<M>(due);
        self.record_some(EventKind::Release, supports);
        self.record_some(EventKind::Cut, threads);
        self.record_opened(ContactSet(before.0 & !self.closed.0));
        Ok(())
    }

    /// Q = (∂r/∂q)ᵀ p for the impulse p at a point: the slope of its position along each coordinate.
    fn generalised(&self, point: usize, impulse: [f64; 2]) -> DVector<f64> {
        let state = self.state.as_ref();
        DVector::from_fn(M::LAYOUT.coordinates.len(), |j, _| {
            let along = M::State::<Series>::from_fn(|i| {
                let mut series = [0.0; crate::contact::ORDERS];
                (series[0], series[1]) = (state[i], if i == j { 1.0 } else { 0.0 });
                Series::new(series)
            });
            let points = M::points(&self.setup.scene.series, &along);
            let slope = |axis: usize| points.as_ref()[2 * point + axis].coefficient(1);
            slope(0) * impulse[0] + slope(1) * impulse[1]
        })
    }
}

/// The threads of a set, and the others.
pub(super) fn split<M: BarSystem>(set: ContactSet) -> (ContactSet, ContactSet) {
    let is_thread = |i: &usize| M::LAYOUT.contacts[*i].kind == ContactKind::Thread;
    let threads = set.iter().filter(is_thread).fold(ContactSet::EMPTY, ContactSet::with);
    (threads, ContactSet(set.0 & !threads.0))
}
