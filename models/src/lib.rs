//! What only our own command does: `paper` reproduces the seed, `stability` has stiff and extreme
//! scenes to be judged. The bar systems are in `liftoff-systems`.

pub mod command;
pub mod paper;
pub mod stability;

pub use liftoff_systems as systems;
pub use liftoff_systems::models;
