//! `liftoff precision`.

use crate::CommandError;
use crate::errors::interrupted::is_interrupted;
use crate::options::length::{Length, thin};
use crate::options::run_args::RunArgs;
use crate::options::values::{number, whole};
use crate::output::file::{Form, is_output, print_beside, probe_as, tell_written, write_picture};
use crate::output::json::pretty;
use crate::output::print::tell;
use crate::output::progress::Progress;
use clap::Args;
use core::ops::ControlFlow;
use liftoff_studio::registry::{self, MethodId, Models};
use liftoff_studio::verification::precision::ROUNDS;
use liftoff_studio::work_precision::{DISTURBED_NOTE, WorkPrecisionRow, figure, peers, written};
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;

/// Debug assertions are on in builds for development, which are not optimised.
const UNOPTIMISED: &str = "warning: these run times are those of a build without optimisation, some fifty times as long as they \
                           need be; errors are the same: `cargo run --release -- precision …`";

#[derive(Args, Debug)]
pub struct Precision {
    /// Names of models, as in `list`
    #[arg(required = true)]
    pub models: Vec<String>,
    /// Methods [default: all]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    methods: Vec<MethodId>,
    /// Relative tolerances [default: 1e-3, 1e-4, … 1e-14]
    #[arg(long, value_name = "X,…", value_delimiter = ',', value_parser = number, allow_negative_numbers = true)]
    tolerances: Vec<f64>,
    /// Time for each method at each tolerance, ms
    #[arg(long, value_name = "MS", default_value = "20", value_parser = whole(0..=600_000))]
    measuring: usize,
    #[command(flatten)]
    run_args: RunArgs,
    #[command(flatten)]
    length: Length,
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
    rows: &'a [WorkPrecisionRow],
}

impl Precision {
    /// Measures the models in order; failed measurements are kept as rows.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let shown = |row: &WorkPrecisionRow| self.models.contains(&row.model);
        let others: Result<Vec<_>, _> = self.peers.iter().map(|path| peers(path)).collect();
        let others = others?;
        self.csv.iter().try_for_each(|path| probe_as(path, &[Form::CSV]))?;
        self.svg.iter().try_for_each(|path| probe_as(path, &[Form::SVG]))?;
        let mut all = self.measured(models)?;
        all.extend(others.into_iter().flatten().filter(shown));
        if let Some(path) = &self.csv {
            written(&all, path)?;
            tell_written(path);
        }
        if let Some(path) = &self.svg {
            write_picture(path, &figure(&all))?;
            tell_written(path);
        }
        let output = self.csv.iter().chain(&self.svg).find(|path| is_output(path));
        let text = match self.json {
            true => json(&all)?,
            false => self.length.fit(table(&all, |_| true), |lines| brief_table(&all, lines)),
        };
        print_beside(output.map(PathBuf::as_path), &text)?;
        if is_interrupted() {
            return Err(CommandError::Interrupted(format!("interrupted after {} measurements", all.len())));
        }
        match all.iter().find(|row| row.is_refuted()) {
            Some(row) => Err(CommandError::Failed(format!("the judge disagrees with {}", row.model))),
            None => Ok(()),
        }
    }

    /// Measures the known models until Ctrl-C is pressed.
    fn measured(&self, models: &Models) -> Result<Vec<WorkPrecisionRow>, CommandError> {
        let spec = self.measurements();
        spec.check().map_err(|error| CommandError::Usage(error.to_string()))?;
        let names = distinct(&self.models);
        let found: Result<Vec<_>, _> = names.iter().map(|name| models.find(name)).collect();
        let found = found?;
        if cfg!(debug_assertions) {
            tell(UNOPTIMISED);
        }
        let interpreted: Vec<&str> = found.iter().filter(|m| !m.is_compiled()).map(|m| m.name()).collect();
        if !interpreted.is_empty() {
            tell(&format!(
                "interpreted: {}; compiled models take between a fifth and all of this time",
                interpreted.join(", ")
            ));
        }
        let each = spec.methods.len() * spec.tolerances.len() * ROUNDS as usize;
        let progress = Progress::new(found.len() * each, "measurements");
        let mut done = 0;
        let mut all = Vec::new();
        for model in found {
            progress.doing(model.name());
            let mut go_on = || {
                progress.reach(done);
                done += 1;
                if is_interrupted() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let measured = model.measure(&self.run_args.spec(model)?, &spec, &mut go_on)?;
            all.extend(measured.into_iter().map(|measured| WorkPrecisionRow::new(model.name(), measured)));
        }
        Ok(all)
    }

    fn measurements(&self) -> registry::PrecisionSpec {
        let default = registry::PrecisionSpec::default();
        registry::PrecisionSpec {
            methods: if self.methods.is_empty() { default.methods } else { distinct(&self.methods) },
            tolerances: if self.tolerances.is_empty() {
                default.tolerances
            } else {
                distinct(&self.tolerances)
            },
            measuring: Duration::from_millis(self.measuring as u64),
        }
    }
}

/// Removes duplicates, in the given order.
fn distinct<T: Clone + PartialEq>(all: &[T]) -> Vec<T> {
    let is_first = |(i, one): &(usize, &T)| !all[..*i].contains(*one);
    all.iter().enumerate().filter(is_first).map(|(_, one)| one.clone()).collect()
}

/// Error bounds for which the fastest method is printed.
const BOUNDS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

fn json(rows: &[WorkPrecisionRow]) -> Result<String, CommandError> {
    pretty(&Rows { rows })
}

