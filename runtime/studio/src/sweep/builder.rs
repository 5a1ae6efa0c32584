//! A sweep, built in one chain of calls.

use super::boundary::{Boundary, boundaries};
use super::journal::{Identity, Journal, line, recorded};
use super::plan::Plan;
use super::sample::Points;
use super::setting::Assignment;
use super::team::Leader;
use super::threshold::{Criterion, Threshold, thresholds};
use super::{MemberResult, Observation, Outcome, Sample, SweepError, Table, Varied};
use crate::registry::Entry;
use crate::registry::Place;
use crate::run_spec::RunSpec;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};

/// A sweep in preparation: many runs of one model over ranges of its parameters and starts.
pub struct Sweep<'a> {
    pub(super) model: &'a Entry,
    pub(super) spec: RunSpec,
    pub(super) varied: Vec<Varied>,
    pub(super) assignments: Vec<Assignment>,
    pub(super) observations: Vec<Observation>,
    criterion: Criterion,
    pub(super) sample: Sample,
    pub(super) threads: Option<usize>,
    pub(super) cancel: Option<&'a AtomicBool>,
    pub(super) progress: Option<&'a (dyn Fn(usize, usize) + Sync)>,
    pub(super) team: Option<&'a Leader<'a>>,
    journal: Option<PathBuf>,
    pub(super) fresh: bool,
}

impl<'a> Sweep<'a> {
    /// Of a model, with its default run.
    pub fn of(model: &'a Entry) -> Self {
        Self {
            model,
            spec: model.default_run(),
            varied: Vec::new(),
            assignments: Vec::new(),
            observations: Vec::new(),
            criterion: Criterion::default(),
            sample: Sample::default(),
            threads: None,
            cancel: None,
            progress: None,
            team: None,
            journal: None,
            fresh: false,
        }
    }

    /// The same from another run.
    #[must_use]
    pub fn spec(mut self, spec: RunSpec) -> Self {
        self.spec = spec;
        self
    }

    /// Varies a parameter, a coordinate or rate at the start, or a name that settings use: see [`Varied::parse`].
    pub fn vary(mut self, text: &str) -> Result<Self, SweepError> {
        self.varied.push(Varied::parse(text)?);
        Ok(self)
    }

    /// Varies a name over values that no text has to hold.
    #[must_use]
    pub fn over(mut self, varied: Varied) -> Self {
        self.varied.push(varied);
        self
    }

    /// Sets a parameter: `name=formula` of the varied names.
    pub fn set(self, text: &str) -> Result<Self, SweepError> {
        self.assign(Place::Parameter, text)
    }

    /// Sets a coordinate or rate at the start: `name=formula` of the varied names.
    pub fn start(self, text: &str) -> Result<Self, SweepError> {
        self.assign(Place::Start, text)
    }

    /// Starts with the energy of a pose at rest: sets one of its coordinates, `name=formula` of the varied names.
    pub fn energy_of(self, text: &str) -> Result<Self, SweepError> {
        self.assign(Place::EnergyOf, text)
    }

    /// Takes a support away at a time: `support=formula` of the varied names.
    pub fn release(self, text: &str) -> Result<Self, SweepError> {
        self.assign(Place::Release, text)
    }

    fn assign(mut self, target: Place, text: &str) -> Result<Self, SweepError> {
        self.assignments.push(Assignment::parse(target, text)?);
        Ok(self)
    }

    /// Reads this of each member: see [`Observation`]. For a threshold of a number `observation = value`.
    pub fn observe(mut self, text: &str) -> Result<Self, SweepError> {
        let (observation, criterion) = Criterion::split(text)?;
        self.observations.push(Observation::parse(observation, self.model.layout())?);
        self.criterion = criterion;
        Ok(self)
    }

    /// Takes these points of the ranges.
    #[must_use]
    pub fn sample(mut self, sample: Sample) -> Self {
        self.sample = sample;
        self
    }

