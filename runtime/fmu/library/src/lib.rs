//! The shared library in every functional mock-up unit that liftoff writes. It reads the
//! declaration in the unit's resources, derives its equations, interprets them, and runs them by
//! the same engine as every other program.
//!
//! - `exports`: the functions of FMI 3.0 in C; `c`: pointers of C, the only unsafe code beside the
//!   exports; `status`: what they return; `logger`: messages.
//! - `instance`: an instance and what may be called when; `settings`: what importers set before the
//!   start; `experiment`: from when to when.
//! - `place`: where a motion is, and what is read there.
//! - `motion`: a run of the engine in progress, for co-simulation.
//! - `exchange`: derivatives, event indicators and events, for model exchange.

mod c;
mod exchange;
mod experiment;
pub mod exports;
mod instance;
mod logger;
mod motion;
mod place;
mod settings;
mod status;
#[cfg(test)]
mod tests;
