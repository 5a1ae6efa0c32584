//! Options that several commands share, and examples of them in the help.

pub mod budget;
pub mod clock;
pub mod columnar_files;
pub mod defaults;
pub mod examples;
pub mod files;
pub mod length;
pub mod pose_args;
pub mod run_args;
pub mod samples;
pub mod sampling;
pub mod sliders;
pub mod values;
