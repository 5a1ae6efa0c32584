//! Outputs of a run at its events and at requested times.

use crate::CommandError;
use crate::options::clock::Clock;
use crate::options::samples::Row;
use crate::options::values::time;
use crate::output::style::{NAME, styled};
use clap::Args;
use liftoff::Trajectory;
use liftoff::expression::{significant, unrounded};
use liftoff::model::Layout;
use liftoff_studio::registry::Entry;
use liftoff_studio::sweep::aligned;

/// Significant digits in the table.
const DIGITS: usize = 7;
/// Its column of words.
const EVENT: usize = 1;
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

    /// Refuses more times than can be meant.
    pub fn check_rows(&self, record: &Trajectory) -> Result<(), CommandError> {
        let Some(every) = self.every else { return Ok(()) };
        match record.end_time() / every {
            rows if rows > MOST as f64 => Err(CommandError::Usage(format!(
                "every {every} would be {rows:.0e} rows: {MOST} are the most"
            ))),
            _ => Ok(()),
        }
    }

    /// The requested times.
    pub fn clock(&self) -> Clock {
        Clock::given(self.at.clone(), self.every, MOST + 1 + self.at.len())
    }

    /// What a table shows: the outputs, or the state if none is requested.
    pub fn columns(&self, layout: &Layout) -> Vec<String> {
        if self.output.is_empty() { state(layout) } else { self.output.clone() }
    }

    /// The events and the requested times in order, with what a table shows.
    pub fn table(&self, record: &Trajectory, samples: &[Row]) -> String {
        let event = |event: &liftoff::Event| {
            let values = match self.output.is_empty() {
                true => record.unrounded(&event.state),
                false => values_at(samples, event.t),
            };
            (event.t, head(&event.to_string()).to_owned(), values)
        };
        let events: Vec<_> = record.events().iter().map(event).collect();
        let more = samples.iter().filter(|row| row.is_requested && !row.is_event).map(|row| {
            match self.output.is_empty() {
                true => (row.t, String::new(), record.unrounded(&row.values)),
                false => (row.t, String::new(), row.values.clone()),
            }
        });
        let mut rows: Vec<_> = events.into_iter().chain(more).collect();
        rows.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        if !self.output.is_empty() {
            drop_rounding(&mut rows);
        }
        let lines = aligned(&lines(self.columns(record.layout()), rows), Some(EVENT));
        let mut text = styled(NAME, &lines[0]) + "\n";
        text.extend(lines[1..].iter().map(|line| format!("{line}\n")));
        text
    }

    /// Refuses a requested time that the run did not reach.
    pub fn check_reached(&self, record: &Trajectory) -> Result<(), CommandError> {
        let end = record.end_time();
        match self.at.iter().find(|at| **at > end) {
            Some(at) => {
                Err(CommandError::Failed(format!("t = {at} is not within the run, which ended at t = {end}")))
            }
            None => Ok(()),
        }
    }
}

/// The values of the row at a time, if there is one.
pub fn values_at(rows: &[Row], t: f64) -> Vec<f64> {
    let place = rows.partition_point(|row| row.t < t);
    rows.get(place).filter(|row| row.t == t).map_or_else(Vec::new, |row| row.values.clone())
}

/// Puts zero in place of what is rounding beside the largest value of its column.
fn drop_rounding(rows: &mut [(f64, String, Vec<f64>)]) {
    let columns = rows.iter().map(|(.., values)| values.len()).max().unwrap_or(0);
    for k in 0..columns {
        let values = rows.iter().filter_map(|(.., values)| values.get(k));
        let largest = values.map(|value| value.abs()).filter(|value| value.is_finite()).fold(0.0, f64::max);
        rows.iter_mut()
            .filter_map(|(.., values)| values.get_mut(k))
            .for_each(|x| *x = unrounded(*x, largest));
    }
}

/// The head of a table, then its rows.
fn lines(names: Vec<String>, rows: Vec<(f64, String, Vec<f64>)>) -> Vec<Vec<String>> {
    let line = |(t, event, values): (f64, String, Vec<f64>)| {
        let values = values.into_iter().map(|value| significant(value, DIGITS));
        [significant(t, DIGITS), event].into_iter().chain(values).collect()
    };
    let head = [vec!["t".to_owned(), "event".to_owned()], names].concat();
    [head].into_iter().chain(rows.into_iter().map(line)).collect()
}

/// What happens, without when and where.
pub fn head(event: &str) -> &str {
    event.split_once(" at t = ").map_or(event, |(head, _)| head)
}

/// Coordinates, then rates.
pub fn state(layout: &Layout) -> Vec<String> {
    let names = layout.coordinates.iter().map(|coordinate| coordinate.name);
    names.clone().map(str::to_owned).chain(names.map(|name| format!("{name}'"))).collect()
}
