//! The models themselves, and how one is run.

use super::failure::{input, stopped};
use super::{Asked, Failure, Integrator, Model, Record};
use crate::scene::{Blow, Scene, Setup, Values};
use crate::{
    AFrame, BouncingBall, BouncingBar, Chimney, DoublePendulum, FallingPair, FallingPairFull, FoldedChain,
    Ladder, Looping, Marble, NFourBar, NarrowGap, Parallelogram, Pendulum, QuickReturn, RockingBlock,
    RodOnFloor, RodOnThree, SliderCrank, SpringPendulum, Squeezer, StruckChain, TopplingRod, UnequalPendulum,
    Walker, Zigzag, ZigzagFull, ZigzagPublished, ZigzagThread,
};
use liftoff::model::Layout;
use liftoff::prelude::*;
use liftoff::{Measurement, Modes, Precision};
use std::marker::PhantomData;

/// Every model.
pub(super) static MODELS: [&dyn Model; 30] = [
    &Entry::<FallingPair>(PhantomData),
    &Entry::<FallingPairFull>(PhantomData),
    &Entry::<NarrowGap>(PhantomData),
    &Entry::<ZigzagPublished>(PhantomData),
    &Entry::<Zigzag>(PhantomData),
    &Entry::<ZigzagFull>(PhantomData),
    &Entry::<ZigzagThread>(PhantomData),
    &Entry::<Ladder>(PhantomData),
    &Entry::<RodOnFloor>(PhantomData),
    &Entry::<TopplingRod>(PhantomData),
    &Entry::<Pendulum>(PhantomData),
    &Entry::<Chimney>(PhantomData),
    &Entry::<BouncingBar>(PhantomData),
    &Entry::<RockingBlock>(PhantomData),
    &Entry::<RodOnThree>(PhantomData),
    &Entry::<AFrame>(PhantomData),
    &Entry::<DoublePendulum>(PhantomData),
    &Entry::<UnequalPendulum>(PhantomData),
    &Entry::<StruckChain>(PhantomData),
    &Entry::<FoldedChain>(PhantomData),
    &Entry::<Walker>(PhantomData),
    &Entry::<Parallelogram>(PhantomData),
    &Entry::<NFourBar>(PhantomData),
    &Entry::<SliderCrank>(PhantomData),
    &Entry::<QuickReturn>(PhantomData),
    &Entry::<Squeezer>(PhantomData),
    &Entry::<BouncingBall>(PhantomData),
    &Entry::<SpringPendulum>(PhantomData),
    &Entry::<Marble>(PhantomData),
    &Entry::<Looping>(PhantomData),
];

struct Entry<M>(PhantomData<fn() -> M>);

impl<M: Scene> Model for Entry<M> {
    fn name(&self) -> &'static str {
        M::NAME
    }

    fn summary(&self) -> &'static str {
        M::SUMMARY
    }

    fn layout(&self) -> &'static Layout {
        M::LAYOUT
    }

    fn setup(&self) -> Setup {
        M::setup()
    }

    fn modes(&self) -> Result<Modes, Failure> {
        liftoff::modes(&built::<M>(&M::setup().parameters)?).map_err(input)
    }

    fn run(&self, setup: &Setup) -> Result<Box<dyn Record>, Failure> {
        recorded(simulation::<M>(setup)?)
    }

    fn precision(&self, setup: &Setup, asked: &Asked) -> Result<Vec<Measurement>, Failure> {
        let mut precision = Precision::new(simulation::<M>(setup)?).measuring(asked.measuring);
        let rows = asked.methods.iter().map(|method| method.measure(&mut precision, &asked.tolerances));
        Ok(rows.flatten().collect())
    }
}

/// Runs a model by a method.
pub(crate) fn run<M: Scene>(by: Integrator, setup: &Setup) -> Result<Box<dyn Record>, Failure> {
    recorded(by.of(simulation::<M>(setup)?))
}

fn recorded<M: BarSystem>(simulation: Simulation<M>) -> Result<Box<dyn Record>, Failure> {
    match simulation.run() {
        Ok(trajectory) => Ok(Box::new(trajectory)),
        Err(error) => Err(stopped(error)),
    }
}

/// The run that a setup asks for.
fn simulation<M: Scene>(setup: &Setup) -> Result<Simulation<M>, Failure> {
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
        return Err(Failure::Input(format!("no parameter `{name}`; there are {}", names.join(", "))));
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
