//! A model with what its run needs of the engine.

use super::parts::Parts;
use crate::model::BarSystem;
use crate::system::Model;

/// A model with what its run needs of the engine. That of a compiled model is known while it is
/// compiled: its program has no code of friction, say, if nothing rubs.
pub struct Scene {
    pub(super) model: Model,
    pub(super) parts: Parts,
}

impl<M: BarSystem> From<&M> for Scene {
    fn from(model: &M) -> Self {
        Self { model: Model::new(model), parts: const { Parts::from_layout(M::LAYOUT) } }
    }
}

impl From<Model> for Scene {
    fn from(model: Model) -> Self {
        Self { parts: Parts::from_layout(model.layout()), model }
    }
}
