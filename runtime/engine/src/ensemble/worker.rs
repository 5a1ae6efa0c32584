//! What each thread does: take the next member, until none is left.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::lanes::{MemberGroup, is_smooth};
use super::{Ensemble, Member, MemberError, Motion};
use crate::simulation::Simulation;

/// What threads share.
#[derive(Debug, Default)]
pub(super) struct Shared {
    /// The first member that no thread has taken.
    next: AtomicUsize,
    done: AtomicUsize,
    failed: AtomicUsize,
}

/// A thread's part of an ensemble.
pub(super) struct Worker<'a, 'b, F> {
    pub(super) ensemble: &'a Ensemble<'b, F>,
    pub(super) shared: &'a Shared,
}

/// Called with the number and the result of each member.
pub(super) type MemberCallback<'a> = &'a (dyn Fn(usize, Result<Member, MemberError>) + Sync);

/// A thread's part of an ensemble of which only the results are reported.
pub(super) struct EndsWorker<'a, 'b, F> {
    pub(super) worker: Worker<'a, 'b, F>,
    pub(super) told: MemberCallback<'a>,
}

impl<F: Fn(usize) -> Result<Simulation, MemberError>> Worker<'_, '_, F> {
    /// The next member, prepared.
    fn next(&self) -> Option<(usize, Result<Simulation, MemberError>)> {
        let Ensemble { count, member, cancel, most_errors, .. } = self.ensemble;
        let cancelled = cancel.is_some_and(|flag| flag.load(Ordering::Relaxed));
        if cancelled || self.shared.failed.load(Ordering::Relaxed) >= *most_errors {
            return None;
        }
        let i = self.shared.next.fetch_add(1, Ordering::Relaxed);
        (i < *count).then(|| (i, member(i)))
    }

    fn count(&self, failed: bool) {
        if failed {
            self.shared.failed.fetch_add(1, Ordering::Relaxed);
        }
        let done = self.shared.done.fetch_add(1, Ordering::Relaxed) + 1;
        if let Some(told) = self.ensemble.progress {
            told(done);
        }
    }

    /// Runs members until none is left, and reports each motion.
    pub(super) fn run_motions(&self, told: &(dyn Fn(usize, Motion) + Sync)) {
        while let Some((i, member)) = self.next() {
            let motion = match member {
                Ok(simulation) => simulation.run().map_err(|error| error.cause().clone().into()),
                Err(error) => Err(error),
            };
            let failed = motion.is_err();
            told(i, motion);
            self.count(failed);
        }
    }
}

impl<F: Fn(usize) -> Result<Simulation, MemberError>> EndsWorker<'_, '_, F> {
    /// Runs members until none is left, side by side where possible, and reports each result.
    pub(super) fn run(&self) {
        // One for each tolerance, which decides the order.
        let mut groups: Vec<MemberGroup> = Vec::new();
        while let Some((i, member)) = self.worker.next() {
            match member {
                Err(error) => self.finish(i, Err(error)),
                Ok(simulation) => match self.group(&mut groups, &simulation) {
                    Some(group) => self.enter(group, i, simulation),
                    None => self.finish(i, Member::alone(&simulation, &self.worker.ensemble.outputs)),
                },
            }
        }
        for group in &mut groups {
            while !group.is_empty() {
                self.step(group);
            }
        }
    }

    /// The group that a member can enter, made where there is none yet; none where it runs alone.
    fn group<'g>(
        &self,
        groups: &'g mut Vec<MemberGroup>,
        simulation: &Simulation,
    ) -> Option<&'g mut MemberGroup> {
        let lanes = self.worker.ensemble.lanes.filter(|_| is_smooth(simulation))?;
        let known = groups.iter().position(|group| group.suits(simulation)).unwrap_or(groups.len());
        if known == groups.len() {
            groups.push(MemberGroup::new(lanes, simulation)?);
        }
        groups.get_mut(known)
    }

    fn enter(&self, group: &mut MemberGroup, i: usize, simulation: Simulation) {
        if let Err(error) = group.enter(i, simulation) {
            self.finish(i, Err(error));
        }
        while group.is_full() {
            self.step(group);
        }
    }

    fn step(&self, group: &mut MemberGroup) {
        group.step(&self.worker.ensemble.outputs, |i, end| self.finish(i, end));
    }

    fn finish(&self, i: usize, end: Result<Member, MemberError>) {
        let failed = end.is_err();
        (self.told)(i, end);
        self.worker.count(failed);
    }
}
