//! A run in one call, and what it reads.

use liftoff::prelude::*;

/// A run at tolerance 1e-13, made ready to be changed before it starts.
pub fn prepared<M: BarSystem>(model: &M, start: Pose, until: &[&str]) -> Simulation {
    let simulation = Simulation::new(model).unwrap().tolerance(1e-13).start(start).unwrap();
    until.iter().fold(simulation, |s, condition| s.until(condition).unwrap())
}

/// A run at tolerance 1e-13.
pub fn run<M: BarSystem>(model: &M, start: Pose, until: &[&str]) -> Trajectory {
    prepared(model, start, until).run().unwrap()
}

/// What happened, and to which supports.
pub fn kinds(run: &Trajectory) -> Vec<(EventKind, Vec<&'static str>)> {
    run.events().iter().map(|e| (e.kind, e.supports.clone())).collect()
}
