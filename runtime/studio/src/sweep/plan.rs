//! A sweep with every name resolved.

use super::cell::{MemberResult, Outcome};
use super::check::{check, itself, unused};
use super::condition::{Inserted, amid};
use super::journal::Identity;
use super::member::Members;
use super::setting::Setting;
use super::team::{Found, Given, LIMIT, Leader, Work};
use super::{Observation, Sweep, SweepError};
use crate::registry::{Entry, Place, missing_parameter};
use crate::run_spec::RunSpec;
use liftoff::__private::expression::si_unit::SiUnit;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// A sweep with every name resolved.
pub(super) struct Plan<'a> {
    pub(super) model: &'a Entry,
    spec: &'a RunSpec,
    settings: Vec<Setting>,
    /// Varied names in conditions.
    inserted: Inserted,
    pub(super) observations: &'a [Observation],
    threads: Option<usize>,
    cancel: Option<&'a AtomicBool>,
    /// The leader of several processes, and what identifies the sweep to them.
    team: Option<(&'a Leader<'a>, Identity)>,
}

impl<'a> Plan<'a> {
    /// Checks what can be checked before any member is run.
    pub(super) fn new(sweep: &'a Sweep<'_>) -> Result<Self, SweepError> {
        let Sweep { model, spec, varied, assignments, observations, threads, cancel, .. } = sweep;
        let layout = model.layout();
        let names: Vec<&str> = varied.iter().map(|varied| varied.name.as_str()).collect();
        if names.is_empty() {
            return Err(SweepError::Invalid("nothing is varied: add `--vary NAME=LOW:HIGH:COUNT`".into()));
        }
        if let Some(i) = (1..names.len()).find(|&i| names[..i].contains(&names[i])) {
            return Err(SweepError::Invalid(format!("`{}` is varied twice", names[i])));
        }
        if observations.is_empty() {
            return Err(SweepError::Invalid("nothing is observed: add `--observe 'first open'`".into()));
        }
        let assigned =
            |place: Place, name: &str| assignments.iter().any(|a| a.target == place && a.name == name);
        for place in [Place::Parameter, Place::Start, Place::EnergyOf, Place::Release] {
            let of = assignments.iter().filter(|assignment| assignment.target == place);
            let names: Vec<&str> = of.map(|assignment| assignment.name.as_str()).collect();
            place.check_names(&names).map_err(SweepError::Invalid)?;
        }
        for varied in varied {
            let Some(own) = itself(&varied.name, layout) else { continue };
            let check = |unit: &SiUnit| own.target.check_unit(layout, &varied.name, Some(*unit));
            varied.units.iter().try_for_each(check).map_err(SweepError::Invalid)?;
        }
        // What is set by a formula does not follow its own name besides.
        let own = names.iter().filter_map(|name| itself(name, layout));
        let own = own.filter(|own| !assigned(own.target, &own.name));
        let settings: Vec<Setting> = own
            .chain(assignments.iter().cloned())
            .map(|assignment| assignment.resolved(&names, layout))
            .collect::<Result<_, _>>()?;
        let inserted = Inserted::new(&names, layout);
        let is_used = |i: usize| settings.iter().any(|s| s.depends_on(i)) || inserted.uses(spec, i);
        if let Some(idle) = (0..names.len()).find(|&i| !is_used(i)) {
            return Err(unused(names[idle], layout));
        }
        let mut amidst = spec.clone();
        inserted.apply(&mut amidst, &amid(varied));
        check(&amidst, layout)?;
        let plan = Self {
            model: *model,
            spec,
            settings,
            inserted,
            observations,
            threads: *threads,
            cancel: *cancel,
            team: sweep.team.map(|leader| (leader, sweep.identity())),
        };
        plan.check_parameters(&vec![f64::NAN; names.len()])?;
        Ok(plan)
    }

    fn spec(&self, point: &[f64]) -> RunSpec {
        let mut spec = self.spec.clone();
        self.settings.iter().for_each(|setting| setting.apply(&mut spec, point));
        self.inserted.apply(&mut spec, point);
        spec
    }

