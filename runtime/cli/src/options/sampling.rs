//! Outputs of a run at its events and at requested times.

use crate::CommandError;
use crate::options::clock::Clock;
use crate::options::samples::Row;
use crate::options::values::time;
use crate::output::style::{NAME, styled};
use clap::Args;
use liftoff::__private::expression::{significant, unrounded};
use liftoff::Trajectory;
use liftoff_core::model::Layout;
use liftoff_studio::registry::Entry;
use liftoff_studio::run_spec::RunSpec;
use liftoff_studio::sweep::Columns;

/// Significant digits in the table.
const DIGITS: usize = 7;
/// Its column of words.
const EVENT: usize = 1;
/// More rows than this are a slip of the keyboard.
const MOST: usize = 1_000_000;
/// What stands beside the values before an impact or an impulse; those after it are in its own
/// line.
const BEFORE: &str = "before";
/// Lines of a table that are written at once.
const AT_ONCE: usize = 4096;

/// A time, what happens then, and the values.
type Shown = (f64, String, Vec<f64>);

#[derive(Args, Debug)]
pub struct Sampling {
    /// An output, `N(A)` or `E/(m*g*l)`, printed at the events; one more column of --csv
    #[arg(long, value_name = "EXPR")]
    output: Vec<String>,
    /// A time at which to print the outputs, or else the state
    #[arg(long, value_name = "T", value_parser = time, allow_negative_numbers = true)]
    at: Vec<f64>,
    /// The same at every multiple of DT; the rows of --csv, which are not printed too
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
    pub fn check(&self, model: &Entry, spec: &RunSpec) -> Result<(), CommandError> {
        let begin = spec.begin();
        if let Some(every) = self.every.filter(|every| !(*every > 0.0 && every.is_finite())) {
            return Err(CommandError::Usage(format!("--every {every}: expected a time > 0")));
        }
        if let Some(at) = self.at.iter().find(|at| !(**at >= begin && at.is_finite())) {
            return Err(CommandError::Usage(format!("--at {at}: the run begins at t = {begin}")));
        }
        Ok(self.output.iter().try_for_each(|output| model.check(output))?)
    }

    /// Refuses more times than can be meant.
    pub fn check_rows(&self, record: &Trajectory) -> Result<(), CommandError> {
        let Some(every) = self.every else { return Ok(()) };
        match (record.end_time() - record.start_time()) / every {
            rows if rows > MOST as f64 => Err(CommandError::Usage(format!(
                "every {every} would be {rows:.0e} rows: {MOST} are the most"
            ))),
            _ => Ok(()),
        }
    }

    /// The requested times.
    pub fn clock(&self) -> Clock {
        self.printed(false)
    }

    /// The times whose rows are printed: those at every multiple are not where a file has them, which takes as many as there are.
    pub fn printed(&self, is_filed: bool) -> Clock {
        let every = self.every.filter(|_| !is_filed);
        Clock::given(self.at.clone(), every, MOST + 1 + self.at.len())
    }

    /// What a table shows: the outputs, or the state if none is requested.
    pub fn columns(&self, layout: &Layout) -> Vec<String> {
        if self.output.is_empty() { layout.names_of_motion().collect() } else { self.output.clone() }
    }

