//! Every model of the catalogue against its closed form, or its published reference.
//!
//! Runs are made at tolerance 1e-13; what they are held to is 1e-10 unless a test says why not.

mod bodies;
mod chains;
mod falls;
mod friction;
mod impacts;
mod loads;
mod loops;
mod machines;
mod points;
mod sections;
mod statics;

use liftoff::prelude::*;

/// What runs are held to.
const CLOSE: f64 = 1e-10;

/// An output at a time.
fn evaluate_output(run: &Trajectory, output: &str, t: f64) -> f64 {
    run.value(&Output::parse(run.layout(), output).unwrap(), t)
}

/// A pose with these coordinates and rates.
fn pose(values: &[(&str, f64)]) -> Pose {
    values.iter().fold(Pose::nominal(), |pose, (name, value)| pose.with(name, *value))
}
