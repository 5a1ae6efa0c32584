//! A table of measured series.

use super::Failure;
use crate::registry::Units;
use liftoff::Output;
use liftoff_core::model::Layout;
use std::path::Path;

/// What follows the name of a column in that of its standard deviations.
const DEVIATION: &str = " ±";

/// Series, row by row.
pub struct MeasuredTable {
    pub(super) columns: Vec<Column>,
    pub(super) rows: Vec<DataRow>,
    /// The place of the times, and their unit in SI units.
    time: (usize, f64),
    /// The last time that is there twice.
    jumped: Option<f64>,
}

/// A column that is fitted.
pub(super) struct Column {
    pub name: String,
    pub output: Output,
    place: usize,
    /// Its unit in SI units.
    factor: f64,
    /// The place of its standard deviations, and their unit in SI units.
    deviations: Option<(usize, f64)>,
}

/// Values at a time.
pub(super) struct DataRow {
    /// Counted from 1, the head among them.
    pub line: u64,
    pub t: f64,
    /// Of each column, with its standard deviation where it has one; none of an empty cell.
    pub cells: Vec<Option<(f64, Option<f64>)>>,
}

impl MeasuredTable {
    /// One with these columns, of which it takes those that are asked for, by default all.
    ///
    /// # Errors
    /// There are no times; a column is no output, or is not there.
    pub fn new(layout: &'static Layout, head: &[&str], of: &[String]) -> Result<Self, String> {
        let head = Head::parse(layout, head);
        let time = head.find_place("t").ok_or_else(|| {
            let names: Vec<String> = head.names.iter().map(|name| format!("`{name}`")).collect();
            format!("there is no column `t` among {}", names.join(", "))
        })?;
        let time = (time, head.factor(time, "t")?);
        Ok(Self { columns: head.select(layout, of)?, rows: Vec::new(), time, jumped: None })
    }

    /// Adds a row, by the cells at the places of its columns; none of an empty one.
    ///
    /// # Errors
    /// A cell is no number that it can be; the row does not come after the one before.
    pub fn push(
        &mut self,
        line: u64,
        cell: &dyn Fn(usize) -> Result<Option<f64>, String>,
    ) -> Result<(), String> {
        let number = |place: usize, name: &str| match cell(place).map_err(|why| format!("{name}: {why}"))? {
            Some(value) if !value.is_finite() => Err(format!("{name}: {value} is not finite")),
            value => Ok(value),
        };
        let missing = |name: &str| format!("{name}: `` is no number");
        let (time, second) = self.time;
        let t = second * number(time, "t")?.ok_or_else(|| missing("t"))?;
        if t < 0.0 {
            return Err(format!("t = {t} is before the start, at t = 0"));
        }
        let cell = |column: &Column| {
            let Some(value) = number(column.place, &column.name)? else { return Ok(None) };
            let value = value * column.factor;
            let Some((place, factor)) = column.deviations else { return Ok(Some((value, None))) };
            let name = format!("{}{DEVIATION}", column.name);
            let deviation = number(place, &name)?.ok_or_else(|| missing(&name))?;
            check_deviation(deviation).map_err(|why| format!("{name}: {why}"))?;
            Ok(Some((value, Some(deviation * factor))))
        };
        let cells = self.columns.iter().map(cell).collect::<Result<_, String>>()?;
        // The side before an impact, as `run --csv` has it: a series has the side after.
        let jumps = self.rows.pop_if(|before| before.t == t).is_some();
        if jumps && self.jumped.replace(t) == Some(t) {
            return Err(format!("t = {t} is there three times"));
        }
        if let Some(before) = self.rows.last().filter(|before| t <= before.t) {
            return Err(format!("t = {t} does not come after t = {}", before.t));
        }
        self.rows.push(DataRow { line, t, cells });
        Ok(())
    }

    /// That of a file, with values separated by commas.
    ///
    /// # Errors
    /// It cannot be read; as for [`Self::new`] and [`Self::push`].
    pub fn load(layout: &'static Layout, path: &Path, of: &[String]) -> Result<Self, Failure> {
        let told = path.display();
        let unreadable = |error: &csv::Error| Failure::NotFound(format!("cannot read {told}: {error}"));
        let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_path(path);
        let reader = reader.as_mut().map_err(|error| unreadable(error))?;
        let head = reader.headers().map_err(|error| unreadable(&error))?.clone();
        let usage = |why: String| Failure::Input(format!("{told}{why}"));
        if head.is_empty() {
            let why = " is empty: the first line must be a header with a column `t`, separated by commas";
            return Err(usage(why.to_owned()));
        }
        let names: Vec<&str> = head.iter().collect();
        let commas =
            if Head::parse(layout, &names).find_place("t").is_some() { "" } else { ", separated by commas" };
        let table = Self::new(layout, &names, of).map_err(|why| usage(format!(": {why}{commas}")));
        let mut table = table?;
        for record in reader.records() {
            let record = record.map_err(|error| unreadable(&error))?;
            let line = record.position().map_or(0, csv::Position::line);
            let pushed = match record.len() == head.len() {
                true => table.push(line, &|place| parse(&record[place])),
                false => Err(format!("{} cells, but the header has {}", record.len(), head.len())),
            };
            pushed.map_err(|why| usage(format!(", line {line}: {why}")))?;
        }
        Ok(table)
    }
}