    /// Writes the events and the requested times in order, with what a table shows, some thousand lines at once.
    pub fn table(
        &self,
        record: &Trajectory,
        samples: Vec<Row>,
        write: &mut dyn FnMut(&str) -> Result<(), CommandError>,
    ) -> Result<(), CommandError> {
        let shown =
            |values: Vec<f64>| if self.output.is_empty() { record.unrounded(&values) } else { values };
        let mut rows: Vec<Shown> = Vec::new();
        for (k, event) in record.events().iter().enumerate() {
            let precedes = precedes_jump(record.events(), k);
            let values = match self.output.is_empty() {
                true => record.with_dependent(&event.state),
                false => values_at(&samples, event.t, precedes),
            };
            let before = values_at(&samples, event.t, true);
            let is_first = rows.last().is_none_or(|(t, ..)| *t < event.t);
            if event.before.is_some() && is_first && !before.is_empty() {
                rows.push((event.t, BEFORE.to_owned(), shown(before)));
            }
            rows.push((event.t, head(&event.to_string()).to_owned(), shown(values)));
        }
        rows.extend(
            samples
                .into_iter()
                .filter(|row| row.is_requested && !row.is_event)
                .map(|row| (row.t, String::new(), shown(row.values))),
        );
        rows.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        if !self.output.is_empty() {
            drop_rounding(&mut rows);
        }
        let quantities = self.columns(record.layout());
        let (changing, same) = self.split_columns(&rows, quantities.len());
        let named = changing.iter().map(|&k| quantities[k].clone());
        let names: Vec<String> = ["t".to_owned(), "event".to_owned()].into_iter().chain(named).collect();
        let mut columns = Columns::default();
        columns.widen(&names);
        rows.iter().for_each(|row| columns.widen(&line(row, &changing)));
        write(&(styled(NAME, &columns.line(&names, Some(EVENT))) + "\n"))?;
        rows.chunks(AT_ONCE).try_for_each(|rows| {
            let lines = rows.iter().map(|row| columns.line(&line(row, &changing), Some(EVENT)) + "\n");
            write(&lines.collect::<String>())
        })?;
        let Some((.., values)) = rows.first().filter(|_| !same.is_empty()) else { return Ok(()) };
        let told = same.iter().map(|&k| format!("{} = {}", quantities[k], significant(values[k], DIGITS)));
        write(&format!("in every row {}\n", told.collect::<Vec<_>>().join(", ")))
    }

    /// The columns whose printed values change from row to row, and the others; outputs that are
    /// asked for stand in any case.
    fn split_columns(&self, rows: &[Shown], count: usize) -> (Vec<usize>, Vec<usize>) {
        let printed = |row: &Shown, k: usize| row.2.get(k).map(|value| significant(*value, DIGITS));
        let is_same = |k: &usize| rows.iter().all(|row| printed(row, *k) == printed(&rows[0], *k));
        let (same, changing): (Vec<usize>, Vec<usize>) = (0..count).partition(is_same);
        match self.output.is_empty() && !changing.is_empty() {
            true => (changing, same),
            false => ((0..count).collect(), Vec::new()),
        }
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

/// The values of the row at a time, before a jump or after it, if there is one.
pub fn values_at(rows: &[Row], t: f64, is_before: bool) -> Vec<f64> {
    let rows = &rows[rows.partition_point(|row| row.t < t)..];
    let row = rows.iter().take_while(|row| row.t == t).find(|row| row.is_before == is_before);
    row.map_or_else(Vec::new, |row| row.values.clone())
}

/// Whether velocities jump after an event at the same time, so that what is read then is the motion
/// before that.
pub fn precedes_jump(events: &[liftoff::Event], k: usize) -> bool {
    let is_now = |event: &&liftoff::Event| event.t == events[k].t;
    let jumps = |event: &liftoff::Event| event.before.is_some();
    let has_jumped = events[..=k].iter().rev().take_while(is_now).any(jumps);
    !has_jumped && events[k..].iter().take_while(is_now).any(jumps)
}

/// Puts zero in place of what is rounding beside the largest value of its column.
fn drop_rounding(rows: &mut [Shown]) {
    let columns = rows.iter().map(|(.., values)| values.len()).max().unwrap_or(0);
    for k in 0..columns {
        let values = rows.iter().filter_map(|(.., values)| values.get(k));
        let largest = values.map(|value| value.abs()).filter(|value| value.is_finite()).fold(0.0, f64::max);
        rows.iter_mut()
            .filter_map(|(.., values)| values.get_mut(k))
            .for_each(|x| *x = unrounded(*x, largest));
    }
}

/// What stands in a line of a table with these columns.
fn line((t, event, values): &Shown, columns: &[usize]) -> Vec<String> {
    let values = columns.iter().filter_map(|&k| values.get(k)).map(|value| significant(*value, DIGITS));
    [significant(*t, DIGITS), event.clone()].into_iter().chain(values).collect()
}

/// What happens, without when and where.
pub fn head(event: &str) -> &str {
    event.split_once(" at t = ").map_or(event, |(head, _)| head)
}
