//! What each thread does: take the next member, until none is left.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::lanes::{Group, is_smooth};
use super::{Ensemble, Member, MemberError};
use crate::model::{BarSystem, Phase, PhaseSeries, PhaseVisitor};
use crate::simulation::Simulation;

/// What threads share.
#[derive(Debug, Default)]
pub(super) struct Shared {
    /// The first member that no thread has taken.
    next: AtomicUsize,
    done: AtomicUsize,
    failed: AtomicUsize,
}

/// A member's number and its end.
type Numbered = (usize, Result<Member, MemberError>);

/// A thread's part of an ensemble.
pub(super) struct Worker<'a, 'b, F> {
    pub(super) ensemble: &'a Ensemble<'b, F>,
    pub(super) shared: &'a Shared,
    pub(super) results: Vec<Numbered>,
}

impl<F> Worker<'_, '_, F> {
    /// The next member, prepared.
    fn next<M: BarSystem>(&mut self) -> Option<(usize, Result<Simulation<M>, MemberError>)>
    where
        F: Fn(usize) -> Result<Simulation<M>, MemberError>,
    {
        let Ensemble { count, member, cancel, most_errors, .. } = self.ensemble;
        let cancelled = cancel.is_some_and(|flag| flag.load(Ordering::Relaxed));
        if cancelled || self.shared.failed.load(Ordering::Relaxed) >= *most_errors {
            return None;
        }
        let i = self.shared.next.fetch_add(1, Ordering::Relaxed);
        (i < *count).then(|| (i, member(i)))
    }

    fn finish(&mut self, i: usize, end: Result<Member, MemberError>) {
        if end.is_err() {
            self.shared.failed.fetch_add(1, Ordering::Relaxed);
        }
        let done = self.shared.done.fetch_add(1, Ordering::Relaxed) + 1;
        if let Some(told) = self.ensemble.progress {
            told(done);
        }
        self.results.push((i, end));
    }

    fn run_alone<M: BarSystem>(&mut self, i: usize, simulation: &Simulation<M>) {
        let end = Member::alone(simulation, &self.ensemble.outputs);
        self.finish(i, end);
    }
}

impl<M: BarSystem, F> PhaseVisitor<M, f64> for Worker<'_, '_, F>
where
    F: Fn(usize) -> Result<Simulation<M>, MemberError>,
{
    type Output = Vec<Numbered>;

    fn visit<const N: usize>(mut self, _: Phase<M, f64, N>) -> Self::Output {
        while let Some((i, member)) = self.next() {
            match member {
                Ok(simulation) => self.run_alone(i, &simulation),
                Err(error) => self.finish(i, Err(error)),
            }
        }
        self.results
    }

    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(mut self, phase: Phase<M, f64, N>) -> Self::Output {
        let outputs = &self.ensemble.outputs;
        // One for each tolerance, which decides the order.
        let mut groups: Vec<Group<M, Q, N>> = Vec::new();
        while let Some((i, member)) = self.next() {
            match member {
                Err(error) => self.finish(i, Err(error)),
                Ok(simulation) if !is_smooth(&simulation) => self.run_alone(i, &simulation),
                Ok(simulation) => {
                    let known = groups.iter().position(|group| group.tolerance == simulation.tolerance);
                    let at = known.unwrap_or_else(|| {
                        groups.push(Group::new(phase, &simulation));
                        groups.len() - 1
                    });
                    if let Err(error) = groups[at].enter(i, simulation) {
                        self.finish(i, Err(error));
                    }
                    while groups[at].is_full() {
                        groups[at].step(outputs, |i, end| self.finish(i, end));
                    }
                }
            }
        }
        for group in &mut groups {
            while !group.is_empty() {
                group.step(outputs, |i, end| self.finish(i, end));
            }
        }
        self.results
    }
}
