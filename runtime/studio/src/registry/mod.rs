//! Models by name: what the command line and reports work with.

mod configuration;
mod crossed_outline;
mod dimension;
mod energy_rate;
mod entry;
mod kind;
mod line_violation;
mod models;
mod origin;
mod place;
mod quantity;
mod run_notes;
mod run_options;
pub mod run_spec;
mod start_notes;
mod unfolded;
mod units;

pub use configuration::Configuration;
pub use dimension::Dimension;
pub(crate) use dimension::{of_coordinate, per};
pub(crate) use entry::missing_parameter;
pub use entry::{Entry, kebab};
#[doc(hidden)]
pub use kind::{Bare, Kind, WithDefaultRun};
pub use liftoff::method::MethodId;
pub use liftoff_verification::motion_error::{MotionError, as_far, chain, input, stopped};
pub use liftoff_verification::precision::PrecisionSpec;
pub use line_violation::{LineViolation, line_violation};
pub use models::Models;
pub use place::Place;
pub use quantity::{Quantity, QuantityError};
pub use run_notes::run_notes;
pub use run_options::RunOptions;
pub use start_notes::{angle_notes, start_notes};
pub use unfolded::Unfolded;
pub use units::{Units, motion_columns};
