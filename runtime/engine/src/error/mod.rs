//! Mistakes in what is asked for: a name, an expression, the model, a plan. What may fail later has
//! its error where it fails.

mod model;
mod name;
mod output;
mod plan;
mod suggest;

pub use model::ModelError;
pub use name::NameError;
pub use output::OutputError;
pub(crate) use output::{LONGEST, MOST_OPERATORS};
pub use plan::{ScheduleError, SupportError};
