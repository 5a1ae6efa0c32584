//! What a sweep is run for: a table, thresholds, boundaries.

use super::boundary::{Boundary, boundaries};
use super::journal::{Journal, line};
use super::plan::Plan;
use super::sample::Points;
use super::threshold::{Threshold, thresholds};
use super::{MemberResult, Outcome, Sweep, SweepError, Table};
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

impl Sweep<'_> {
    /// Runs all members that no journal has.
    pub fn run(&self) -> Result<Table, SweepError> {
        let (plan, points) = self.prepared()?;
        let total = points.len();
        let (mut journal, mut done, mut damaged) = (None, BTreeMap::new(), 0);
        if let Some(path) = &self.journal {
            let (opened, known) = Journal::open(path, &self.identity(), &self.observations, self.fresh)?;
            journal = Some(opened);
            damaged = known.damaged;
            done.extend(known.done.into_iter().filter(|(member, _)| *member < total));
        }
        let pending: Vec<usize> = (0..total).filter(|member| !done.contains_key(member)).collect();
        let seed = journal.as_ref().map(Journal::seed);
        let kept = Mutex::new((journal, done));
        let on_result = |i: usize, outcome: Outcome| {
            // Written before others have to wait.
            let line = seed.map(|seed| line(pending[i], &outcome, self.observations.len(), seed));
            let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
            let (journal, done) = &mut *kept;
            if let (Some(journal), Some(line)) = (journal, line) {
                journal.append(&line)?;
            }
            done.insert(pending[i], outcome);
            if let Some(on_progress) = self.progress {
                on_progress(done.len(), total);
            }
            Ok(())
        };
        let ran = plan.run(&|i| points.compute_point(pending[i]), pending.len(), &on_result);
        let (journal, done) = kept.into_inner().unwrap_or_else(PoisonError::into_inner);
        journal.map_or(Ok(()), |mut journal: Journal| journal.flush())?;
        ran?;
        let row = |(member, outcome)| MemberResult { member, point: points.compute_point(member), outcome };
        let table = Table::new(self, done.into_iter().map(row).collect(), total, pending.len());
        Ok(Table { damaged, ..table })
    }

    /// The number of members; a sweep that cannot be run is refused.
    pub fn members(&self) -> Result<usize, SweepError> {
        self.prepared().map(|(_, points)| points.len())
    }

    /// The plan, and the points of all members.
    pub(super) fn prepared(&self) -> Result<(Plan<'_>, Points), SweepError> {
        let plan = Plan::new(self)?;
        if self.criterion.value().is_some() {
            return Err(SweepError::Invalid("a value to reach needs a threshold".into()));
        }
        Ok((plan, self.sample.points(&self.varied)?))
    }

    /// Where what is observed changes along the one name that is varied: every change between
    /// neighbours of a coarse grid, narrowed down to this width by bisection.
    pub fn thresholds(&self, width: f64) -> Result<Vec<Threshold>, SweepError> {
        thresholds(&Plan::new(self)?, &self.varied, &self.criterion, width)
    }

    /// The curves in the plane of the two names that are varied across which what is observed
    /// changes, found on a coarse grid and followed by continuation, each point to within this part
    /// of the ranges.
    pub fn boundaries(&self, width: f64) -> Result<Vec<Boundary>, SweepError> {
        boundaries(&Plan::new(self)?, &self.varied, &self.criterion, width)
    }
}
