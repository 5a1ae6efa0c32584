//! A model with what its run needs.

use crate::contact::Laws;
use crate::model::BarSystem;
use crate::system::Model;

/// A model with the laws that its contacts name. Those of a compiled model are known while it is
/// compiled: its program has no code of others.
pub struct Scene {
    pub(super) model: Model,
    pub(super) laws: &'static Laws,
}

impl<M: BarSystem> From<&M> for Scene {
    fn from(model: &M) -> Self {
        Self { model: Model::of(model), laws: const { Laws::from_layout(M::LAYOUT) } }
    }
}

impl From<Model> for Scene {
    fn from(model: Model) -> Self {
        Self { laws: Laws::from_layout(model.layout()), model }
    }
}