    fn check_parameters(&self, point: &[f64]) -> Result<(), SweepError> {
        let given = self.spec(point).parameters;
        let missing = |name: &&&str| !given.iter().any(|(known, _)| known == **name);
        match self.model.layout().parameters.iter().find(missing) {
            Some(name) => Err(SweepError::Invalid(missing_parameter(name))),
            None => Ok(()),
        }
    }

    /// Runs the members at these points and passes each outcome on with its index among them, from
    /// any thread; stops where the sweep is stopped or telling fails.
    pub(super) fn run(
        &self,
        points: &(dyn Fn(usize) -> Vec<f64> + Sync),
        count: usize,
        on_result: &(dyn Fn(usize, Outcome) -> Result<(), SweepError> + Sync),
    ) -> Result<(), SweepError> {
        let stop = AtomicBool::new(self.is_cancelled());
        let failed = Mutex::new(None);
        let note = |(i, outcome): Found| {
            if let Err(error) = on_result(i, outcome) {
                failed.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                stop.store(true, Ordering::Relaxed);
            }
            stop.fetch_or(self.is_cancelled(), Ordering::Relaxed);
        };
        let pool = self.pool()?;
        match &self.team {
            None => self.compute(pool.as_ref(), (points, count), &note, &stop),
            Some((leader, identity)) => leader.share(&Work {
                identity,
                observations: self.observations,
                count,
                point: points,
                compute: &|members| self.batch(pool.as_ref(), members),
                note: &note,
                is_cancelled: &|| self.is_cancelled(),
                stop: &stop,
            })?,
        }
        failed.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
    }

    /// What came of these members; of those that have not been begun within the time of a batch
    /// nothing.
    pub(super) fn batch(&self, pool: Option<&ThreadPool>, members: &[Given]) -> Vec<Found> {
        let (begun, stop) = (Instant::now(), AtomicBool::new(self.is_cancelled()));
        let found = Mutex::new(Vec::with_capacity(members.len()));
        let note = |(i, outcome): Found| {
            found.lock().unwrap_or_else(PoisonError::into_inner).push((members[i].0, outcome));
            stop.fetch_or(self.is_cancelled() || begun.elapsed() > LIMIT, Ordering::Relaxed);
        };
        self.compute(pool, (&|i| members[i].1.clone(), members.len()), &note, &stop);
        found.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs so many members at these points, until it is to stop.
    fn compute(
        &self,
        pool: Option<&ThreadPool>,
        (points, count): (&(dyn Fn(usize) -> Vec<f64> + Sync), usize),
        note: &(dyn Fn(Found) + Sync),
        stop: &AtomicBool,
    ) {
        let members = Members {
            count,
            spec: &|i| self.spec(&points(i)),
            observations: self.observations,
            on_result: &|i, outcome| note((i, outcome)),
            cancel: stop,
        };
        match pool {
            None => members.run(self.model),
            Some(pool) => pool.install(|| members.run(self.model)),
        }
    }

    /// The threads that were asked for; by default those of the process.
    pub(super) fn pool(&self) -> Result<Option<ThreadPool>, SweepError> {
        let pool = |threads| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build();
            pool.map_err(|error| SweepError::Threads { threads, reason: error.to_string() })
        };
        self.threads.map(pool).transpose()
    }

    pub(super) fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    /// The outcomes at these points, in their order; those that were not run are left out.
    pub(super) fn rows(&self, points: Vec<Vec<f64>>) -> Result<Vec<MemberResult>, SweepError> {
        let rows = Mutex::new(Vec::new());
        let on_result = |member: usize, outcome| {
            let row = MemberResult { member, point: points[member].clone(), outcome };
            rows.lock().unwrap_or_else(PoisonError::into_inner).push(row);
            Ok(())
        };
        self.run(&|i| points[i].clone(), points.len(), &on_result)?;
        let mut rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
        rows.sort_by_key(|row| row.member);
        Ok(rows)
    }
}
