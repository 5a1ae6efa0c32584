//! `liftoff precision`.

use super::CommandError;
use super::asked::Asked;
use super::interrupted::is_interrupted;
use super::print::print;
use super::progress::Progress;
use crate::catalog::{self, Integrator, Models};
use crate::plot::on_card;
use crate::work_precision::{Row, peers, sheet, written};
use clap::Args;
use core::ops::ControlFlow;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;

#[derive(Args, Debug)]
pub struct Precision {
    /// Names of the models, as `list` has them
    #[arg(required = true)]
    models: Vec<String>,
    /// Methods; every one if none is given
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    methods: Vec<Integrator>,
    /// Relative tolerances [default: 1e-3, 1e-4, … 1e-14]
    #[arg(long, value_name = "X,…", value_delimiter = ',')]
    tolerances: Vec<f64>,
    /// Time for each method at each tolerance, ms
    #[arg(long, value_name = "MS", default_value_t = 20)]
    measuring: u64,
    #[command(flatten)]
    asked: Asked,
    /// Another tool's rows, `scene,tolerance,error,end_error,microseconds`, named after the file
    #[arg(long, value_name = "FILE")]
    peers: Vec<PathBuf>,
    /// Print JSON
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Write the rows to a file
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Draw error against run time
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

#[derive(Serialize)]
struct Rows<'a> {
    rows: &'a [Row],
}

impl Precision {
    /// Measures the models one after the other; nothing that fails is left out.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let mut all = self.measured(models)?;
        for path in &self.peers {
            let shown = |row: &Row| self.models.contains(&row.model);
            all.extend(peers(path)?.into_iter().filter(shown));
        }
        if let Some(path) = &self.csv {
            written(&all, path)?;
        }
        if let Some(path) = &self.svg {
            let svg = sheet(&all).map_err(|error| CommandError::Failed(error.to_string()))?;
            let failed = |error| CommandError::Failed(format!("cannot write {}: {error}", path.display()));
            std::fs::write(path, on_card(&svg)).map_err(failed)?;
        }
        print(&if self.json { json(&all)? } else { table(&all) })?;
        match is_interrupted() {
            true => Err(CommandError::Interrupted(format!("interrupted after {} measurements", all.len()))),
            false => Ok(()),
        }
    }

    /// Of all models that are known, until Ctrl-C is pressed.
    fn measured(&self, models: &Models) -> Result<Vec<Row>, CommandError> {
        let asked = self.measurements();
        let found: Result<Vec<_>, _> = self.models.iter().map(|name| models.find(name)).collect();
        let found = found?;
        let each = asked.methods.len() * asked.tolerances.len();
        let progress = Progress::of(found.len() * each, "measurements");
        let mut done = 0;
        let mut all = Vec::new();
        for model in found {
            progress.doing(model.name());
            let mut go_on = || {
                progress.reach(done);
                done += 1;
                if is_interrupted() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let measured = model.measure(&self.asked.setup(model.setup()), &asked, &mut go_on)?;
            all.extend(measured.into_iter().map(|measured| Row::new(model.name(), measured)));
        }
        Ok(all)
    }

    fn measurements(&self) -> catalog::Asked {
        let default = catalog::Asked::default();
        catalog::Asked {
            methods: if self.methods.is_empty() { default.methods } else { self.methods.clone() },
            tolerances: if self.tolerances.is_empty() { default.tolerances } else { self.tolerances.clone() },
            measuring: Duration::from_millis(self.measuring),
        }
    }
}

fn json(rows: &[Row]) -> Result<String, CommandError> {
    let text = serde_json::to_string_pretty(&Rows { rows });
    text.map(|text| text + "\n").map_err(|error| CommandError::Failed(error.to_string()))
}

fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "{:18} {:22} {:>9} {:>11} {:>11} {:>8} {:>9} {:>7} {:>11}\n",
        "model", "method", "tolerance", "state error", "event error", "steps", "evals", "jacs", "least µs"
    );
    let error = |error: Option<f64>| error.map_or("–".into(), |error| format!("{error:.1e}"));
    let count = |count: Option<u64>| count.map_or("–".into(), |count| count.to_string());
    for row in rows {
        let _ = writeln!(
            text,
            "{:18} {:22} {:>9} {:>11} {:>11} {:>8} {:>9} {:>7} {:>11.1}{}",
            row.model,
            row.method,
            format!("{:e}", row.tolerance),
            error(row.state_error),
            error(row.event_error),
            count(row.steps),
            count(row.evaluations),
            count(row.jacobians),
            row.microseconds,
            row.reason.as_ref().map_or_else(String::new, |reason| format!("  {reason}")),
        );
    }
    text
}
