//! What is planned for a run: supports that vanish, threads that are cut, impulses; at a time or on
//! a condition.

use nalgebra::DVector;

use crate::context::without_rounding;
use crate::event::{EventKind, Note};
use crate::model::ContactSet;
use crate::simulation::RunCause;
use crate::simulation::schedule::{Action, Scheduled, Trigger};
use crate::simulation::snapshot::{Snapshot, split};
use crate::system::{TIME_ORDERS, TimeSeries};
use crate::trajectory::AppliedImpulse;

impl Snapshot<'_> {
    /// Does what is due at this time.
    pub(super) fn do_due(&mut self) -> Result<(), RunCause> {
        let due = |planned: &Scheduled| matches!(planned.when, Trigger::At(at) if at <= self.t);
        let due: Vec<usize> =
            (0..self.done.len()).filter(|&k| !self.done[k] && due(&self.setup.plan[k])).collect();
        self.execute(&due)
    }

    /// Removals first, then all impulses as one.
    pub(super) fn execute(&mut self, due: &[usize]) -> Result<(), RunCause> {
        let mut removed = ContactSet::EMPTY;
        let mut applied: Option<DVector<f64>> = None;
        let mut impulses = Vec::new();
        for &k in due {
            self.done[k] = true;
            match self.setup.plan[k].action {
                Action::Remove(contacts) => removed = removed.union(contacts),
                Action::Impulse { point, impulse } => {
                    let load = self.generalised(point, impulse);
                    self.transition.impulses.push(AppliedImpulse { t: self.t, point, impulse });
                    impulses.push((self.layout().points[point], impulse));
                    applied = Some(applied.map_or(load.clone(), |sum| sum + load));
                }
            }
        }
        let removed = removed.difference(self.contacts.absent());
        if !removed.is_empty() {
            self.remove(removed)?;
        }
        applied.map_or(Ok(()), |load| self.apply_impulse(load, Note::Impulses(impulses)))
    }

    fn remove(&mut self, due: ContactSet) -> Result<(), RunCause> {
        self.contacts.remove(due);
        let before = self.closed();
        self.go_on(self.question())?;
        let (threads, supports) = split(self.layout(), due);
        self.record_some(EventKind::Release, supports);
        self.record_some(EventKind::Cut, threads);
        self.record_changes(before);
        Ok(())
    }

    /// Q = (∂r/∂q)ᵀ p for the impulse p at a point: the derivative of its position by each
    /// coordinate. What the rounding of the position makes of p is no part of it.
    fn generalised(&self, point: usize, impulse: [f64; 2]) -> DVector<f64> {
        let (model, layout) = (&self.setup.context.model, self.layout());
        let mut points = vec![TimeSeries::constant(0.0); 2 * layout.points.len()];
        let scales = &self.setup.context.scales;
        let lever = |j: usize| scales.length / scales.coordinate(&layout.coordinates[j]);
        let size = impulse[0].hypot(impulse[1]);
        let known = |j: usize, load: f64| without_rounding(load, size * lever(j));
        DVector::from_fn(layout.coordinates.len(), |j, _| {
            let entry = |i: usize| {
                let mut series = [0.0; TIME_ORDERS];
                (series[0], series[1]) = (self.state[i], if i == j { 1.0 } else { 0.0 });
                TimeSeries::new(series)
            };
            let along: Vec<TimeSeries> = (0..self.state.len()).map(entry).collect();
            model.series.points(&along, &mut points);
            let derivative = |axis: usize| points[2 * point + axis].coefficient(1);
            known(j, derivative(0) * impulse[0] + derivative(1) * impulse[1])
        })
    }
}
