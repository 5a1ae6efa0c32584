//! Rows over several batches, rows that do not fit, files that cannot be written. What files say is
//! read by other programs in the tests of the command line.

use crate::{Column, Format, Heading, Kind, Table, Value};
use std::io::{self, ErrorKind, Write};

/// What this build has.
fn formats() -> impl Iterator<Item = Format> {
    [Format::Parquet, Format::Arrow, Format::Npz].into_iter().filter(|format| format.check().is_ok())
}

fn heading() -> Heading {
    let columns = [("i", Kind::Integer, None), ("x", Kind::Number, Some("m")), ("s", Kind::Text, None)];
    let columns = columns.map(|(name, kind, unit)| Column::new(name, kind, unit));
    Heading::new(columns.to_vec()).expect("three names").hashed("declaration", "struct A;")
}

/// Every third number is missing, every second text.
fn row(i: usize, text: &str) -> [Value<'_>; 3] {
    let number = if i.is_multiple_of(3) { Value::Missing } else { Value::Number(0.1 * i as f64) };
    let text = if i.is_multiple_of(2) { Value::Missing } else { Value::Text(text) };
    [Value::Integer(i as i64), number, text]
}

fn written(format: Format, rows: usize, out: &mut (dyn Write + Send)) -> io::Result<()> {
    let heading = heading();
    let mut table = Table::begin(format, &heading, out)?;
    for i in 0..rows {
        table.row(row(i, &format!("text {i}")))?;
    }
    table.finish()
}

/// A batch of three columns has 65536 rows: none, one less, one, one more, and several.
#[cfg(feature = "parquet")]
#[test]
fn tables_of_any_length_have_their_rows() {
    use arrow_array::cast::AsArray;
    use arrow_array::types::{Float64Type, Int64Type};
    for rows in [0, 1, 65_535, 65_536, 65_537, 150_000] {
        let mut file = Vec::new();
        written(Format::Arrow, rows, &mut file).expect("memory");
        let reader =
            arrow_ipc::reader::FileReader::try_new(io::Cursor::new(file), None).expect("an Arrow file");
        let mut at = 0;
        for batch in reader {
            let batch = batch.expect("a batch");
            let (i, x) =
                (batch.column(0).as_primitive::<Int64Type>(), batch.column(1).as_primitive::<Float64Type>());
            let s = batch.column(2).as_string::<i32>();
            for k in 0..batch.num_rows() {
                let there = |is: bool| is.then_some(());
                assert_eq!(i.value(k), at as i64);
                assert_eq!(
                    there(arrow_array::Array::is_valid(x, k)).map(|()| x.value(k)),
                    there(at % 3 != 0).map(|()| 0.1 * at as f64)
                );
                let text = there(arrow_array::Array::is_valid(s, k)).map(|()| s.value(k).to_owned());
                assert_eq!(text, there(at % 2 != 0).map(|()| format!("text {at}")));
                at += 1;
            }
        }
        assert_eq!(at, rows);
        let mut file = Vec::new();
        written(Format::Parquet, rows, &mut file).expect("memory");
        assert!(file.starts_with(b"PAR1") && file.ends_with(b"PAR1"));
    }
}

#[test]
fn rows_that_do_not_fit_are_reported_by_column() {
    for format in formats() {
        let told = |row: &[Value<'_>]| {
            let (heading, mut file) = (heading(), Vec::new());
            let mut table = Table::begin(format, &heading, &mut file).expect("memory");
            let error = table.row(row.iter().copied()).expect_err("a misfit");
            assert_eq!(error.kind(), ErrorKind::InvalidInput);
            error.to_string()
        };
        let [i, x, s] = row(1, "a");
        assert_eq!(told(&[i, x]), "a row has nothing for `s`");
        assert_eq!(told(&[i, s, x]), "`x` takes numbers, not Text(\"a\")");
        assert_eq!(told(&[x, x, s]), "`i` takes whole numbers, not Number(0.1)");
        assert_eq!(told(&[i, x, s, i]), "a row has Integer(1) behind its last column");
    }
    let twice = ["a", "b", "a"].map(|name| Column::new(name, Kind::Number, None));
    assert_eq!(Heading::new(twice.to_vec()).expect_err("twice").to_string(), "two columns are called `a`");
}

/// A disk with room for so many bytes.
struct Disk(usize);

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match bytes.len().min(self.0) {
            0 if !bytes.is_empty() => Err(ErrorKind::StorageFull.into()),
            room => {
                self.0 -= room;
                Ok(room)
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_disk_is_reported_as_what_it_is() {
    for format in formats() {
        let mut file = Vec::new();
        written(format, 70_000, &mut file).expect("memory");
        for room in [0, 3, file.len() / 2, file.len() - 1] {
            let error = written(format, 70_000, &mut Disk(room)).expect_err("no room");
            assert_eq!(error.kind(), ErrorKind::StorageFull, "{format} {room}: {error}");
        }
        written(format, 70_000, &mut Disk(file.len())).expect("room");
    }
}
