//! What is compiled of a registry for each type, and what stands for a type.

use super::Entry;
use super::origin::{Compiled, Origin};
use crate::run_spec::{DefaultRun, RunSpec};
use core::marker::PhantomData;
use liftoff_core::model::BarSystem;
use std::sync::Arc;

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
