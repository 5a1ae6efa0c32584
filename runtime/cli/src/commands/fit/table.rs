//! A table of measured series.

use super::data::is_deviation;
use crate::CommandError;
use csv::StringRecord;
use liftoff::Output;
use liftoff_core::model::Layout;
use std::path::Path;

/// What follows the name of a column in that of its standard deviations.
const DEVIATION: &str = " ±";

/// Series, row by row.
pub struct Table {
    pub columns: Vec<Column>,
    pub rows: Vec<DataRow>,
}

/// A column that is fitted.
pub struct Column {
    pub name: String,
    pub output: Output,
    place: usize,
    /// The place of its standard deviations.
    deviations: Option<usize>,
}

/// Values at a time.
pub struct DataRow {
    /// Counted from 1, the head among them.
    pub line: u64,
    pub t: f64,
    /// Of each column, with its standard deviation where it has one; none of an empty cell.
    pub cells: Vec<Option<(f64, Option<f64>)>>,
}

impl Table {
    /// Those of these columns, by default of all.
    pub fn load(layout: &'static Layout, path: &Path, of: &[String]) -> Result<Self, CommandError> {
        let told = path.display();
        let unreadable = |error: csv::Error| CommandError::Failed(format!("cannot read {told}: {error}"));
        let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_path(path);
        let reader =
            reader.as_mut().map_err(|error| CommandError::Failed(format!("cannot read {told}: {error}")))?;
        let head = reader.headers().map_err(unreadable)?.clone();
        let usage = |why: String| CommandError::Usage(format!("{told}{why}"));
        let time = head.iter().position(|name| name == "t");
        let time = time.ok_or_else(|| usage(without_time(&head)))?;
        let columns = columns(layout, &head, of).map_err(|why| usage(format!(": {why}")))?;
        let (mut rows, mut jumped): (Vec<DataRow>, Option<f64>) = (Vec::new(), None);
        for record in reader.records() {
            let record = record.map_err(unreadable)?;
            let line = record.position().map_or(0, csv::Position::line);
            let row = row(&record, (head.len(), line, time), &columns);
            let row = row.map_err(|why| usage(format!(", line {line}: {why}")))?;
            // The side before an impact, as `run --csv` has it: a series has the side after.
            let jumps = rows.pop_if(|before| before.t == row.t).is_some();
            if jumps && jumped.replace(row.t) == Some(row.t) {
                return Err(usage(format!(", line {line}: t = {} is there three times", row.t)));
            }
            if let Some(before) = rows.last().filter(|before| row.t <= before.t) {
                return Err(usage(format!(
                    ", line {line}: t = {} does not come after t = {}",
                    row.t, before.t
                )));
            }
            rows.push(row);
        }
        Ok(Self { columns, rows })
    }
}

fn without_time(head: &StringRecord) -> String {
    let names: Vec<String> = head.iter().map(|name| format!("`{name}`")).collect();
    match names.is_empty() {
        true => {
            " is empty: the first line must be a header with a column `t`, separated by commas".to_owned()
        }
        false => format!(": there is no column `t` among {}, separated by commas", names.join(", ")),
    }
}

fn columns(layout: &'static Layout, head: &StringRecord, of: &[String]) -> Result<Vec<Column>, String> {
    let place = |name: &str| head.iter().position(|known| known == name);
    let twice = head.iter().enumerate().find(|(k, name)| place(name) != Some(*k));
    if let Some((_, name)) = twice {
        return Err(format!("the column `{name}` is there twice"));
    }
    let is_measured = |name: &&str| *name != "t" && !name.ends_with(DEVIATION);
    let all: Vec<&str> = head.iter().filter(is_measured).collect();
    if let Some(name) = of.iter().enumerate().find_map(|(k, name)| of[..k].contains(name).then_some(name)) {
        return Err(format!("--of {name} is given twice"));
    }
    let of_none = |name: &&str| name.strip_suffix(DEVIATION).is_some_and(|of| !all.contains(&of));
    if let Some(name) = head.iter().find(of_none) {
        return Err(format!("column `{name}`: there is no column with values for these standard deviations"));
    }
    let names = if of.is_empty() { all.clone() } else { of.iter().map(String::as_str).collect() };
    let column = |name: &str| {
        let found = place(name).filter(|_| all.contains(&name));
        let found = found.ok_or_else(|| format!("no column `{name}`; there are {}", all.join(", ")))?;
        let output = Output::parse(layout, name);
        let output =
            output.map_err(|why| format!("column `{name}`: {why}; --of COLUMN leaves others out"))?;
        let deviations = place(&format!("{name}{DEVIATION}"));
        Ok(Column { name: name.to_owned(), output, place: found, deviations })
    };
    if names.is_empty() {
        return Err("there is no column beside `t`".to_owned());
    }
    names.into_iter().map(column).collect()
}

fn row(
    record: &StringRecord,
    (width, line, time): (usize, u64, usize),
    columns: &[Column],
) -> Result<DataRow, String> {
    if record.len() != width {
        return Err(format!("{} cells, but the header has {width}", record.len()));
    }
    let number = |place: usize, name: &str| {
        let text = &record[place];
        let value = text.parse().map_err(|_| format!("{name}: `{text}` is no number"))?;
        if f64::is_finite(value) { Ok(value) } else { Err(format!("{name}: {text} is not finite")) }
    };
    let t = number(time, "t")?;
    if t < 0.0 {
        return Err(format!("t = {t} is before the start, at t = 0"));
    }
    let cell = |column: &Column| {
        if record[column.place].is_empty() {
            return Ok(None);
        }
        let value = number(column.place, &column.name)?;
        let Some(place) = column.deviations else { return Ok(Some((value, None))) };
        let name = format!("{}{DEVIATION}", column.name);
        let deviation = Some(number(place, &name)?).filter(|deviation| is_deviation(*deviation));
        let deviation = deviation.ok_or_else(|| format!("{name}: a standard deviation is a number > 0"))?;
        Ok(Some((value, Some(deviation))))
    };
    Ok(DataRow { line, t, cells: columns.iter().map(cell).collect::<Result<_, String>>()? })
}
