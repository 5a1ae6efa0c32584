//! What is compiled of a registry for each type, and what stands for a type.

use super::entry::{model, simulation};
use super::origin::{Compiled, Origin};
use super::stopped;
use super::{Entry, MethodId, MotionError};
use crate::run_spec::{DefaultRun, RunSpec};
use core::marker::PhantomData;
use liftoff::Trajectory;
use liftoff::model::BarSystem;
use liftoff_verification::judgement::witness;
use std::sync::Arc;

/// Runs a model by a method.
pub fn run<M: BarSystem>(by: MethodId, spec: &RunSpec) -> Result<Trajectory, MotionError> {
    let model = model(&Compiled::<M>::default(), &spec.parameters)?;
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
    fn origin() -> Arc<dyn Origin> {
        Arc::new(Compiled::<M>::default())
    }
}

/// Found first by method resolution: models with a default run.
#[doc(hidden)]
pub trait WithDefaultRun {
    fn entry(&self) -> Entry;
}

impl<M: BarSystem + DefaultRun> WithDefaultRun for Kind<M> {
    fn entry(&self) -> Entry {
        Entry::new(Self::origin(), M::default_run())
    }
}

/// Found where [`WithDefaultRun`] is not: models without one.
#[doc(hidden)]
pub trait Bare {
    fn entry(&self) -> Entry;
}

impl<M: BarSystem> Bare for &Kind<M> {
    fn entry(&self) -> Entry {
        Entry::new(Kind::<M>::origin(), RunSpec::declared(M::LAYOUT))
    }
}
