//! How a model is run.

use super::covariance::{self, Dimension};
use super::failure::{input, stopped};
use super::power::power;
use super::{Asked, Failure, Integrator, Model, Record, Still, Way};
use crate::model::{BarSystem, ContactSet, Layout};
use crate::moment::{Scene, state_at};
use crate::names::{kebab, unknown};
use crate::scales::Scales;
use crate::scene::{Blow, Setup, Values};
use crate::{Measurement, Modes, Output, Pose, Precision, Simulation};
use core::marker::PhantomData;
use core::ops::ControlFlow;

/// A model with its default run.
pub struct Entry<M> {
    name: String,
    setup: Setup,
    model: PhantomData<fn() -> M>,
}

impl<M: BarSystem> Entry<M> {
    pub(super) fn new(setup: Setup) -> Self {
        Self { name: kebab(M::LAYOUT.name), setup, model: PhantomData }
    }
}

impl<M: BarSystem> Model for Entry<M> {
    fn name(&self) -> &str {
        &self.name
    }

    fn summary(&self) -> &str {
        M::LAYOUT.summary
    }

    fn layout(&self) -> &'static Layout {
        M::LAYOUT
    }

    fn setup(&self) -> Setup {
        self.setup.clone()
    }

    fn still(&self, setup: &Setup) -> Result<Still, Failure> {
        Ok(Still::started(&simulation::<M>(setup)?))
    }

    fn modes(&self, setup: &Setup) -> Result<Modes, Failure> {
        crate::modes(&built::<M>(&setup.parameters)?).map_err(input)
    }

    fn check(&self, output: &str) -> Result<(), Failure> {
        Output::parse::<M>(output).map(drop).map_err(input)
    }

    fn run_by(&self, way: Way, setup: &Setup) -> Result<Box<dyn Record>, Failure> {
        recorded(way.of(simulation::<M>(setup)?))
    }

    fn measure(
        &self,
        setup: &Setup,
        asked: &Asked,
        go_on: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Vec<Measurement>, Failure> {
        let mut precision = Precision::new(simulation::<M>(setup)?).measuring(asked.measuring);
        let mut rows = Vec::new();
        for (method, tolerance) in
            asked.methods.iter().flat_map(|m| asked.tolerances.iter().map(move |t| (m, t)))
        {
            if go_on().is_break() {
                break;
            }
            rows.extend(method.measure(&mut precision, &[*tolerance]));
        }
        Ok(rows)
    }

    fn units(&self, setup: &Setup) -> Result<[f64; 3], Failure> {
        let Scales { length, time, mass, .. } = simulation::<M>(setup)?.scene.scales;
        Ok([length, time, mass])
    }

    fn dimensions(&self, setup: &Setup) -> Option<Vec<Dimension>> {
        let model = built::<M>(&setup.parameters).ok()?;
        covariance::dimensions::<M>(model.parameters().as_ref())
    }

    fn power(&self, setup: &Setup, set: ContactSet, t: f64, state: &[f64]) -> Result<f64, Failure> {
        let simulation = simulation::<M>(setup)?;
        let Scene { parameters, scales, .. } = &*simulation.scene;
        Ok(power::<M>(parameters, set, &state_at::<M>(state, t), scales.time))
    }

    #[cfg(feature = "sweep")]
    fn sweep(&self, members: &crate::sweep::Members<'_>) {
        members.run::<M>();
    }
}

/// Runs a model by a method.
pub fn run<M: BarSystem>(by: Integrator, setup: &Setup) -> Result<Box<dyn Record>, Failure> {
    recorded(by.of(simulation::<M>(setup)?))
}

fn recorded<M: BarSystem>(simulation: Simulation<M>) -> Result<Box<dyn Record>, Failure> {
    match simulation.run() {
        Ok(trajectory) => Ok(Box::new(trajectory)),
        Err(error) => Err(stopped(error)),
    }
}

/// The run that a setup asks for.
pub(crate) fn simulation<M: BarSystem>(setup: &Setup) -> Result<Simulation<M>, Failure> {
    let model = built::<M>(&setup.parameters)?;
    let mut run = Simulation::new(&model)
        .map_err(input)?
        .tolerance(setup.tolerance)
        .start(pose(&setup.start))
        .map_err(input)?;
    if !setup.energy_of.is_empty() {
        run = run.on_energy_of(pose(&setup.energy_of)).map_err(input)?;
    }
    for support in &setup.hold {
        run = run.hold(support).map_err(input)?;
    }
    for (support, at) in &setup.release {
        run = run.release(support, *at).map_err(input)?;
    }
    for (thread, condition) in &setup.cut {
        run = run.cut(thread, condition).map_err(input)?;
    }
    for Blow { point, impulse, at } in &setup.impulses {
        run = run.impulse(point, *impulse, *at).map_err(input)?;
    }
    if let Some(limit) = setup.limit {
        run = run.limit(limit);
    }
    if setup.stop_at_impacts {
        run = run.stop_at_impacts();
    }
    for condition in &setup.until {
        run = run.until(condition).map_err(input)?;
    }
    Ok(run)
}

fn built<M: BarSystem>(parameters: &Values) -> Result<M, Failure> {
    let names = M::LAYOUT.parameters;
    let stranger = parameters.iter().find(|(name, _)| !names.contains(&name.as_str()));
    if let Some((name, _)) = stranger {
        return Err(input(unknown("parameter", name, names.iter().copied())));
    }
    let value =
        |name: &&str| parameters.iter().rev().find(|(given, _)| given == name).map(|(_, value)| *value);
    let missing = |name: &&str| Failure::Input(format!("parameter `{name}` is not given"));
    let values: Result<Vec<f64>, _> =
        names.iter().map(|name| value(name).ok_or_else(|| missing(name))).collect();
    Ok(M::from_parameters(&values?))
}

fn pose(values: &Values) -> Pose {
    values.iter().fold(Pose::nominal(), |pose, (name, value)| pose.with(name, *value))
}
