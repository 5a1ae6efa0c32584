//! Ten thousand double pendula for ten seconds, on one thread and on all.

use std::time::Instant;

use liftoff::ensemble::{Ensemble, Member, MemberError};
use liftoff::prelude::*;
use liftoff_compiled::DoublePendulum;
use liftoff_core::system::lanes;
use serde_json::{Value, json};

use crate::Result;

const MEMBERS: usize = 10_000;
const TIME: f64 = 10.0;
const TOLERANCE: f64 = 1e-9;

/// Every so many members the error is measured.
const SAMPLE: usize = 100;

/// A row for every number of threads.
pub fn rows() -> Result<Vec<Value>> {
    let all = std::thread::available_parallelism()?.get();
    let mut counts = vec![1, all];
    counts.dedup();
    counts.into_iter().map(row).collect()
}

fn row(threads: usize) -> Result<Value> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let (mut least, mut ends) = (f64::INFINITY, Vec::new());
    for _ in 0..3 {
        let start = Instant::now();
        ends = pool.install(|| Ensemble::new(MEMBERS, member).side_by_side(lanes::<DoublePendulum>).run());
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok(json!({
        "members": MEMBERS,
        "threads": threads,
        "seconds": least,
        "per_second": MEMBERS as f64 / least,
        "median_error": median_error(&ends)?,
    }))
}

fn member(i: usize) -> core::result::Result<Simulation, MemberError> {
    prepared(i, TOLERANCE)
}

/// From rest, both angles between 0.5 and 2.5.
fn prepared(i: usize, tolerance: f64) -> core::result::Result<Simulation, MemberError> {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };
    let angle = |step: usize| 0.5 + 2.0 * step as f64 / 99.0;
    let pose = Pose::new("phi_1", angle(i % 100)).with("phi_2", angle(i / 100));
    Ok(Simulation::new(&model)?.start(pose)?.limit(TIME).tolerance(tolerance))
}

/// Of the largest error of a state over its largest entry, against the same members at a tolerance
/// of 1e-14.
fn median_error(ends: &[core::result::Result<Member, MemberError>]) -> Result<f64> {
    let sample = || (0..MEMBERS).step_by(SAMPLE);
    let exact = Ensemble::new(MEMBERS / SAMPLE, |k| prepared(k * SAMPLE, 1e-14));
    let exact = exact.side_by_side(lanes::<DoublePendulum>).run();
    let mut errors = Vec::new();
    for (i, exact) in sample().zip(exact) {
        let (end, exact) = (ends[i].clone()?, exact?);
        let size = exact.state.iter().fold(0.0f64, |size, x| size.max(x.abs()));
        let worst = end.state.iter().zip(&exact.state).fold(0.0f64, |worst, (x, y)| worst.max((x - y).abs()));
        errors.push(worst / size);
    }
    errors.sort_by(f64::total_cmp);
    Ok(errors[errors.len() / 2])
}
