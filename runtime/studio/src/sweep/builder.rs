//! A sweep, built in one chain of calls.

use super::criterion::Criterion;
use super::journal::{Identity, recorded};
use super::setting::Assignment;
use super::team::Leader;
use super::{Observation, Sample, SweepError, Varied};
use crate::registry::Entry;
use crate::registry::Place;
use crate::run_spec::RunSpec;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

/// A sweep in preparation: many runs of one model over ranges of its parameters and starts.
pub struct Sweep<'a> {
    pub(super) model: &'a Entry,
    pub(super) spec: RunSpec,
    pub(super) varied: Vec<Varied>,
    pub(super) assignments: Vec<Assignment>,
    pub(super) observations: Vec<Observation>,
    pub(super) criterion: Criterion,
    pub(super) sample: Sample,
    pub(super) threads: Option<usize>,
    pub(super) cancel: Option<&'a AtomicBool>,
    pub(super) progress: Option<&'a (dyn Fn(usize, usize) + Sync)>,
    pub(super) team: Option<&'a Leader<'a>>,
    pub(super) journal: Option<PathBuf>,
    pub(super) fresh: bool,
}

impl<'a> Sweep<'a> {
    /// Of a model, with its default run.
    pub fn new(model: &'a Entry) -> Self {
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

    /// Varies a parameter, a coordinate or rate at the start, or a name that settings use: see
    /// [`Varied::parse`].
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

    /// Starts with the energy of a pose at rest: sets one of its coordinates, `name=formula` of the
    /// varied names.
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

    /// Reads this of each member: see [`Observation`]. For a threshold of a number
    /// `observation = value`.
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
