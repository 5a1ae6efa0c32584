//! NumPy's NPZ: a ZIP archive with an NPY file for each column, uncompressed.
//!
//! An array's length stands before its entries, so rows are kept in a temporary file until all are
//! there. NumPy has no missing entries: missing numbers are NaN, missing texts empty. What is said
//! of the whole is an array of no dimensions, a text of JSON. Texts have 32 bits a character, as
//! many characters as the longest of their column.
//!
//! The NPY format, version 1.0:
//! <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

mod failing;
mod spooled;

use crate::Heading;
use crate::batch::Batch;
use crate::metadata::metadata;
use crate::table::Target;
use failing::Failing;
use serde_json::{Map, Value as Json, json};
use spooled::{Spooled, characters};
use std::fs::File;
use std::io::{self, BufReader, BufWriter, Seek, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// The name of what is said of the whole.
const METADATA: &str = "liftoff.metadata";
/// Bytes of the archive's formats of one entry beyond which it has longer fields.
const LARGE: u64 = 1 << 31;

pub(crate) struct Npz<'a> {
    out: &'a mut (dyn Write + Send),
    columns: Vec<Spooled>,
    metadata: String,
    spool: BufWriter<File>,
    rows: u64,
}

impl<'a> Npz<'a> {
    pub fn begin(heading: &Heading, out: &'a mut (dyn Write + Send)) -> io::Result<Self> {
        Ok(Self {
            out,
            columns: heading.columns.iter().map(Spooled::new).collect(),
            metadata: said(heading),
            spool: BufWriter::new(tempfile::tempfile().map_err(spooling)?),
            rows: 0,
        })
    }
}

impl Target for Npz<'_> {
    fn write(&mut self, batch: &Batch) -> io::Result<()> {
        for (column, entries) in self.columns.iter_mut().zip(&batch.columns) {
            let start = self.spool.stream_position().map_err(spooling)?;
            column.pieces.push((start, batch.len()));
            column.spool(entries, &mut self.spool).map_err(spooling)?;
        }
        self.rows += batch.len() as u64;
        Ok(())
    }

    fn finish(self: Box<Self>) -> io::Result<()> {
        let Self { out, columns, metadata, spool, rows } = *self;
        let spool = spool.into_inner().map_err(|error| spooling(error.into_error()))?;
        let mut spool = BufReader::new(spool);
        let mut archive = ZipWriter::new_stream(Failing::new(out));
        let (text, length) = (characters(&metadata), metadata.chars().count());
        begin(&mut archive, METADATA, (&format!("<U{length}"), "()"), text.len() as u64)?;
        archive.write_all(&text)?;
        for column in &columns {
            let (kind, size) = column.kind();
            begin(&mut archive, &column.name, (&kind, &format!("({rows},)")), rows * size)?;
            column.copy(&mut spool, &mut archive)?;
        }
        archive.finish().map(drop).map_err(plain)
    }
}

/// Begins the file of an array with this type of entries and this shape.
fn begin<W: Write + Seek>(
    archive: &mut ZipWriter<W>,
    name: &str,
    (kind, shape): (&str, &str),
    size: u64,
) -> io::Result<()> {
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    archive.start_file(format!("{name}.npy"), options.large_file(size > LARGE)).map_err(plain)?;
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // What goes before, the header and its line end are a multiple of 64 bytes together.
    let length = (10 + header.len() + 1).next_multiple_of(64) - 10;
    archive.write_all(b"\x93NUMPY\x01\x00")?;
    archive.write_all(&u16::try_from(length).unwrap_or(u16::MAX).to_le_bytes())?;
    writeln!(archive, "{header:<width$}", width = length - 1)
}

/// `entries` with what is said of the whole, `units` of the columns that have one.
fn said(heading: &Heading) -> String {
    let entries: Map<String, Json> =
        metadata(heading).into_iter().map(|(name, text)| (name, Json::from(text))).collect();
    let units = heading
        .columns
        .iter()
        .filter_map(|column| Some((column.name.clone(), Json::from(column.unit.clone()?))));
    json!({ "entries": entries, "units": units.collect::<Map<_, _>>() }).to_string()
}

/// What keeps the temporary file from being written, where that is the file system.
fn spooling(error: io::Error) -> io::Error {
    if error.raw_os_error().is_none() {
        return error;
    }
    let folder = std::env::temp_dir();
    io::Error::new(error.kind(), format!("a temporary file in {}: {error}", folder.display()))
}

/// What the file system says, where it is that.
fn plain(error: zip::result::ZipError) -> io::Error {
    error.into()
}
