//! Options that several commands share, and examples of them in the help.

pub mod examples;
pub mod run_args;
pub mod sampling;
pub mod states;
pub mod values;
