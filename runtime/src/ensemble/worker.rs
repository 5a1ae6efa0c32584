//! What each thread does: take the next member, until none is left.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::lanes::{Group, is_smooth};
use super::{Ensemble, Member, MemberError, Motion};
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

/// A thread's part of an ensemble.
pub(super) struct Worker<'a, 'b, F> {
    pub(super) ensemble: &'a Ensemble<'b, F>,
    pub(super) shared: &'a Shared,
}

/// Who is told of ends.
pub(super) type Told<'a> = &'a (dyn Fn(usize, Result<Member, MemberError>) + Sync);

/// A thread's part of an ensemble whose members are told by their ends.
pub(super) struct Ends<'a, 'b, F> {
    pub(super) worker: Worker<'a, 'b, F>,
    pub(super) told: Told<'a>,
}

impl<F> Worker<'_, '_, F> {
    /// The next member, prepared.
    fn next<M: BarSystem>(&self) -> Option<(usize, Result<Simulation<M>, MemberError>)>
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

    fn count(&self, failed: bool) {
        if failed {
            self.shared.failed.fetch_add(1, Ordering::Relaxed);
        }
        let done = self.shared.done.fetch_add(1, Ordering::Relaxed) + 1;
        if let Some(told) = self.ensemble.progress {
            told(done);
        }
    }

    /// Runs members to their last, each motion told and let go.
    pub(super) fn run_motions<M: BarSystem>(&self, told: &(dyn Fn(usize, Motion<M>) + Sync))
    where
        F: Fn(usize) -> Result<Simulation<M>, MemberError>,
    {
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

impl<F> Ends<'_, '_, F> {
    fn finish(&self, i: usize, end: Result<Member, MemberError>) {
        let failed = end.is_err();
        (self.told)(i, end);
        self.worker.count(failed);
    }

    fn run_alone<M: BarSystem>(&self, i: usize, simulation: &Simulation<M>) {
        self.finish(i, Member::alone(simulation, &self.worker.ensemble.outputs));
    }
}

impl<M: BarSystem, F> PhaseVisitor<M, f64> for Ends<'_, '_, F>
where
    F: Fn(usize) -> Result<Simulation<M>, MemberError>,
{
    type Output = ();

    fn visit<const N: usize>(self, _: Phase<M, f64, N>) {
        while let Some((i, member)) = self.worker.next() {
            match member {
                Ok(simulation) => self.run_alone(i, &simulation),
                Err(error) => self.finish(i, Err(error)),
            }
        }
    }

    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(self, phase: Phase<M, f64, N>) {
        // Decided while compiling: models that never run in lanes have no code for them.
        if const { !M::LAYOUT.contacts.is_empty() || !M::LAYOUT.joints.is_empty() } {
            return self.visit(phase);
        }
        let outputs = &self.worker.ensemble.outputs;
        // One for each tolerance, which decides the order.
        let mut groups: Vec<Group<M, Q, N>> = Vec::new();
        while let Some((i, member)) = self.worker.next() {
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
    }
}
