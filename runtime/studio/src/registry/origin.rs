//! Where the equations of a model come from: all else works with what is made here.

use core::marker::PhantomData;
use std::sync::{Arc, OnceLock};

use liftoff::model::{BarSystem, Layout};
use liftoff::scalar::{DoubleDouble, Dual4};
use liftoff::system::{LaneConstructor, Model, ModelOn, System, lanes, precise};
use liftoff_interpreter::Interpreted;

use crate::explain::interpreted;

/// A model without values of its parameters.
pub(super) trait Origin: Send + Sync {
    fn layout(&self) -> &'static Layout;
    /// The model with these values of its parameters.
    fn build(&self, parameters: &[f64]) -> Model;
    /// Its equations in double-double.
    fn precise(&self, parameters: &[f64]) -> Arc<dyn System<DoubleDouble>>;
    /// The model on values with their derivatives.
    fn varied(&self, parameters: &[Dual4]) -> Result<ModelOn<Dual4>, String>;
    /// How its motions are integrated side by side, if they can be.
    fn lanes(&self) -> Option<LaneConstructor>;
}

/// Derived and compiled.
pub(super) struct Compiled<M> {
    model: PhantomData<fn() -> M>,
    /// The same interpreted, once it has been asked for.
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
        Model::of(&M::from_parameters(parameters))
    }

    fn precise(&self, parameters: &[f64]) -> Arc<dyn System<DoubleDouble>> {
        precise::<M>(parameters)
    }

    /// Interpreted: compiled once more for these numbers, programs would be a fifth larger.
    fn varied(&self, parameters: &[Dual4]) -> Result<ModelOn<Dual4>, String> {
        let interpreted = self.interpreted.get_or_init(|| interpreted(M::LAYOUT));
        interpreted.as_ref().map(|model| model.varied(parameters)).map_err(Clone::clone)
    }

    fn lanes(&self) -> Option<LaneConstructor> {
        Some(lanes::<M>)
    }
}

/// Derived and interpreted.
impl Origin for Arc<Interpreted> {
    fn layout(&self) -> &'static Layout {
        Interpreted::layout(self)
    }

    fn build(&self, parameters: &[f64]) -> Model {
        self.model(parameters)
    }

    fn precise(&self, parameters: &[f64]) -> Arc<dyn System<DoubleDouble>> {
        Interpreted::precise(self, parameters)
    }

    fn varied(&self, parameters: &[Dual4]) -> Result<ModelOn<Dual4>, String> {
        Ok(Interpreted::varied(self, parameters))
    }

    fn lanes(&self) -> Option<LaneConstructor> {
        None
    }
}
