//! Whole runs of models compiled and interpreted, and how long it takes from a declaration's text
//! to its first result.

use liftoff_compiled::models;
use liftoff_interpreter::Interpreted;
use liftoff_studio::registry::Entry;
use liftoff_studio::run_spec::RunSpec;
use serde_json::{Value, json};
use std::hint::black_box;

use crate::Result;
use crate::timing::nanoseconds;

/// A model, and the start and the end of a run that is not its default one.
type Asked = (&'static str, &'static [(&'static str, f64)], Option<&'static str>);

const RUNS: [Asked; 4] = [
    ("double-pendulum", &[], None),
    ("falling-pair", &[("phi", 0.1)], Some("phi = pi/2")),
    ("zigzag-full", &[], None),
    ("slider-crank", &[], None),
];

/// A row for each run.
pub fn rows() -> Result<Vec<Value>> {
    RUNS.iter().map(|(name, start, until)| row(name, start, *until)).collect()
}

fn row(name: &str, start: &[(&str, f64)], until: Option<&str>) -> Result<Value> {
    let compiled = models().find(name)?;
    let default = compiled.default_run();
    let spec = match until {
        None => default,
        Some(until) => RunSpec { until: vec![until.to_owned()], ..default.start(start) },
    };
    let text = compiled.layout().declaration;
    let derived = || -> Result<Entry> {
        Ok(Entry::interpreted(Interpreted::from_analysis(&liftoff_codegen::analyse(text.parse()?)?)))
    };
    let own = derived()?;
    let first = || black_box(derived().and_then(|entry| Ok(entry.run(&spec)?))).is_ok();
    let ns = nanoseconds([
        &mut || drop(black_box(compiled.run(&spec))),
        &mut || drop(black_box(own.run(&spec))),
        &mut || assert!(first()),
    ]);
    Ok(json!({
        "model": name,
        "us": ns[0] / 1e3,
        "us_interpreted": ns[1] / 1e3,
        "ratio": ns[1] / ns[0],
        "ms_from_text": ns[2] / 1e6,
    }))
}