/// The number of a cell; none of an empty one.
fn parse(text: &str) -> Result<Option<f64>, String> {
    match text {
        "" => Ok(None),
        text => text.parse().map(Some).map_err(|_| format!("`{text}` is no number")),
    }
}

/// The head of a table: outputs, each with its unit where one is given, `phi [deg]`, `phi [deg] ±`.
struct Head {
    units: Units,
    names: Vec<String>,
    given: Vec<Option<String>>,
}

impl Head {
    fn parse(layout: &'static Layout, head: &[&str]) -> Self {
        let split = |text: &&str| {
            let (text, sign) = text.strip_suffix(DEVIATION).map_or((*text, ""), |text| (text, DEVIATION));
            let parts = text.strip_suffix(']').and_then(|text| text.rsplit_once(" ["));
            let (name, unit) = parts.map_or((text, None), |(name, unit)| (name, Some(unit.to_owned())));
            (format!("{}{sign}", name.trim_end()), unit)
        };
        let (names, given) = head.iter().map(split).unzip();
        Self { units: Units::from_layout(layout), names, given }
    }

    fn find_place(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    /// The unit of the column at a place in SI units, of which the output of this name is measured;
    /// 1 where none is given.
    fn factor(&self, place: usize, name: &str) -> Result<f64, String> {
        let given = self.given[place].as_ref().filter(|given| self.units.unit(name).as_ref() != Some(given));
        let Some(given) = given else { return Ok(1.0) };
        let factor = self.units.measure(name, &format!("1 {given}"));
        factor.map_err(|why| format!("column `{}`: {why}", self.names[place]))
    }

    /// The columns of these names, by default all.
    fn select(&self, layout: &'static Layout, of: &[String]) -> Result<Vec<Column>, String> {
        let twice = self.names.iter().enumerate().find(|(k, name)| self.find_place(name) != Some(*k));
        if let Some((_, name)) = twice {
            return Err(format!("the column `{name}` is there twice"));
        }
        let is_measured = |name: &&str| *name != "t" && !name.ends_with(DEVIATION);
        let all: Vec<&str> = self.names.iter().map(String::as_str).filter(is_measured).collect();
        let is_repeated = |k: usize, name: &String| of[..k].contains(name);
        if let Some((_, name)) = of.iter().enumerate().find(|(k, name)| is_repeated(*k, name)) {
            return Err(format!("--of {name} is given twice"));
        }
        let of_none = |name: &&String| name.strip_suffix(DEVIATION).is_some_and(|of| !all.contains(&of));
        if let Some(name) = self.names.iter().find(of_none) {
            let why = "there is no column with values for these standard deviations";
            return Err(format!("column `{name}`: {why}"));
        }
        let names = if of.is_empty() { all.clone() } else { of.iter().map(String::as_str).collect() };
        let column = |name: &str| {
            let found = self.find_place(name).filter(|_| all.contains(&name));
            let place = found.ok_or_else(|| format!("no column `{name}`; there are {}", all.join(", ")))?;
            let output = Output::parse(layout, name);
            let output =
                output.map_err(|why| format!("column `{name}`: {why}; --of COLUMN leaves others out"))?;
            let factor = self.factor(place, name)?;
            let deviations = self.find_place(&format!("{name}{DEVIATION}"));
            let deviations = deviations.map(|of| {
                let is_given = self.given[of].is_some();
                Ok::<_, String>((of, if is_given { self.factor(of, name)? } else { factor }))
            });
            let deviations = deviations.transpose()?;
            Ok(Column { name: name.to_owned(), output, place, factor, deviations })
        };
        if names.is_empty() {
            return Err("there is no column beside `t`".to_owned());
        }
        names.into_iter().map(column).collect()
    }
}

/// Refuses what is no standard deviation.
///
/// # Errors
/// It is none.
pub fn check_deviation(value: f64) -> Result<(), String> {
    match value > 0.0 && value.is_finite() {
        true => Ok(()),
        false => Err("a standard deviation is a number > 0".to_owned()),
    }
}
