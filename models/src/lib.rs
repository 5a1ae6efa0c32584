//! Bar systems declared with liftoff, one file each in `systems`; their default runs in `default_run`. Beside them what
//! only our own command does: `paper` reproduces the seed, `stability` has stiff and extreme scenes to be judged.

pub mod command;
pub mod paper;
pub mod stability;
pub mod systems;

mod default_run;
mod registry;

pub use registry::{models, with_default_run};
