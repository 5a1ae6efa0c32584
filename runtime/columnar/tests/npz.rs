//! Tables over several batches as NumPy reads them, where there is a Python that has it.

#[path = "../../../models/tests/it/processes/mod.rs"]
mod processes;

use liftoff_columnar::{Column, Format, Heading, Kind, Table, Value};
use processes::{folder, python_with, text};
use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;
use std::process::Command;

/// Every third number is missing, every second text; of the texts every eleventh has letters
/// outside the first plane.
fn write(path: &Path, rows: i64) -> io::Result<()> {
    let columns = [("i", Kind::Integer, None), ("φ̇/2", Kind::Number, Some("rad/s")), ("s", Kind::Text, None)];
    let columns = columns.map(|(name, kind, unit)| Column::new(name, kind, unit));
    let heading = Heading::new(columns.to_vec()).map_err(io::Error::other)?;
    let heading = heading.entry("model", "näher").hashed("declaration", "struct A;");
    let mut file = BufWriter::new(File::create(path)?);
    let mut table = Table::begin(Format::Npz, &heading, &mut file)?;
    for i in 0..rows {
        let long = if i % 11 == 0 { "𝜑 " } else { "" };
        let said = format!("{long}row {i}");
        let number = if i % 3 == 0 { Value::Missing } else { Value::Number(0.1 * i as f64) };
        let said = if i % 2 == 0 { Value::Missing } else { Value::Text(&said) };
        table.row([Value::Integer(i), number, said])?;
    }
    table.finish()
}

/// A batch of three columns has 65536 rows: none, one, one less, as many, one more, and several.
#[test]
fn tables_of_any_length_have_their_rows() {
    let folder = folder("rows");
    let rows = [0, 1, 2, 65_535, 65_536, 65_537, 150_000];
    for count in rows {
        write(&folder.join(format!("{count}.npz")), count).expect("a file");
    }
    let Some(python) = python_with(&["numpy"]) else { return };
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/npz/read.py");
    let output = Command::new(python)
        .current_dir(&folder)
        .arg(script)
        .args(rows.map(|count| count.to_string()))
        .output()
        .expect("Python");
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
}

#[test]
fn a_missing_whole_number_is_refused() {
    let heading = Heading::new(vec![Column::new("i", Kind::Integer, None)]).expect("one name");
    let mut file = Vec::new();
    let mut table = Table::begin(Format::Npz, &heading, &mut file).expect("memory");
    table.row([Value::Missing]).expect("a row");
    let told = table.finish().expect_err("none").to_string();
    assert_eq!(told, "NumPy has no missing whole numbers");
}
