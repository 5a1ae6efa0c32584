//! wip
mod complementarity;
mod decision;
mod expansion;
mod impact;
mod linear;
mod motion;
mod place;
mod root;
pub mod scene;
pub mod tape;
pub use motion::{Action, Change, Event, Motion, NotJudged, Task};
use liftoff_core::scalar::DoubleDouble;
use scene::{Scene, SceneError};

/// A declared system with values of its parameters, to be judged by.
pub struct Judge {
    scene: Scene<DoubleDouble>,
}

impl Judge {
    /// wip
    pub fn of(declaration: &str, parameters: &[f64], coordinates: &[&str]) -> Result<Self, SceneError> {
        Ok(Self { scene: Scene::of(declaration, parameters, coordinates)? })
    }
    /// wip
    pub fn follow(&self, task: &Task) -> Motion {
        motion::follow(&self.scene, task)
    }
    /// wip
    pub fn contacts(&self) -> impl Iterator<Item = &str> {
        self.scene.contacts.iter().map(|contact| contact.name.as_str())
    }
}
