//! Ten thousand short runs of a model that no compiler has seen, to their first opening, and as many that end at once, each five
//! times; `sweep.py` sets the same from Python beside it. With `--where` it tells where it is, and how many times.

use liftoff_studio::registry::Entry;
use liftoff_studio::run_spec::RunSpec;
use liftoff_studio::source::models;
use liftoff_studio::sweep::{Spread, Sweep, SweepError, Varied};
use std::env::{args, current_exe};
use std::sync::atomic::{AtomicUsize, Ordering};

const ZIGZAG: &str = include_str!("../../../models/systems/src/zigzag.rs");
const RUNS: usize = 10_000;
const REPEATS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    if args().nth(1).is_some_and(|word| word == "--where") {
        println!("{} {REPEATS}", current_exe()?.display());
        return Ok(());
    }
    let found = models(ZIGZAG).map_err(|mistakes| format!("{mistakes:?}"))?;
    let zigzag = found.first().ok_or("no model")?;
    let default = RunSpec::with(&[("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("g", 1.0)]);
    for spec in [default.clone(), default.limit(1e-9)] {
        for _ in 0..REPEATS {
            assert_eq!(runs(zigzag, &spec)?, RUNS);
        }
    }
    Ok(())
}

/// How many have come to their ends.
fn runs(zigzag: &Entry, spec: &RunSpec) -> Result<usize, SweepError> {
    let angles = |name: &str| {
        let values = (0..RUNS).map(|i| 0.9 + 0.6 * i as f64 / (RUNS - 1) as f64).collect();
        Varied { name: name.to_owned(), spread: Spread::Listed(values), units: Vec::new() }
    };
    let sweep = Sweep::new(zigzag).spec(spec.clone()).over(angles("phi_inner")).over(angles("phi_outer"));
    let sweep = sweep.observe("first open")?.threads(1);
    let told = AtomicUsize::new(0);
    sweep.each_paired(&|_, outcome| {
        told.fetch_add(usize::from(outcome.is_ok()), Ordering::Relaxed);
    })?;
    Ok(told.into_inner())
}
