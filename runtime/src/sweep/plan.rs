//! A sweep with every name resolved.

use super::cell::{Outcome, Row};
use super::check::{check, itself, unused};
use super::member::Members;
use super::setting::Setting;
use super::{Observation, Sweep, SweepError};
use crate::catalog::Model;
use crate::scene::Setup;
use rayon::ThreadPoolBuilder;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// A sweep with every name resolved.
pub(super) struct Plan<'a> {
    model: &'a dyn Model,
    setup: &'a Setup,
    settings: Vec<Setting>,
    pub(super) observations: &'a [Observation],
    threads: Option<usize>,
    cancel: Option<&'a AtomicBool>,
}

impl<'a> Plan<'a> {
    /// Checks what can be checked before any member is run.
    pub(super) fn of(sweep: &'a Sweep<'_>) -> Result<Self, SweepError> {
        let Sweep { model, setup, varied, said, observations, threads, cancel, .. } = sweep;
        let layout = model.layout();
        let names: Vec<&str> = varied.iter().map(|varied| varied.name.as_str()).collect();
        if names.is_empty() {
            return Err(SweepError::Asked("nothing is varied: say vary name=low:high:count".into()));
        }
        if let Some(i) = (1..names.len()).find(|&i| names[..i].contains(&names[i])) {
            return Err(SweepError::Asked(format!("`{}` is varied twice", names[i])));
        }
        if observations.is_empty() {
            return Err(SweepError::Asked(
                "nothing is observed: say observe `first open`, `end phi`, …".into(),
            ));
        }
        let own = names.iter().filter_map(|name| itself(name, layout));
        let settings: Vec<Setting> = own
            .chain(said.iter().cloned())
            .map(|said| said.resolved(&names, layout))
            .collect::<Result<_, _>>()?;
        if let Some(idle) = (0..names.len()).find(|&i| !settings.iter().any(|setting| setting.depends_on(i)))
        {
            return Err(unused(names[idle], layout));
        }
        check(setup, layout)?;
        let plan = Self { model: *model, setup, settings, observations, threads: *threads, cancel: *cancel };
        plan.check_parameters(&vec![f64::NAN; names.len()])?;
        Ok(plan)
    }

    fn setup(&self, point: &[f64]) -> Setup {
        let mut setup = self.setup.clone();
        self.settings.iter().for_each(|setting| setting.apply(&mut setup, point));
        setup
    }

    fn check_parameters(&self, point: &[f64]) -> Result<(), SweepError> {
        let given = self.setup(point).parameters;
        let missing = |name: &&&str| !given.iter().any(|(known, _)| known == **name);
        match self.model.layout().parameters.iter().find(missing) {
            Some(name) => Err(SweepError::Asked(format!("parameter `{name}` is not given"))),
            None => Ok(()),
        }
    }

    /// Runs the members at these points and tells each outcome by its place among them, from any thread; stops where the
    /// sweep is stopped or telling fails.
    pub(super) fn run(
        &self,
        points: &(dyn Fn(usize) -> Vec<f64> + Sync),
        count: usize,
        told: &(dyn Fn(usize, Outcome) -> Result<(), SweepError> + Sync),
    ) -> Result<(), SweepError> {
        let is_cancelled = || self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed));
        let stop = AtomicBool::new(is_cancelled());
        let failed = Mutex::new(None);
        let members = Members {
            count,
            setup: &|i| self.setup(&points(i)),
            observations: self.observations,
            told: &|i, outcome| {
                if let Err(error) = told(i, outcome) {
                    failed.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                    stop.store(true, Ordering::Relaxed);
                }
                stop.fetch_or(is_cancelled(), Ordering::Relaxed);
            },
            cancel: &stop,
        };
        match self.threads {
            None => self.model.sweep(&members),
            Some(threads) => {
                let pool = ThreadPoolBuilder::new().num_threads(threads).build();
                let pool =
                    pool.map_err(|error| SweepError::Threads { threads, reason: error.to_string() })?;
                pool.install(|| self.model.sweep(&members));
            }
        }
        failed.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
    }

    /// The outcomes at these points, in their order; those that were not run are left out.
    pub(super) fn rows(&self, points: Vec<Vec<f64>>) -> Result<Vec<Row>, SweepError> {
        let rows = Mutex::new(Vec::new());
        let told = |member: usize, outcome| {
            let row = Row { member, point: points[member].clone(), outcome };
            rows.lock().unwrap_or_else(PoisonError::into_inner).push(row);
            Ok(())
        };
        self.run(&|i| points[i].clone(), points.len(), &told)?;
        let mut rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
        rows.sort_by_key(|row| row.member);
        Ok(rows)
    }
}
