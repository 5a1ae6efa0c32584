//! Where the equations of a model come from: all else works with what is made here.

use core::marker::PhantomData;
use std::sync::{Arc, LazyLock, OnceLock};

use liftoff_core::model::{BarSystem, Layout};
use liftoff_core::system::{LaneConstructor, Model, lanes};
use liftoff_interpreter::Interpreted;

use crate::explain::interpreted;

/// A model without values of its parameters.
pub(super) trait Origin: Send + Sync {
    fn layout(&self) -> &'static Layout;
    /// The model with these values of its parameters.
    fn build(&self, parameters: &[f64]) -> Model;
    /// The model for the interpreter, which runs it on other numbers too.
    fn interpreted(&self) -> Result<Arc<Interpreted>, String>;
    /// How its motions are integrated side by side, if they can be.
    fn lanes(&self) -> Option<LaneConstructor>;
}

/// Derived and compiled, for doubles alone: on other numbers it is interpreted.
pub(super) struct Compiled<M> {
    model: PhantomData<fn() -> M>,
    interpreted: OnceLock<Result<Arc<Interpreted>, String>>,
}

impl<M> Default for Compiled<M> {
    fn default() -> Self {
        Self { model: PhantomData, interpreted: OnceLock::new() }
    }
}

impl<M: BarSystem> Origin for Compiled<M> {
    fn layout(&self) -> &'static Layout {
        M::LAYOUT
    }

    fn build(&self, parameters: &[f64]) -> Model {
        Model::new(&M::from_parameters(parameters))
    }

    fn interpreted(&self) -> Result<Arc<Interpreted>, String> {
        self.interpreted.get_or_init(|| interpreted(M::LAYOUT)).clone()
    }

    fn lanes(&self) -> Option<LaneConstructor> {
        Some(lanes::<M>)
    }
}

/// Derived and interpreted, when something of it is first needed.
pub(super) type Derived = LazyLock<Arc<Interpreted>, Box<dyn FnOnce() -> Arc<Interpreted> + Send>>;

impl Origin for Derived {
    fn layout(&self) -> &'static Layout {
        Interpreted::layout(self)
    }

    fn build(&self, parameters: &[f64]) -> Model {
        self.model(parameters)
    }

    fn interpreted(&self) -> Result<Arc<Interpreted>, String> {
        Ok(Arc::clone(self))
    }

    fn lanes(&self) -> Option<LaneConstructor> {
        None
    }
}
