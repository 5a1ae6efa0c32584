//! Error against run time of liftoff's methods and of other crates, in one run: the double pendulum
//! for 10 s, and the falling pair with its lift-off.
//! `cargo bench -p liftoff-peers --features solvers`; files are written beside those of the main
//! job.

mod differential;
mod diffsol;
mod ivp;
mod ode_solvers;

use liftoff_compiled::models;
use liftoff_peers::{event_error, state_error};
use liftoff_studio::plot::with_theme;
use liftoff_studio::registry::PrecisionSpec;
use liftoff_studio::run_spec::{RunSpec, named};
use liftoff_studio::work_precision::{WorkPrecisionRow, figure, rows, written};
use std::error::Error;
use std::path::Path;
use std::time::{Duration, Instant};

const MEASURING: Duration = Duration::from_millis(50);

/// Times of lift-off and end at a tolerance.
type Pair = fn(f64) -> Option<[f64; 2]>;

/// A crate with what it makes of the scenes: a final state, and the times of lift-off and end; none
/// where it fails.
struct Tool {
    name: &'static str,
    pendulum: fn(f64) -> Option<[f64; 4]>,
    pair: Option<Pair>,
}

const TOOLS: [Tool; 5] = [
    Tool { name: "ode_solvers dop853", pendulum: ode_solvers::pendulum, pair: None },
    Tool { name: "ivp dop853", pendulum: ivp::pendulum, pair: Some(ivp::pair) },
    Tool { name: "diffsol tsit45", pendulum: diffsol::pendulum, pair: Some(diffsol::pair) },
    Tool {
        name: "differential-equations dop853",
        pendulum: differential::pendulum,
        pair: Some(differential::pair),
    },
    Tool { name: "differential-equations rkv988e", pendulum: differential::verner, pair: None },
];

fn main() -> Result<(), Box<dyn Error>> {
    let asked = PrecisionSpec { measuring: MEASURING, ..PrecisionSpec::default() };
    let mut all = Vec::new();
    for (model, change) in
        [("double-pendulum", swinging as fn(RunSpec) -> RunSpec), ("falling-pair", falling)]
    {
        let model = models().find(model)?;
        all.extend(rows(model, &change(model.default_run()), &asked)?);
    }
    for tool in &TOOLS {
        all.extend(asked.tolerances.iter().map(|&tolerance| tool.on_pendulum(tolerance)));
        if let Some(pair) = tool.pair {
            all.extend(asked.tolerances.iter().map(|&tolerance| tool.on_pair(pair, tolerance)));
        }
    }
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/liftoff");
    std::fs::create_dir_all(&directory)?;
    written(&all, &directory.join("peers.csv"))?;
    std::fs::write(directory.join("peers.svg"), with_theme(&figure(&all)))?;
    all.iter().for_each(print);
    Ok(())
}

fn swinging(spec: RunSpec) -> RunSpec {
    RunSpec { start: named(&[("phi_1", 2.0), ("phi_2", 1.0)]), until: vec!["t = 10".into()], ..spec }
}

fn falling(spec: RunSpec) -> RunSpec {
    RunSpec { start: named(&[("phi", 0.1)]), energy_of: Vec::new(), ..spec }
}

impl Tool {
    fn on_pendulum(&self, tolerance: f64) -> WorkPrecisionRow {
        let (end, microseconds) = timed(|| (self.pendulum)(tolerance));
        let error = end.map(|end| state_error(&end));
        add_reason(WorkPrecisionRow::peer(
            ("double-pendulum", self.name, tolerance),
            [error, None],
            microseconds,
        ))
    }

    fn on_pair(&self, pair: Pair, tolerance: f64) -> WorkPrecisionRow {
        let (times, microseconds) = timed(|| pair(tolerance));
        add_reason(WorkPrecisionRow::peer(
            ("falling-pair", self.name, tolerance),
            [None, times.map(event_error)],
            microseconds,
        ))
    }
}

fn add_reason(mut row: WorkPrecisionRow) -> WorkPrecisionRow {
    if row.state_error.or(row.event_error).is_none() {
        row.reason = Some("it failed or found no event".into());
    }
    row
}

/// A result and the least time of several, µs.
fn timed<T>(run: impl Fn() -> T) -> (T, f64) {
    let begun = Instant::now();
    let mut least = f64::INFINITY;
    loop {
        let start = Instant::now();
        let result = std::hint::black_box(run());
        least = least.min(1e6 * start.elapsed().as_secs_f64());
        if begun.elapsed() > MEASURING {
            return (result, least);
        }
    }
}

fn print(row: &WorkPrecisionRow) {
    let error = |error: Option<f64>| error.map_or("–".into(), |error| format!("{error:.1e}"));
    println!(
        "{:16} {:31} {:>7} {:>9} {:>9} {:>10.1} µs  {}",
        row.model,
        row.method,
        format!("{:e}", row.tolerance),
        error(row.state_error),
        error(row.event_error),
        row.microseconds,
        row.reason.as_deref().unwrap_or_default(),
    );
}