    /// Runs on so many threads; by default on all cores.
    #[must_use]
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = Some(threads);
        self
    }

    /// Begins no more members once this is true; the table has those that were done.
    #[must_use]
    pub fn cancel(mut self, flag: &'a AtomicBool) -> Self {
        self.cancel = Some(flag);
        self
    }

    /// Called with the number of members done and of all, from any thread.
    #[must_use]
    pub fn progress(mut self, on_progress: &'a (dyn Fn(usize, usize) + Sync)) -> Self {
        self.progress = Some(on_progress);
        self
    }

    /// Has members computed by all processes that this leads.
    #[must_use]
    pub fn team(mut self, leader: &'a Leader<'a>) -> Self {
        self.team = Some(leader);
        self
    }

    /// Keeps what is done in a file as it is done, and computes nothing that is there already.
    #[must_use]
    pub fn journal(mut self, path: impl Into<PathBuf>) -> Self {
        self.journal = Some(path.into());
        self
    }

    /// Writes the journal afresh, whatever was in it.
    #[must_use]
    pub fn fresh(mut self) -> Self {
        self.fresh = true;
        self
    }

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
        let ran = plan.run(&|i| points.at(pending[i]), pending.len(), &on_result);
        let (journal, done) = kept.into_inner().unwrap_or_else(PoisonError::into_inner);
        journal.map_or(Ok(()), |mut journal: Journal| journal.flush())?;
        ran?;
        let row = |(member, outcome)| MemberResult { member, point: points.at(member), outcome };
        let table = Table::new(self, done.into_iter().map(row).collect(), total, pending.len());
        Ok(Table { damaged, ..table })
    }

    /// The number of members; a sweep that cannot be run is refused.
    pub fn members(&self) -> Result<usize, SweepError> {
        self.prepared().map(|(_, points)| points.len())
    }

    /// The plan, and the points of all members.
    pub(super) fn prepared(&self) -> Result<(Plan<'_>, Points), SweepError> {
        let plan = Plan::of(self)?;
        if self.criterion.value().is_some() {
            return Err(SweepError::Invalid("a value to be reached is for thresholds".into()));
        }
        Ok((plan, self.sample.points(&self.varied)?))
    }

    /// Where what is observed changes along the one name that is varied: every change between neighbours of a coarse grid,
    /// narrowed down to this width by bisection.
    pub fn thresholds(&self, width: f64) -> Result<Vec<Threshold>, SweepError> {
        thresholds(&Plan::of(self)?, &self.varied, &self.criterion, width)
    }

    /// The curves in the plane of the two names that are varied across which what is observed changes, found on a coarse grid and
    /// followed by continuation, each point to within this part of the ranges.
    pub fn boundaries(&self, width: f64) -> Result<Vec<Boundary>, SweepError> {
        boundaries(&Plan::of(self)?, &self.varied, &self.criterion, width)
    }

    pub(super) fn is_grid(&self) -> bool {
        self.sample == Sample::Grid
    }

    pub(super) fn model(&self) -> &'a Entry {
        self.model
    }

    pub(super) fn identity(&self) -> Identity {
        let assignments = |target: Place| -> Vec<String> {
            let of = self.assignments.iter().filter(|assignment| assignment.target == target);
            of.map(|assignment| format!("{}={}", assignment.name, assignment.formula)).collect()
        };
        let mut identity = Identity::new();
        let mut insert = |word: &str, value: Value| identity.insert(word.to_owned(), value);
        insert("version", json!(env!("CARGO_PKG_VERSION")));
        insert("model", json!(self.model.name()));
        insert("declaration", json!(self.model.layout().declaration));
        insert("run", json!(format!("{:?}", self.spec)));
        insert("vary", json!(self.varied.iter().map(|varied| format!("{varied:?}")).collect::<Vec<_>>()));
        for target in [Place::Parameter, Place::Start, Place::EnergyOf, Place::Release] {
            insert(target.word(), json!(assignments(target)));
        }
        insert("observe", json!(self.observations.iter().map(Observation::text).collect::<Vec<_>>()));
        insert("sample", json!(self.sample.identity()));
        recorded(identity)
    }
}
