//! Rows in files.

use super::WorkPrecisionRow;
use liftoff_verification::precision::check_tolerance;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

/// A file that cannot be read or written.
#[derive(thiserror::Error, Debug)]
pub enum FileError {
    /// What the file system says, or what is no table.
    #[error("cannot {what} {}: {source}", path.display())]
    File {
        /// `read` or `write`.
        what: &'static str,
        /// Path of the file.
        path: PathBuf,
        /// What is wrong.
        source: csv::Error,
    },
    /// A row of numbers that no measurement has.
    #[error("{}, row {row}: {reason}", path.display())]
    Row {
        /// Path of the file.
        path: PathBuf,
        /// Counted from 1, the head not among them.
        row: usize,
        /// What is wrong.
        reason: String,
    },
    /// A table without rows.
    #[error("{} has no rows", .0.display())]
    Empty(PathBuf),
}

/// Bytes of a table.
const LARGEST: u64 = 64 << 20;
/// Errors and times that measurements have: in their units, with much room.
const LIKELY: RangeInclusive<f64> = 1e-60..=1e60;

/// Writes rows as CSV.
pub fn written(rows: &[WorkPrecisionRow], path: &Path) -> Result<(), FileError> {
    let failed = |source| FileError::File { what: "write", path: path.to_owned(), source };
    let mut table = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| table.serialize(row)).map_err(failed)?;
    let table = table.into_inner().map_err(|error| failed(error.into_error().into()))?;
    crate::file::write(path, table).map_err(|error| failed(error.into()))
}

/// A line as scripts of other tools print it. On `fig1a` the error is that of the first event, on
/// others of the state.
#[derive(serde::Deserialize)]
struct Line {
    scene: String,
    tolerance: f64,
    error: f64,
    end_error: Option<f64>,
    microseconds: f64,
}

/// Rows of another tool, named after the file, from CSV with the columns
/// `scene,tolerance,error,end_error,microseconds`. The scene `fig1a` is the model `falling-pair`:
/// its `error` is that of the lift-off, `end_error` that of the end, both times.
pub fn peers(path: &Path) -> Result<Vec<WorkPrecisionRow>, FileError> {
    let failed = |source| FileError::File { what: "read", path: path.to_owned(), source };
    let tool = path.file_stem().map_or("peer".into(), |stem| stem.to_string_lossy().into_owned());
    let text = crate::file::read_file(path, LARGEST).map_err(|error| failed(error.into()))?;
    let mut file = csv::Reader::from_reader(&text[..]);
    let row = |line: Line| {
        let timed = line.scene == "fig1a";
        let scene = if timed { "falling-pair" } else { &line.scene };
        let errors = match timed {
            true => [None, Some(line.end_error.map_or(line.error, |end| end.max(line.error)))],
            false => [Some(line.error), line.end_error],
        };
        WorkPrecisionRow::peer((scene, &tool, line.tolerance), errors, line.microseconds)
    };
    let lines: Vec<Line> = file.deserialize().collect::<Result<_, _>>().map_err(failed)?;
    for (i, line) in lines.iter().enumerate() {
        line.check().map_err(|reason| FileError::Row { path: path.to_owned(), row: i + 1, reason })?;
    }
    match lines.is_empty() {
        true => Err(FileError::Empty(path.to_owned())),
        false => Ok(lines.into_iter().map(row).collect()),
    }
}

impl Line {
    fn check(&self) -> Result<(), String> {
        check_tolerance(self.tolerance).map_err(|error| error.to_string())?;
        for (name, error) in [("error", Some(self.error)), ("end_error", self.end_error)] {
            if let Some(error) = error.filter(|error| *error != 0.0 && !LIKELY.contains(error)) {
                return Err(format!("{name} {error:e} is no error that is measured"));
            }
        }
        match LIKELY.contains(&self.microseconds) {
            true => Ok(()),
            false => Err(format!("{:e} µs is no time that is measured", self.microseconds)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(name: &str, text: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("liftoff-{}-{name}.csv", std::process::id()));
        std::fs::write(&path, text).expect("written");
        path
    }

    #[test]
    fn rows_of_another_tool_are_read() {
        let text = "scene,tolerance,error,end_error,microseconds\ndouble-pendulum,1e-06,6e-6,,128\n\
                    fig1a,1e-08,5.00e-11,6e-11,17.8\n";
        let path = file("tool", text);
        let rows = peers(&path).expect("rows");
        std::fs::remove_file(&path).expect("removed");
        assert!(rows[0].method.ends_with("-tool") && rows[0].is_peer);
        assert_eq!((rows[0].state_error, rows[0].event_error), (Some(6e-6), None));
        assert_eq!((rows[1].model.as_str(), rows[1].event_error), ("falling-pair", Some(6e-11)));
        assert_eq!(rows[1].microseconds, 17.8);
    }

    #[test]
    fn invalid_measurements_are_reported_with_their_row() {
        let head = "scene,tolerance,error,end_error,microseconds\nladder,1e-6,0,,10\n";
        for (line, told) in [
            ("ladder,1e-6,1e-320,,10", "row 2: error 1e-320 is no error"),
            ("ladder,1e-6,1e300,,10", "row 2: error 1e300"),
            ("ladder,1e-6,NaN,,10", "row 2: error NaN"),
            ("ladder,1e-6,1e-6,-1,10", "row 2: end_error -1e0"),
            ("ladder,-1,1e-6,,10", "row 2: tolerance -1 is not between 0 and 1"),
            ("ladder,inf,1e-6,,10", "row 2: tolerance inf"),
            ("ladder,1e-6,1e-6,,0", "row 2: 0e0 µs is no time"),
            ("ladder,1e-6,1e-6,,1e300", "row 2: 1e300 µs"),
        ] {
            let path = file("row", &format!("{head}{line}\n"));
            let error = peers(&path).expect_err("no rows").to_string();
            assert!(error.contains(told) && !error.contains('\n'), "{error}");
            std::fs::remove_file(&path).expect("removed");
        }
        let path = file("empty", "scene,tolerance,error,end_error,microseconds\n");
        assert!(peers(&path).expect_err("no rows").to_string().ends_with(" has no rows"));
        std::fs::remove_file(&path).expect("removed");
    }

    #[test]
    fn invalid_tables_are_reported_with_their_file() {
        let path = file("none", "scene,tolerance\nfig1a,fine\n");
        let error = peers(&path).expect_err("no table").to_string();
        std::fs::remove_file(&path).expect("removed");
        assert!(error.starts_with("cannot read ") && error.contains("-none.csv"), "{error}");
    }
}
