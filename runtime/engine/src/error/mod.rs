//! What can go wrong, by stage: the model, a name, a plan, the start, the run.

mod model;
mod name;
mod plan;
mod run;
mod start;
mod suggest;

pub use model::ModelError;
pub use name::NameError;
pub use plan::{ScheduleError, SupportError};
pub use run::{RunCause, RunError};
pub use start::StartError;