/// For each model, the fastest method within each error bound: a summary of a long table.
fn fastest(rows: &[WorkPrecisionRow]) -> String {
    let mut models: Vec<&str> = rows.iter().map(|row| row.model.as_str()).collect();
    models.dedup();
    let error = |row: &WorkPrecisionRow| {
        let errors = [row.run_error, row.state_error, row.event_error];
        errors.into_iter().flatten().reduce(f64::max)
    };
    let line = |model: &str| {
        let parts = BOUNDS.iter().filter_map(|&bound| {
            let within = rows
                .iter()
                .filter(|row| row.model == model && error(row).is_some_and(|error| error <= bound));
            let row = within.min_by(|a, b| a.microseconds.total_cmp(&b.microseconds))?;
            Some(format!("to {bound:e} {} in {:.1} µs", row.method, row.microseconds))
        });
        let parts: Vec<String> = parts.collect();
        (!parts.is_empty()).then(|| format!("fastest, {model}: {}\n", parts.join(", ")))
    };
    models.into_iter().filter_map(line).collect()
}

/// The table with a few tolerances of each method, and all rows that have a reason to be looked at.
fn brief_table(rows: &[WorkPrecisionRow], lines: usize) -> String {
    let methods: Vec<_> = rows.chunk_by(|a, b| (&a.model, &a.method) == (&b.model, &b.method)).collect();
    let around = table(rows, |_| false).lines().count();
    let most = lines.saturating_sub(around) / methods.len().max(1);
    let tolerances: Vec<_> = methods.iter().flat_map(|rows| thin(rows, most)).collect();
    table(rows, |row| row.reason.is_some() || tolerances.iter().any(|shown| std::ptr::eq(*shown, row)))
}

/// The rows that are to be shown, between what is said of all.
fn table(rows: &[WorkPrecisionRow], is_shown: impl Fn(&WorkPrecisionRow) -> bool) -> String {
    let mut text = fastest(rows);
    text += &format!(
        "{:18} {:22} {:>9} {:>11} {:>11} {:>11} {:>8} {:>9} {:>7} {:>11}  {:10}  {}\n",
        "model",
        "method",
        "tolerance",
        "run error",
        "state error",
        "event error",
        "steps",
        "evals",
        "jacs",
        "least µs",
        "reference",
        "judge"
    );
    let error = |error: Option<f64>| error.map_or("–".into(), |error| format!("{error:.1e}"));
    let count = |count: Option<u64>| count.map_or("–".into(), |count| count.to_string());
    for row in rows.iter().filter(|row| is_shown(row)) {
        let _ = writeln!(
            text,
            "{:18} {:22} {:>9} {:>11} {:>11} {:>11} {:>8} {:>9} {:>7} {:>11.1}{:2}{:10}  {}{}",
            row.model,
            row.method,
            format!("{:e}", row.tolerance),
            error(row.run_error),
            error(row.state_error),
            error(row.event_error),
            count(row.steps),
            count(row.evaluations),
            count(row.jacobians),
            row.microseconds,
            row.mark_disturbed(),
            row.reference.as_deref().unwrap_or(if row.is_not_judged() { "not judged" } else { "–" }),
            // The text after the first colon is printed once here; JSON and CSV have it in every
            // row.
            row.judge.as_ref().map_or("–", |judge| judge
                .split([':', '='])
                .next()
                .unwrap_or(judge)
                .trim_end_matches(" at t ")),
            row.reason.as_ref().map_or_else(String::new, |reason| format!("  {reason}")),
        );
    }
    if rows.iter().any(WorkPrecisionRow::is_disturbed) {
        text = text + DISTURBED_NOTE + "\n";
    }
    text + &blank(rows) + &judged(rows)
}

/// The number of rows without a reference, as text.
fn blank(rows: &[WorkPrecisionRow]) -> String {
    match rows.iter().filter(|row| row.is_not_judged()).count() {
        0 => String::new(),
        count => format!("{count} of {} rows are not judged: there is no reference\n", rows.len()),
    }
}

/// Each verdict once.
fn judged(rows: &[WorkPrecisionRow]) -> String {
    let mut lines: Vec<String> = Vec::new();
    for row in rows {
        let line = row.judge.as_ref().map(|judge| format!("judge, {}: {judge}\n", row.model));
        lines.extend(line.filter(|line| !lines.contains(line)));
    }
    lines.concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fastest_within_each_bound_is_told_first() {
        let row =
            |method, error, time| WorkPrecisionRow::peer(("ladder", method, 1e-6), [Some(error), None], time);
        let text = table(&[row("a", 1e-4, 1.0), row("b", 1e-10, 3.0), row("c", 1e-7, 2.0)], |_| true);
        let first = text.lines().next().expect("a line");
        assert_eq!(first, "fastest, ladder: to 1e-3 a in 1.0 µs, to 1e-6 c in 2.0 µs, to 1e-9 b in 3.0 µs");
    }

    #[test]
    fn rows_without_a_reference_are_not_judged() {
        let row = |errors| WorkPrecisionRow::peer(("ladder", "other", 1e-6), errors, 1.0);
        let text = table(&[row([None, None]), row([Some(1e-7), None])], |_| true);
        assert!(
            text.contains("not judged")
                && text.ends_with("1 of 2 rows are not judged: there is no reference\n"),
            "{text}"
        );
        assert!(!table(&[row([Some(1e-7), None])], |_| true).contains("not judged"));
    }
}
