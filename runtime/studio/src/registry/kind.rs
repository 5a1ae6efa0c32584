//! What of a registry is compiled for each model: all else works with the function pointers made here.

use super::entry::{model, simulation};
use super::stopped;
use super::{Entry, MethodId, MotionError};
use crate::run_spec::{DefaultRun, RunSpec};
use core::marker::PhantomData;
use liftoff::Trajectory;
use liftoff::model::{BarSystem, Layout};
use liftoff::scalar::DoubleDouble;
use liftoff::system::{LaneConstructor, lanes};
use liftoff::system::{Model, System, precise};
use liftoff_verification::judgement::witness;
use std::sync::Arc;

/// What is known of a model's type.
#[derive(Clone, Copy)]
pub(super) struct Compiled {
    pub(super) layout: &'static Layout,
    /// The model with these values of its parameters.
    pub(super) build: fn(&[f64]) -> Model,
    /// Its equations in double-double.
    pub(super) precise: fn(&[f64]) -> Arc<dyn System<DoubleDouble>>,
    pub(super) lanes: LaneConstructor,
}

/// The model of a type with these values of its parameters.
fn build<M: BarSystem>(parameters: &[f64]) -> Model {
    Model::of(&M::from_parameters(parameters))
}

/// Runs a model by a method.
pub fn run<M: BarSystem>(by: MethodId, spec: &RunSpec) -> Result<Trajectory, MotionError> {
    let model = model((M::LAYOUT, build::<M>), &spec.parameters)?;
    let simulation = simulation(model, spec)?.method(by);
    let run = simulation.run().map_err(stopped)?;
    witness(&run, &simulation.held());
    Ok(run)
}

/// A type, to tell whether it is a [`DefaultRun`].
#[doc(hidden)]
pub struct Kind<M>(PhantomData<M>);

impl<M> Kind<M> {
    #[expect(clippy::new_without_default, reason = "made by a macro only")]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<M: BarSystem> Kind<M> {
    const COMPILED: Compiled =
        Compiled { layout: M::LAYOUT, build: build::<M>, precise: precise::<M>, lanes: lanes::<M> };
}

/// Found first by method resolution: models with a default run.
#[doc(hidden)]
pub trait WithDefaultRun {
    fn entry(&self) -> Entry;
}

impl<M: BarSystem + DefaultRun> WithDefaultRun for Kind<M> {
    fn entry(&self) -> Entry {
        Entry::new(Self::COMPILED, M::default_run())
    }
}

/// Found where [`WithDefaultRun`] is not: models without one.
#[doc(hidden)]
pub trait Bare {
    fn entry(&self) -> Entry;
}

impl<M: BarSystem> Bare for &Kind<M> {
    fn entry(&self) -> Entry {
        Entry::new(Kind::<M>::COMPILED, RunSpec::default())
    }
}
