//! What was measured.

use super::table::{MeasuredTable, check_deviation};
use crate::run_spec::RunSpec;
use crate::sweep::Observation;
use liftoff::__private::event::Occurrence;
use liftoff::{EventFilter, Output};
use liftoff_analysis::{Datum, Place};
use liftoff_core::model::Layout;

/// Measured values.
#[derive(Default, Debug)]
pub struct Measured {
    /// The values.
    pub data: Vec<Datum>,
    /// Of each, what it is a value of: a column, or an output behind events.
    kinds: Vec<String>,
    /// Of each, whether its standard deviation is known.
    known: Vec<bool>,
    /// Empty cells.
    pub skipped: usize,
    /// The last row of the table that has a value: its line, and its time.
    pub last: Option<(u64, f64)>,
}

/// An event whose time is measured, or an output after it.
pub struct MeasuredEvent {
    which: Occurrence,
    filter: EventFilter,
    output: Option<Output>,
}

impl MeasuredEvent {
    /// `first open`, `2nd impact phi`.
    ///
    /// # Errors
    /// It is none.
    pub fn parse(text: &str, layout: &'static Layout) -> Result<Self, String> {
        let observation = Observation::parse(text, layout).map_err(|error| error.to_string())?;
        let (which, filter, output) = observation
            .event()
            .ok_or("expected an event, `first open`, `2nd impact A`, `last stick`, or an output after it")?;
        Ok(Self { which, filter, output: output.cloned() })
    }

    /// The output whose unit its values have.
    pub fn kind(&self) -> String {
        self.output.as_ref().map_or("t".to_owned(), ToString::to_string)
    }
}

impl Measured {
    /// Whether standard deviations are given.
    pub fn is_weighed(&self) -> bool {
        self.known.iter().all(|known| *known)
    }

    /// Adds the values of a table; `deviations` of columns that have none of their own.
    ///
    /// # Errors
    /// A standard deviation of no column, or that is none.
    pub fn add_table(&mut self, table: &MeasuredTable, deviations: &[(String, f64)]) -> Result<(), String> {
        let names = || table.columns.iter().map(|column| column.name.as_str());
        for (name, deviation) in deviations {
            if names().all(|known| known != name) {
                let known = names().collect::<Vec<_>>().join(", ");
                return Err(format!("{name}: no such column is fitted; there are {known}"));
            }
            check_deviation(*deviation).map_err(|why| format!("{name}={deviation}: {why}"))?;
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
        Ok(())
    }

    /// Adds the value of an event, with its standard deviation where that is known.
    ///
    /// # Errors
    /// They are no numbers that it can have.
    pub fn add_event(
        &mut self,
        event: MeasuredEvent,
        value: f64,
        deviation: Option<f64>,
    ) -> Result<(), String> {
        if !value.is_finite() {
            return Err("the value is not finite".to_owned());
        }
        deviation.map_or(Ok(()), check_deviation)?;
        if event.output.is_none() && value < 0.0 {
            return Err("it is before the start at t = 0".to_owned());
        }
        let kind = event.kind();
        self.add(Place::Event(event.which, event.filter), event.output, (value, deviation), &kind);
        Ok(())
    }

    fn add(&mut self, place: Place, output: Option<Output>, (value, known): (f64, Option<f64>), kind: &str) {
        self.data.push(Datum { place, output, value, deviation: known.unwrap_or(1.0) });
        self.known.push(known.is_some());
        self.kinds.push(kind.to_owned());
    }

    /// Refuses values that cannot be compared with one another: of several kinds, without standard
    /// deviations; and those after a limit that is given.
    ///
    /// # Errors
    /// Which they are; `gives` says how to give a standard deviation.
    pub fn check(&self, limit: Option<f64>, gives: &str) -> Result<(), String> {
        if let (Some(limit), Some((line, t))) = (limit, self.last)
            && t > limit
        {
            return Err(format!("line {line} of the table: t = {t} is after the limit {limit}"));
        }
        let unknown = self.known.iter().position(|known| !known);
        let other = unknown.and_then(|k| {
            let differs = |i: &usize| self.kinds[*i] != self.kinds[k] || self.known[*i];
            (0..self.kinds.len()).find(differs).map(|i| [k, i])
        });
        let Some([k, i]) = other else { return Ok(()) };
        let [without, beside] = [&self.kinds[k], &self.kinds[i]];
        Err(format!(
            "a value of `{without}` has no standard deviation, but is fitted with a value of `{beside}`: {gives}"
        ))
    }

    /// The run, as long as there are data: what ends a model's default run does not end that of a
    /// series.
    pub fn lengthen(&self, mut spec: RunSpec, has_until: bool) -> RunSpec {
        if let Some(last) = self.data.iter().filter_map(|datum| datum.place.time()).reduce(f64::max) {
            if !has_until {
                spec.until.clear();
            }
            spec.limit = spec.limit.map(|limit| limit.max(last));
        }
        spec
    }
}
