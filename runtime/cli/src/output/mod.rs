//! What is written: to the terminal in colours where it has them, as JSON, as CSV, and how far a command has come.

pub mod analysis;
pub mod file;
pub mod fit;
pub mod json;
pub mod motion_file;
pub mod notes;
pub mod optimum;
pub mod orbit;
pub mod print;
pub mod progress;
pub mod sensitivity;
pub mod style;

pub use print::print;
