//! Outputs of a run at its events and at requested times.

use crate::CommandError;
use crate::options::states::States;
use crate::options::values::time;
use crate::output::style::{NAME, styled};
use clap::Args;
use liftoff::Trajectory;
use liftoff::expression::significant;
use liftoff_studio::registry::Entry;

/// Significant digits in the table.
const DIGITS: usize = 7;
/// More rows than this are a slip of the keyboard.
const MOST: usize = 1_000_000;

#[derive(Args, Debug)]
pub struct Sampling {
    /// An output, `N(A)` or `E/(m*g*l)`, printed at the events; one more column of --csv
    #[arg(long, value_name = "EXPR")]
    output: Vec<String>,
    /// A time at which to print the outputs, or else the state
    #[arg(long, value_name = "T", value_parser = time, allow_negative_numbers = true)]
    at: Vec<f64>,
    /// The same at every multiple of DT; the rows of --csv
    #[arg(long, value_name = "DT", value_parser = time, allow_negative_numbers = true)]
    every: Option<f64>,
}

/// A time, and what happens then.
pub struct SampleRow {
    pub t: f64,
    pub event: String,
}

impl SampleRow {
    fn of(event: &liftoff::Event) -> Self {
        Self { t: event.t, event: head(&event.to_string()).to_owned() }
    }
}

impl Sampling {
    pub fn is_empty(&self) -> bool {
        self.output.is_empty() && self.is_of_events()
    }

    /// Whether no time is requested.
    pub fn is_of_events(&self) -> bool {
        self.at.is_empty() && self.every.is_none()
    }

    pub fn outputs(&self) -> &[String] {
        &self.output
    }

    /// Refuses what could only be refused after the run.
    pub fn check(&self, model: &Entry) -> Result<(), CommandError> {
        if let Some(every) = self.every.filter(|every| !(*every > 0.0 && every.is_finite())) {
            return Err(CommandError::Usage(format!("--every {every}: expected a time > 0")));
        }
        if let Some(at) = self.at.iter().find(|at| !(**at >= 0.0 && at.is_finite())) {
            return Err(CommandError::Usage(format!("--at {at}: a run begins at t = 0")));
        }
        Ok(self.output.iter().try_for_each(|output| model.check(output))?)
    }

    /// The events and the requested times, in order.
    pub fn rows(&self, record: &Trajectory) -> Result<Vec<SampleRow>, CommandError> {
        let mut rows: Vec<SampleRow> = record.events().iter().map(SampleRow::of).collect();
        let known: Vec<f64> = rows.iter().map(|row| row.t).collect();
        let more = self.times(record.interval())?.into_iter().filter(|t| !known.contains(t));
        rows.extend(more.map(|t| SampleRow { t, event: String::new() }));
        rows.sort_by(|a, b| a.t.total_cmp(&b.t));
        Ok(rows)
    }

    /// The requested times that the run reaches.
    pub fn times(&self, [start, end]: [f64; 2]) -> Result<Vec<f64>, CommandError> {
        let mut times = self.at.clone();
        times.retain(|t| (start..=end).contains(t));
        if let Some(every) = self.every {
            let rows = (end - start) / every;
            if rows > MOST as f64 {
                return Err(CommandError::Usage(format!(
                    "every {every} would be {rows:.0e} rows: {MOST} are the most"
                )));
            }
            times.extend((0..=rows as u64).map(|i| start + i as f64 * every));
        }
        Ok(times)
    }

    /// The rows with the outputs, or with the state if none is requested.
    pub fn table(&self, record: &Trajectory) -> Result<String, CommandError> {
        let names = if self.output.is_empty() { state(record) } else { self.output.clone() };
        let outputs: Result<Vec<_>, _> = names.iter().map(|name| record.function(name)).collect();
        let outputs = outputs?;
        let values = |row: SampleRow| {
            let values = outputs.iter().map(|output| output(row.t)).collect();
            (row, values)
        };
        Ok(aligned(&lines(names, self.rows(record)?.into_iter().map(values))))
    }

    /// What takes states at the requested times while a run goes on.
    pub fn states(&self) -> States {
        States::new(self.at.clone(), self.every, MOST)
    }

    /// The table of states of a run whose motion was not kept.
    pub fn table_of_states(&self, record: &Trajectory, states: States) -> Result<String, CommandError> {
        self.times(record.interval())?;
        let event = |event: &liftoff::Event| (SampleRow::of(event), event.state.clone());
        let mut rows: Vec<_> = record.events().iter().map(event).collect();
        let known: Vec<f64> = rows.iter().map(|(row, _)| row.t).collect();
        let more = states.of(record).into_iter().filter(|(t, _)| !known.contains(t));
        rows.extend(more.map(|(t, state)| (SampleRow { t, event: String::new() }, state)));
        rows.sort_by(|(a, _), (b, _)| a.t.total_cmp(&b.t));
        Ok(aligned(&lines(state(record), rows.into_iter())))
    }

    /// Refuses a requested time that the run did not reach.
    pub fn check_reached(&self, record: &Trajectory) -> Result<(), CommandError> {
        let end = record.interval()[1];
        match self.at.iter().find(|at| **at > end) {
            Some(at) => {
                Err(CommandError::Failed(format!("t = {at} is not within the run, which ended at t = {end}")))
            }
            None => Ok(()),
        }
    }
}

/// The head of a table, then its rows.
fn lines(names: Vec<String>, rows: impl Iterator<Item = (SampleRow, Vec<f64>)>) -> Vec<Vec<String>> {
    let line = |(SampleRow { t, event }, values): (SampleRow, Vec<f64>)| {
        let values = values.into_iter().map(|value| significant(value, DIGITS));
        [significant(t, DIGITS), event].into_iter().chain(values).collect()
    };
    let head = [vec!["t".to_owned(), "event".to_owned()], names].concat();
    [head].into_iter().chain(rows.map(line)).collect()
}

/// What happens, without when and where.
pub fn head(event: &str) -> &str {
    event.split_once(" at t = ").map_or(event, |(head, _)| head)
}

/// Coordinates, then rates.
fn state(record: &Trajectory) -> Vec<String> {
    let names = record.layout().coordinates.iter().map(|coordinate| coordinate.name);
    names.clone().map(str::to_owned).chain(names.map(|name| format!("{name}'"))).collect()
}

/// Columns as wide as their widest entry, numbers to the right.
fn aligned(lines: &[Vec<String>]) -> String {
    let width = |k: usize| lines.iter().map(|line| line[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..lines[0].len()).map(width).collect();
    // Widths of formats end at 65,535.
    let cell = |(k, text): (usize, &String)| {
        let room = " ".repeat(widths[k].saturating_sub(text.chars().count()));
        if k == 1 { format!("{text}{room}") } else { format!("{room}{text}") }
    };
    let line = |line: &Vec<String>| line.iter().enumerate().map(cell).collect::<Vec<_>>().join("  ");
    let mut text = styled(NAME, line(&lines[0]).trim_end()) + "\n";
    text.extend(lines[1..].iter().map(|row| format!("{}\n", line(row).trim_end())));
    text
}
