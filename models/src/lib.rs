//! What only our own command does: `paper` reproduces the seed, `stability` has stiff and extreme
//! scenes to be judged. The bar systems are in `liftoff-systems`.

pub mod command;
pub mod paper;
pub mod stability;

#[cfg(feature = "compiled")]
pub use liftoff_compiled::models;
pub use liftoff_systems as systems;
#[cfg(not(feature = "compiled"))]
pub use liftoff_systems::models;
