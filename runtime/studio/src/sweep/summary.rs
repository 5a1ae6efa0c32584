//! A sweep in a few lines.

use super::aligned::aligned;
use super::cell::{Cell, MemberResult, written};
use super::{Table, Varied};
use liftoff::__private::expression::unrounded;
use std::collections::BTreeMap;
use std::fmt::Write;

/// So many members that failed are listed.
const LISTED: usize = 10;
/// A sweep of at most so many members is shown whole.
pub const SHOWN: usize = 20;

impl Table {
    /// How many members, what was observed how often, least, median and greatest numbers, which
    /// failed and why.
    pub fn summary(&self) -> String {
        summary(self)
    }
}

fn summary(table: &Table) -> String {
    let failed = table.failed().count();
    let known = table.rows.len() - table.computed;
    let mut text = format!("{} members of {}: {} computed", table.total, table.model, table.computed);
    let counts =
        [(known, "from the journal"), (failed, "failed"), (table.total - table.rows.len(), "not run")];
    for (count, what) in counts.into_iter().filter(|(count, _)| *count > 0) {
        let _ = write!(text, ", {count} {what}");
    }
    match table.damaged {
        0 => {}
        1 => text += "; a damaged line of the journal was dropped",
        damaged => text += &format!("; {damaged} damaged lines of the journal were dropped"),
    }
    text.push('\n');
    if (1..=SHOWN).contains(&table.rows.len()) {
        text += &rows(table);
    }
    for (i, observation) in table.observations.iter().enumerate() {
        let _ = writeln!(text, "{}", observation.text());
        text += &if observation.is_category() { categories(table, i) } else { numbers(table, i) };
    }
    text + &failures(table, failed)
}

/// Every member: varied names, then what was observed.
fn rows(table: &Table) -> String {
    let names = table.varied.iter().map(|varied| varied.name.clone());
    let head = names.chain(table.observations.iter().map(|observation| observation.text().to_owned()));
    let largest: Vec<f64> = (0..table.observations.len()).map(|i| largest(table, i)).collect();
    let line = |row: &MemberResult| {
        let cells = match &row.outcome {
            Ok(cells) => cells.iter().zip(&largest).map(|(cell, largest)| shown(cell, *largest)).collect(),
            Err(_) => vec!["failed".to_owned()],
        };
        row.point.iter().map(|value| short(*value)).chain(cells).collect()
    };
    let lines: Vec<Vec<String>> = [head.collect()].into_iter().chain(table.rows.iter().map(line)).collect();
    aligned(&lines, None).iter().map(|line| format!("  {line}\n")).collect()
}

/// The largest value of an observation; what is rounding beside it is zero.
fn largest(table: &Table, observation: usize) -> f64 {
    let values = table.cells(observation).filter_map(|(_, cell)| cell.number()).map(f64::abs);
    values.filter(|value| value.is_finite()).fold(0.0, f64::max)
}

fn shown(cell: &Cell, largest: f64) -> String {
    match cell {
        Cell::Number(value) => short(unrounded(*value, largest)),
        Cell::Name(name) => name.clone(),
        Cell::Missing => "–".to_owned(),
    }
}

fn categories(table: &Table, observation: usize) -> String {
    let counts = counted(table, observation);
    let width = counts.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    counts.iter().map(|(name, count)| format!("  {name:width$}  {count:>9}\n")).collect()
}

/// The categories with how often each was observed, the most frequent first.
pub(super) fn counted(table: &Table, observation: usize) -> Vec<(String, usize)> {
    let mut counts = BTreeMap::new();
    for (_, cell) in table.cells(observation) {
        *counts.entry(cell.to_string()).or_insert(0) += 1;
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| core::cmp::Reverse(*count));
    counts
}

fn numbers(table: &Table, observation: usize) -> String {
    let mut values: Vec<f64> = table.cells(observation).filter_map(|(_, cell)| cell.number()).collect();
    let missing = table.cells(observation).filter(|(_, cell)| **cell == Cell::Missing).count();
    let largest = largest(table, observation);
    values.retain(|value| value.is_finite());
    values.iter_mut().for_each(|value| *value = unrounded(*value, largest));
    values.sort_by(f64::total_cmp);
    let mut text = match &values[..] {
        [] => "  no numbers".to_owned(),
        [least, .., greatest] => {
            format!(
                "  least {}  median {}  greatest {}",
                short(*least),
                short(median(&values)),
                short(*greatest)
            )
        }
        [value] => format!("  {}", short(*value)),
    };
    if missing > 0 {
        let _ = write!(text, "  ({missing} without)");
    }
    text + "\n"
}

fn median(sorted: &[f64]) -> f64 {
    let half = sorted.len() / 2;
    if sorted.len() % 2 == 1 { sorted[half] } else { 0.5 * (sorted[half - 1] + sorted[half]) }
}

/// Ten digits at most.
fn short(value: f64) -> String {
    let rounded = format!("{value:.9e}").parse().unwrap_or(value);
    written(rounded)
}

fn failures(table: &Table, failed: usize) -> String {
    if failed == 0 {
        return String::new();
    }
    let mut text = "failed\n".to_owned();
    for (row, reason) in table.failed().take(LISTED) {
        let _ = writeln!(text, "  {}  {}: {reason}", row.member, target(row, &table.varied));
    }
    if failed > LISTED {
        let _ = writeln!(text, "  … and {} more", failed - LISTED);
    }
    text
}

fn target(row: &MemberResult, varied: &[Varied]) -> String {
    let value = |(varied, value): (&Varied, &f64)| format!("{} = {}", varied.name, short(*value));
    varied.iter().zip(&row.point).map(value).collect::<Vec<_>>().join(", ")
}
