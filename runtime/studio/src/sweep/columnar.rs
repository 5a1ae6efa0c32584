//! The table of a sweep as a columnar file: columns with units, rows, and what the file says of the
//! sweep.

use super::cell::{Cell, Outcome};
use super::journal::Identity;
use super::{Observation, Sweep, SweepError};
use crate::registry::Units;
use liftoff_columnar::{Column, Format, Heading, Kind, Table, Value};
use serde_json::{Value as Json, json};
use std::io;
use std::path::Path;

const KINDS: [(Kind, &str); 3] = [(Kind::Integer, "integer"), (Kind::Number, "number"), (Kind::Text, "text")];

impl Sweep<'_> {
    /// Refuses a sweep whose table would have two columns of one name, which columnar files cannot
    /// have.
    ///
    /// # Errors
    /// The name.
    pub fn check_columns(&self) -> Result<(), SweepError> {
        heading(&self.identity(), self.columns()).map(drop)
    }

    /// The columns of its table.
    pub(super) fn columns(&self) -> Vec<Column> {
        let units = Units::from_layout(self.model().layout());
        let varied = self.varied.iter().map(|varied| number(&varied.name, units.symbol(&varied.name)));
        let observed = self.observations.iter().map(|observation| observed(observation, &units));
        let member = Column::new("member", Kind::Integer, None);
        let failed = Column::new("failed", Kind::Text, None);
        [member].into_iter().chain(varied).chain(observed).chain([failed]).collect()
    }
}

fn observed(observation: &Observation, units: &Units) -> Column {
    match (observation.is_category(), observation.output()) {
        (true, _) => Column::new(observation.text(), Kind::Text, None),
        (false, Some(output)) => number(observation.text(), units.symbol(&output.to_string())),
        (false, None) => number(observation.text(), Some("1".to_owned())),
    }
}

fn number(name: &str, unit: Option<String>) -> Column {
    Column::new(name, Kind::Number, unit.as_deref())
}

/// What a file says of the table of a sweep with this identity.
pub(super) fn heading(identity: &Identity, columns: Vec<Column>) -> Result<Heading, SweepError> {
    let heading = Heading::new(columns).map_err(|twice| SweepError::Invalid(twice.to_string()))?;
    let text = |word: &str| identity.get(word).and_then(Json::as_str).unwrap_or_default();
    Ok(heading
        .entry("version", text("version"))
        .entry("model", text("model"))
        .hashed("declaration", text("declaration"))
        .hashed("sweep", Json::Object(identity.clone()).to_string()))
}

/// Writes a table whose rows `fill` gives, all of it or nothing.
pub(super) fn write(
    (format, path): (Format, &Path),
    heading: &Heading,
    fill: impl FnOnce(&mut Table<'_>) -> io::Result<()>,
) -> Result<(), SweepError> {
    let written = crate::file::replace(path, |out| {
        let mut table = Table::begin(format, heading, out)?;
        fill(&mut table)?;
        table.finish()
    });
    written.map_err(|source| SweepError::File { doing: "write", path: path.to_owned(), source })
}

/// The row of a member, with so many observations.
pub(super) fn row<'a>(
    member: usize,
    point: &'a [f64],
    outcome: &'a Outcome,
    observations: usize,
) -> impl Iterator<Item = Value<'a>> {
    let member = Value::Integer(i64::try_from(member).unwrap_or(i64::MAX));
    let point = point.iter().copied().map(Value::Number);
    let cell = |i: usize| match outcome.as_ref().ok().and_then(|cells| cells.get(i)) {
        Some(Cell::Number(value)) => Value::Number(*value),
        Some(Cell::Name(name)) => Value::Text(name),
        Some(Cell::Missing) | None => Value::Missing,
    };
    let failed = outcome.as_ref().err().map_or(Value::Missing, |reason| Value::Text(reason));
    [member].into_iter().chain(point).chain((0..observations).map(cell)).chain([failed])
}

/// The row that a line of the table is, as it was written; none of another line.
pub(super) fn parse_row<'a>(line: &'a csv::StringRecord, columns: &[Column]) -> Option<Vec<Value<'a>>> {
    let value = |(text, column): (&'a str, &Column)| match (text, column.kind) {
        ("", _) => Some(Value::Missing),
        (text, Kind::Integer) => text.parse().ok().map(Value::Integer),
        (text, Kind::Number) => text.parse().ok().map(Value::Number),
        (text, Kind::Text) => Some(Value::Text(text)),
    };
    (line.len() == columns.len()).then(|| line.iter().zip(columns).map(value).collect())?
}

/// Columns as a word of an identity.
pub(super) fn word(columns: &[Column]) -> Json {
    let kind = |kind: Kind| KINDS.iter().find(|(known, _)| *known == kind).map(|(_, word)| *word);
    columns.iter().map(|column| json!([column.name, kind(column.kind), column.unit])).collect()
}

/// The columns that such a word tells.
pub(super) fn of_word(word: &Json) -> Option<Vec<Column>> {
    let column = |column: &Json| {
        let [name, kind, unit] = &column.as_array()?[..] else { return None };
        let (kind, _) = KINDS.iter().find(|(_, word)| Some(*word) == kind.as_str())?;
        Some(Column::new(name.as_str()?, *kind, unit.as_str()))
    };
    word.as_array()?.iter().map(column).collect()
}
