//! The default run of every model, by name.

mod bars;
mod bodies;
mod chains;
mod friction;
mod loops;
mod points;
mod seed;

use liftoff_studio::RunSpec;

/// A model's name, and the function that creates its default run.
pub type DefaultRun = (&'static str, fn() -> RunSpec);

/// One mass, one length, and gravity in SI units.
const ONE: [(&str, f64); 3] = [("m", 1.0), ("l", 1.0), ("g", 9.81)];

const GROUPS: [&[DefaultRun]; 7] =
    [seed::RUNS, bars::RUNS, chains::RUNS, loops::RUNS, points::RUNS, friction::RUNS, bodies::RUNS];

/// Every model, with the function that creates its default run.
pub fn default_runs() -> impl Iterator<Item = DefaultRun> {
    GROUPS.into_iter().flatten().copied()
}
