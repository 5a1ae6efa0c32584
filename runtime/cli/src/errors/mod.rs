//! Error messages and exit codes.

mod command_error;
pub mod interrupted;
pub mod parse_error;

pub use command_error::CommandError;
pub use interrupted::interrupted;
