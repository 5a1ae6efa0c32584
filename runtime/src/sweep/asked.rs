//! What to sweep, said in one chain of calls.

use super::journal::{Identity, Journal};
use super::plan::Plan;
use super::setting::{Place, Said};
use super::threshold::{Criterion, Threshold, thresholds};
use super::{Observation, Outcome, Row, Sample, SweepError, Table, Varied};
use crate::catalog::Model;
use crate::scene::Setup;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};

/// A sweep in preparation: many runs of one model over ranges of its parameters and starts.
pub struct Sweep<'a> {
    pub(super) model: &'a dyn Model,
    pub(super) setup: Setup,
    pub(super) varied: Vec<Varied>,
    pub(super) said: Vec<Said>,
    pub(super) observations: Vec<Observation>,
    criterion: Criterion,
    sample: Sample,
    pub(super) threads: Option<usize>,
    pub(super) cancel: Option<&'a AtomicBool>,
    progress: Option<&'a (dyn Fn(usize, usize) + Sync)>,
    journal: Option<PathBuf>,
    fresh: bool,
}

impl<'a> Sweep<'a> {
    /// Of a model, with its default run.
    pub fn of(model: &'a dyn Model) -> Self {
        Self {
            model,
            setup: model.setup(),
            varied: Vec::new(),
            said: Vec::new(),
            observations: Vec::new(),
            criterion: Criterion::default(),
            sample: Sample::default(),
            threads: None,
            cancel: None,
            progress: None,
            journal: None,
            fresh: false,
        }
    }

    /// The same from another run.
    #[must_use]
    pub fn setup(mut self, setup: Setup) -> Self {
        self.setup = setup;
        self
    }

    /// Varies a parameter, a coordinate or rate at the start, or a name that settings use: see [`Varied::parse`].
    pub fn vary(mut self, text: &str) -> Result<Self, SweepError> {
        self.varied.push(Varied::parse(text)?);
        Ok(self)
    }

    /// Sets a parameter: `name=formula` of the varied names.
    pub fn set(self, text: &str) -> Result<Self, SweepError> {
        self.say(Place::Parameter, text)
    }

    /// Sets a coordinate or rate at the start: `name=formula` of the varied names.
    pub fn start(self, text: &str) -> Result<Self, SweepError> {
        self.say(Place::Start, text)
    }

    /// Sets a coordinate of the pose on whose energy level, at rest, the motion starts.
    pub fn energy_of(self, text: &str) -> Result<Self, SweepError> {
        self.say(Place::EnergyOf, text)
    }

    fn say(mut self, place: Place, text: &str) -> Result<Self, SweepError> {
        self.said.push(Said::parse(place, text)?);
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

    /// Is told how many members are done of how many, from any thread.
    #[must_use]
    pub fn progress(mut self, told: &'a (dyn Fn(usize, usize) + Sync)) -> Self {
        self.progress = Some(told);
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
        let plan = Plan::of(self)?;
        if self.criterion.value().is_some() {
            return Err(SweepError::Asked("a value to be reached is for thresholds".into()));
        }
        let points = self.sample.points(&self.varied)?;
        let total = points.len();
        let (mut journal, mut done) = (None, BTreeMap::new());
        if let Some(path) = &self.journal {
            let (opened, known) = Journal::open(path, &self.identity(), &self.observations, self.fresh)?;
            journal = Some(opened);
            done.extend(known.into_iter().filter(|(member, _)| *member < total));
        }
        let pending: Vec<usize> = (0..total).filter(|member| !done.contains_key(member)).collect();
        let kept = Mutex::new((journal, done));
        let told = |i: usize, outcome: Outcome| {
            let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
            let (journal, done) = &mut *kept;
            if let Some(journal) = journal {
                journal.note(pending[i], &outcome, self.observations.len())?;
            }
            done.insert(pending[i], outcome);
            if let Some(told) = self.progress {
                told(done.len(), total);
            }
            Ok(())
        };
        let ran = plan.run(&|i| points.at(pending[i]), pending.len(), &told);
        let (journal, done) = kept.into_inner().unwrap_or_else(PoisonError::into_inner);
        journal.map_or(Ok(()), Journal::close)?;
        ran?;
        let row = |(member, outcome)| Row { member, point: points.at(member), outcome };
        Ok(Table::new(self, done.into_iter().map(row).collect(), total, pending.len()))
    }

    /// Where what is observed changes along the one name that is varied: every change between neighbours of a coarse grid,
    /// narrowed down to this width by bisection.
    pub fn thresholds(&self, width: f64) -> Result<Vec<Threshold>, SweepError> {
        thresholds(&Plan::of(self)?, &self.varied, &self.criterion, width)
    }

    pub(super) fn is_grid(&self) -> bool {
        self.sample == Sample::Grid
    }

    pub(super) fn model(&self) -> &'a dyn Model {
        self.model
    }

    fn identity(&self) -> Identity {
        let said = |place: Place| -> Vec<String> {
            let of = self.said.iter().filter(|said| said.place == place);
            of.map(|said| format!("{}={}", said.name, said.formula)).collect()
        };
        let mut identity = Identity::new();
        let mut say = |word: &str, value: Value| identity.insert(word.to_owned(), value);
        say("version", json!(env!("CARGO_PKG_VERSION")));
        say("model", json!(self.model.name()));
        say("declaration", json!(self.model.layout().declaration));
        say("run", json!(format!("{:?}", self.setup)));
        say("vary", json!(self.varied.iter().map(|varied| format!("{varied:?}")).collect::<Vec<_>>()));
        for place in [Place::Parameter, Place::Start, Place::EnergyOf] {
            say(place.word(), json!(said(place)));
        }
        say("observe", json!(self.observations.iter().map(Observation::text).collect::<Vec<_>>()));
        say("sample", json!(self.sample.identity()));
        identity
    }
}
