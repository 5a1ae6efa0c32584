//! What was measured, as options have it.

use super::table::Table;
use crate::CommandError;
use crate::options::values::measured;
use liftoff::Output;
use liftoff_analysis::{Datum, Place};
use liftoff_core::model::Layout;
use liftoff_studio::registry::Units;
use liftoff_studio::sweep::Observation;
use std::path::Path;

/// What stands before a standard deviation, in any typing.
const DEVIATIONS: [&str; 2] = ["±", "+-"];

/// Measured values.
#[derive(Default, Debug)]
pub struct Measured {
    pub data: Vec<Datum>,
    /// Of each, what it is a value of: a column, or an output behind events.
    pub kinds: Vec<String>,
    /// Of each, whether its standard deviation is known.
    known: Vec<bool>,
    /// Empty cells.
    pub skipped: usize,
    /// The last row of the table that has a value: its line, and its time.
    pub last: Option<(u64, f64)>,
}

impl Measured {
    /// Whether standard deviations are given.
    pub fn is_weighed(&self) -> bool {
        self.known.iter().all(|known| *known)
    }

    /// The values of a table's columns.
    pub fn add_table(
        &mut self,
        layout: &'static Layout,
        path: &Path,
        of: &[String],
        deviations: &[String],
    ) -> Result<(), CommandError> {
        let units = Units::from_layout(layout);
        let deviations: Vec<(String, f64)> =
            deviations.iter().map(|text| deviation(&units, text)).collect::<Result<_, _>>()?;
        let names = || deviations.iter().map(|(name, _)| name);
        if let Some((_, name)) =
            names().enumerate().find(|(k, name)| names().take(*k).any(|known| known == *name))
        {
            return Err(CommandError::Usage(format!("--sd {name} is given twice")));
        }
        let table = Table::load(layout, path, of)?;
        let names = || table.columns.iter().map(|column| column.name.as_str());
        if let Some((name, _)) = deviations.iter().find(|(name, _)| names().all(|known| known != name)) {
            let known = names().collect::<Vec<_>>().join(", ");
            return Err(CommandError::Usage(format!(
                "--sd {name}: no such column is fitted; there are {known}"
            )));
        }
        for row in &table.rows {
            for (column, cell) in table.columns.iter().zip(&row.cells) {
                let Some((value, own)) = *cell else {
                    self.skipped += 1;
                    continue;
                };
                let of_column = deviations.iter().find(|(name, _)| *name == column.name);
                let known = own.or(of_column.map(|(_, deviation)| *deviation));
                self.add(Place::Time(row.t), Some(column.output.clone()), (value, known), &column.name);
                self.last = Some((row.line, row.t));
            }
        }
        match self.last {
            Some(_) => Ok(()),
            None => Err(CommandError::Usage(format!("{} has no values", path.display()))),
        }
    }

    /// `first open=0.4531`, `2nd impact phi=0.3±0.01`.
    pub fn add_event(&mut self, layout: &'static Layout, text: &str) -> Result<(), CommandError> {
        let wrong = |why: &str| CommandError::Usage(format!("--event {text}: {why}"));
        let (what, value) = text.rsplit_once('=').ok_or_else(|| wrong("expected WHAT=VALUE"))?;
        let parts = DEVIATIONS.iter().find_map(|sign| value.split_once(sign));
        let (value, known) = parts.map_or((value, None), |(value, known)| (value, Some(known)));
        let observation = Observation::parse(what, layout).map_err(|error| wrong(&error.to_string()))?;
        let Some((which, filter, output)) = observation.event() else {
            return Err(wrong(
                "expected an event, `first open`, `2nd impact A`, `last stick`, or an output after it",
            ));
        };
        let kind = output.map_or("t".to_owned(), ToString::to_string);
        let units = Units::from_layout(layout);
        let number = |text: &str| measured(&units, &kind, text).map_err(|why| wrong(&why));
        let (value, known) = (number(value)?, known.map(number).transpose()?);
        if !value.is_finite() {
            return Err(wrong("the value is not finite"));
        }
        if known.is_some_and(|known| !is_deviation(known)) {
            return Err(wrong("a standard deviation is a number > 0"));
        }
        if output.is_none() && value < 0.0 {
            return Err(wrong("it is before the start at t = 0"));
        }
        self.add(Place::Event(which, filter), output.cloned(), (value, known), &kind);
        Ok(())
    }

    fn add(&mut self, place: Place, output: Option<Output>, (value, known): (f64, Option<f64>), kind: &str) {
        self.data.push(Datum { place, output, value, deviation: known.unwrap_or(1.0) });
        self.known.push(known.is_some());
        self.kinds.push(kind.to_owned());
    }

    /// Refuses values that cannot be compared with one another: of several kinds, without standard deviations.
    pub fn weighed(self) -> Result<Self, CommandError> {
        let unknown = self.known.iter().position(|known| !known);
        let other = unknown.and_then(|k| {
            let differs = |i: &usize| self.kinds[*i] != self.kinds[k] || self.known[*i];
            (0..self.kinds.len()).find(differs).map(|i| [k, i])
        });
        let Some([k, i]) = other else { return Ok(self) };
        let [without, beside] = [&self.kinds[k], &self.kinds[i]];
        let gives = "--sd COLUMN=VALUE, a column `COLUMN ±`, or `±` after the value of an event gives it";
        Err(CommandError::Usage(format!(
            "a value of `{without}` has no standard deviation, but is fitted with a value of `{beside}`: {gives}"
        )))
    }
}

/// `COLUMN=VALUE` of a standard deviation.
fn deviation(units: &Units, text: &str) -> Result<(String, f64), CommandError> {
    let wrong = |why: &str| CommandError::Usage(format!("--sd {text}: {why}"));
    let (name, value) = text.rsplit_once('=').ok_or_else(|| wrong("expected COLUMN=VALUE"))?;
    let value = measured(units, name, value).map_err(|why| wrong(&why))?;
    let value = Some(value).filter(|value| is_deviation(*value));
    Ok((name.trim().to_owned(), value.ok_or_else(|| wrong("a standard deviation is a number > 0"))?))
}

pub(super) fn is_deviation(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}
