//! The models by name, with their types erased: what the command line and the report work with.

use crate::scene::{Blow, Scene, Setup, Values};
use crate::{
    AFrame, BouncingBall, BouncingBar, Chimney, DoublePendulum, FallingPair, FallingPairFull, FoldedChain,
    Ladder, Looping, Marble, NFourBar, Parallelogram, Pendulum, QuickReturn, RockingBlock, RodOnFloor,
    RodOnThree, SliderCrank, SpringPendulum, Squeezer, StruckChain, TopplingRod, Walker, Zigzag, ZigzagFull,
    ZigzagPublished, ZigzagThread,
};
use liftoff::model::Layout;
use liftoff::prelude::*;
use liftoff::{Extremum, Modes, RunCause, Statistics};
use std::error::Error;
use std::marker::PhantomData;

/// A bar system that can be run by the names of things.
pub trait Model: Sync {
    /// Its name on the command line.
    fn name(&self) -> &'static str;
    /// What it is, in a line.
    fn summary(&self) -> &'static str;
    /// The names of its coordinates, supports and points.
    fn layout(&self) -> &'static Layout;
    /// Its default run.
    fn setup(&self) -> Setup;
    /// Its contact sets, with the parameters of the default run.
    fn modes(&self) -> Result<Modes, Failure>;
    /// Runs it.
    fn run(&self, setup: &Setup) -> Result<Box<dyn Record>, Failure>;
}

/// A motion with its model's type erased.
pub trait Record {
    /// The names of coordinates, supports and points.
    fn layout(&self) -> &'static Layout;
    /// What happened, from start to end.
    fn events(&self) -> &[Event];
    /// Times of the start and of the end.
    fn interval(&self) -> [f64; 2];
    /// Ends of the integrator's steps.
    fn times(&self) -> Vec<f64>;
    /// Coordinates, then rates, at a time.
    fn state(&self, t: f64) -> Vec<f64>;
    /// An output as a function of time.
    fn output<'a>(&'a self, text: &str) -> Result<Box<dyn Fn(f64) -> f64 + 'a>, Failure>;
    /// Where an output is largest and smallest, inside each smooth piece.
    fn extrema(&self, text: &str) -> Result<Vec<Extremum>, Failure>;
    /// Steps and evaluations.
    fn statistics(&self) -> Statistics;
}

/// Why there is no motion, or only part of one.
#[derive(thiserror::Error)]
pub enum Failure {
    /// Something asked for that the model does not have, or that makes no sense.
    #[error("{0}")]
    Input(String),
    /// A run that stopped short.
    #[error("{reason}")]
    Run {
        /// Why.
        reason: String,
        /// The motion up to there.
        record: Box<dyn Record>,
    },
}

impl std::fmt::Debug for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self}")
    }
}

static MODELS: [&dyn Model; 28] = [
    &Entry::<FallingPair>(PhantomData),
    &Entry::<FallingPairFull>(PhantomData),
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

/// Every model.
pub fn models() -> &'static [&'static dyn Model] {
    &MODELS
}

/// The model of this name.
pub fn find(name: &str) -> Result<&'static dyn Model, Failure> {
    let found = MODELS.iter().find(|model| model.name() == name);
    found.copied().ok_or_else(|| {
        let known: Vec<_> = MODELS.iter().map(|model| model.name()).collect();
        Failure::Input(format!("no model `{name}`; there are {}", known.join(", ")))
    })
}

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
        if setup.stop_at_impacts {
            run = run.stop_at_impacts();
        }
        for condition in &setup.until {
            run = run.until(condition).map_err(input)?;
        }
        match run.run() {
            Ok(trajectory) => Ok(Box::new(trajectory)),
            Err(error) => Err(stopped(error)),
        }
    }
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

fn input(error: impl Error) -> Failure {
    Failure::Input(chain(&error))
}

fn stopped<M: BarSystem>(error: RunError<M>) -> Failure {
    match error.cause() {
        cause @ (RunCause::Tolerance(_) | RunCause::Limit(_) | RunCause::Start(_)) => input(cause),
        _ => Failure::Run { reason: chain(&error), record: Box::new(error.into_trajectory()) },
    }
}

/// An error with its sources in one line; a source that its error repeats is left out.
fn chain(error: &dyn Error) -> String {
    let mut line = error.to_string();
    let mut next = error.source();
    while let Some(source) = next {
        let text = source.to_string();
        if !line.contains(&text) {
            line = format!("{line}: {text}");
        }
        next = source.source();
    }
    line
}

impl<M: BarSystem> Record for Trajectory<M> {
    fn layout(&self) -> &'static Layout {
        M::LAYOUT
    }

    fn events(&self) -> &[Event] {
        self.events()
    }

    fn interval(&self) -> [f64; 2] {
        [self.start_time(), self.end_time()]
    }

    fn times(&self) -> Vec<f64> {
        self.times()
    }

    fn state(&self, t: f64) -> Vec<f64> {
        self.state(t)
    }

    fn output<'a>(&'a self, text: &str) -> Result<Box<dyn Fn(f64) -> f64 + 'a>, Failure> {
        let output = Output::parse::<M>(text).map_err(input)?;
        Ok(Box::new(move |t| self.value(&output, t)))
    }

    fn extrema(&self, text: &str) -> Result<Vec<Extremum>, Failure> {
        Ok(self.extrema(&Output::parse::<M>(text).map_err(input)?))
    }

    fn statistics(&self) -> Statistics {
        self.statistics()
    }
}
