//! What came of a sweep.

use super::cell::{Cell, MemberResult, Outcome, written};
use super::columnar;
use super::journal::{self, Identity};
use super::{Observation, Sweep, SweepError, Varied};
use liftoff_columnar::{Column, Format};
use rayon::prelude::*;
use std::path::Path;

/// What came of a sweep: its members in the order of their numbers.
pub struct Table {
    /// Its members; those that were not run are not among them.
    pub rows: Vec<MemberResult>,
    /// Number of members of the whole sweep.
    pub total: usize,
    /// How many of the rows were computed now; a journal had the others.
    pub computed: usize,
    /// How many lines of the journal were not as they had been written; their members were computed
    /// once more.
    pub damaged: usize,
    pub(super) varied: Vec<Varied>,
    pub(super) observations: Vec<Observation>,
    pub(super) model: String,
    pub(super) angles: Vec<String>,
    pub(super) grid: bool,
    pub(super) columns: Vec<Column>,
    pub(super) identity: Identity,
}

impl Table {
    pub(super) fn new(sweep: &Sweep<'_>, rows: Vec<MemberResult>, total: usize, pending: usize) -> Self {
        let layout = sweep.model().layout();
        Self {
            computed: rows.len() + pending - total,
            damaged: 0,
            rows,
            total,
            varied: sweep.varied.clone(),
            observations: sweep.observations.clone(),
            model: sweep.model().name().to_owned(),
            angles: layout
                .names_of_positions()
                .filter(|name| layout.is_angle(name))
                .map(str::to_owned)
                .collect(),
            grid: sweep.is_grid(),
            columns: sweep.columns(),
            identity: sweep.identity(),
        }
    }

    /// Whether every member was run.
    pub fn is_whole(&self) -> bool {
        self.rows.len() == self.total
    }

    /// Members that failed.
    pub fn failed(&self) -> impl Iterator<Item = (&MemberResult, &str)> {
        self.rows.iter().filter_map(|row| row.outcome.as_ref().err().map(|reason| (row, reason.as_str())))
    }

    /// The values of an observation, by its index, of all members that did not fail.
    pub fn cells(&self, observation: usize) -> impl Iterator<Item = (&MemberResult, &Cell)> {
        self.rows.iter().filter_map(move |row| Some((row, row.outcome.as_ref().ok()?.get(observation)?)))
    }

    /// Comma-separated: member, varied names, observations, why it failed.
    pub fn csv(&self) -> String {
        let line = |row: &MemberResult| line(row.member, &row.point, &row.outcome, self.observations.len());
        let lines: String = self.rows.par_iter().map(line).collect();
        head(&self.varied, &self.observations) + &lines
    }

    /// Writes [`Self::csv`] to a file, all of it or nothing.
    pub fn write_csv(&self, path: &Path) -> Result<(), SweepError> {
        let failed = |source| SweepError::File { doing: "write", path: path.to_owned(), source };
        crate::file::write(path, self.csv()).map_err(failed)
    }

    /// Writes the same to a columnar file, all of it or nothing: columns with units; numbers and
    /// names that a member does not have are missing there.
    ///
    /// # Errors
    /// Two columns have one name; the build does not have the format; the file cannot be written.
    pub fn write_columnar(&self, format: Format, path: &Path) -> Result<(), SweepError> {
        let heading = columnar::heading(&self.identity, self.columns.clone())?;
        let observations = self.observations.len();
        columnar::write((format, path), &heading, |table| {
            let mut rows = self.rows.iter();
            rows.try_for_each(|row| {
                table.row(columnar::row(row.member, &row.point, &row.outcome, observations))
            })
        })
    }
}

/// The names of the columns of a table.
pub(super) fn head(varied: &[Varied], observations: &[Observation]) -> String {
    let names = varied.iter().map(|varied| varied.name.as_str());
    let observed = observations.iter().map(Observation::text);
    journal::record(["member"].into_iter().chain(names).chain(observed).chain(["failed"]))
}

/// A line of a table, with this many observations.
pub(super) fn line(member: usize, point: &[f64], outcome: &Outcome, observations: usize) -> String {
    let mut fields = vec![member.to_string()];
    fields.extend(point.iter().map(|value| written(*value)));
    fields.extend(journal::written(outcome, observations));
    journal::record(fields)
}
