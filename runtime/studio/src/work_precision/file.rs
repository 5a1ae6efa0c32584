//! Rows in files.

use super::WorkPrecisionRow;
use std::path::{Path, PathBuf};

/// A file that cannot be read or written.
#[derive(thiserror::Error, Debug)]
#[error("cannot {what} {path}: {source}")]
pub struct FileError {
    what: &'static str,
    path: PathBuf,
    source: csv::Error,
}

/// Writes rows as CSV.
pub fn written(rows: &[WorkPrecisionRow], path: &Path) -> Result<(), FileError> {
    let failed = |source| FileError { what: "write", path: path.to_owned(), source };
    let mut table = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| table.serialize(row)).map_err(failed)?;
    let table = table.into_inner().map_err(|error| failed(error.into_error().into()))?;
    crate::file::write(path, table).map_err(|error| failed(error.into()))
}

/// A line as scripts of other tools print it. On `fig1a` the error is that of the first event, on others of the state.
#[derive(serde::Deserialize)]
struct Line {
    scene: String,
    tolerance: f64,
    error: f64,
    end_error: Option<f64>,
    microseconds: f64,
}

/// Rows of another tool, named after the file, from CSV with the columns `scene,tolerance,error,end_error,microseconds`.
/// The scene `fig1a` is the model `falling-pair`: its `error` is that of the lift-off, `end_error` that of the end, both
/// times.
pub fn peers(path: &Path) -> Result<Vec<WorkPrecisionRow>, FileError> {
    let failed = |source| FileError { what: "read", path: path.to_owned(), source };
    let tool = path.file_stem().map_or("peer".into(), |stem| stem.to_string_lossy().into_owned());
    let mut file = csv::Reader::from_path(path).map_err(failed)?;
    let row = |line: Line| {
        let timed = line.scene == "fig1a";
        let scene = if timed { "falling-pair" } else { &line.scene };
        let errors = match timed {
            true => [None, Some(line.end_error.map_or(line.error, |end| end.max(line.error)))],
            false => [Some(line.error), line.end_error],
        };
        WorkPrecisionRow::peer((scene, &tool, line.tolerance), errors, line.microseconds)
    };
    file.deserialize().map(|line| line.map(row).map_err(failed)).collect()
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
    fn what_is_no_table_is_told_with_its_file() {
        let path = file("none", "scene,tolerance\nfig1a,fine\n");
        let error = peers(&path).expect_err("no table").to_string();
        std::fs::remove_file(&path).expect("removed");
        assert!(error.starts_with("cannot read ") && error.contains("-none.csv"), "{error}");
    }
}
