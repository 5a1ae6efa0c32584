//! Long runs of impacts, observed and not recorded: time per impact, and memory that the run has
//! added.
//!
//! `cargo bench -p liftoff-tests --bench events -- 100000`; beside it tests/peers/python/events.py.

use liftoff::prelude::*;
use liftoff::{Budget, Observer, Step};
use liftoff_compiled::{BouncingBall, RimlessWheel};
use liftoff_core::model::BarSystem;
use std::f64::consts::PI;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

const REPEATS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut words = std::env::args().skip(1).filter(|word| !word.starts_with('-'));
    let Some(impacts) = words.next_back().map(|word| word.parse()).transpose()? else { return Ok(()) };
    let ball = BouncingBall { m: 1.0, g: 9.81, e: 1.0 };
    let from_rest = Pose::new("y", 1.0).with("x", 0.0);
    // On both feet A and F, it turns about A.
    let wheel = RimlessWheel { m: 1.0, j: 0.1, l: 1.0, gamma: 0.2, mu: 1.5, g: 9.81 };
    let (sin, cos) = (-0.2 - PI / 3.0).sin_cos();
    let rolling = Pose::new("phi", -0.2).with("phi'", -2.0).with("x'", -2.0 * sin).with("y'", 2.0 * cos);
    for tolerance in [1e-9, 1e-14] {
        measure("bouncing-ball", tolerance, &simulation(&ball, &from_rest, tolerance)?, impacts);
    }
    for tolerance in [1e-9, 1e-14] {
        measure("rimless-wheel", tolerance, &simulation(&wheel, &rolling, tolerance)?, impacts);
    }
    Ok(())
}

fn simulation<M: BarSystem>(
    model: &M,
    start: &Pose,
    tolerance: f64,
) -> Result<Simulation, Box<dyn std::error::Error>> {
    let budget = Budget { events: usize::MAX, ..Budget::default() };
    Ok(Simulation::new(model)?.start(start.clone())?.tolerance(tolerance).limit(1e12).budget(budget))
}

/// Counts impacts, and stops the run after so many.
struct Count {
    left: u64,
    last: f64,
    stop: Arc<AtomicBool>,
}

impl Observer for Count {
    fn step(&mut self, _: &dyn Step) {}

    fn happened(&mut self, event: &Event) -> bool {
        if event.kind == EventKind::Impact && self.left > 0 {
            (self.left, self.last) = (self.left - 1, event.t);
            self.stop.store(self.left == 0, Ordering::Relaxed);
        }
        true
    }
}

fn measure(name: &str, tolerance: f64, simulation: &Simulation, impacts: u64) {
    let (mut least, before) = (f64::INFINITY, memory());
    let mut last = 0.0;
    for _ in 0..REPEATS {
        let stop = Arc::new(AtomicBool::new(false));
        let mut count = Count { left: impacts, last: 0.0, stop: Arc::clone(&stop) };
        let begun = Instant::now();
        let run = simulation.clone().cancel(stop).observe(&mut count);
        least = least.min(begun.elapsed().as_secs_f64());
        last = count.last;
        if count.left > 0 {
            println!(
                "{name} {tolerance:e}: {} impacts are missing: {:?}",
                count.left,
                run.err().map(|e| e.to_string())
            );
        }
    }
    let each = 1e6 * least / impacts as f64;
    println!(
        "{name} {tolerance:e}: {each:.2} µs per impact, {:.1} MB, the last at {last:?}",
        memory() - before
    );
}

/// The most that the process has had, MB.
fn memory() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok()).unwrap_or(f64::NAN) / 1024.0
}
