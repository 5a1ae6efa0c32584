//! Takes rows, and writes them in batches.

use crate::batch::Batch;
use crate::{Format, Heading, Value};
use std::io::{self, Write};

/// A file that takes batches.
pub(crate) trait Target {
    fn write(&mut self, batch: &Batch) -> io::Result<()>;
    /// Writes what stands behind the last batch.
    fn finish(self: Box<Self>) -> io::Result<()>;
}

/// A table that is being written. Of its rows no more are in memory than are written at once: 1024
/// to 65536, half a million entries, some 50 MB with what the formats need beside.
pub struct Table<'a> {
    batch: Batch,
    target: Box<dyn Target + 'a>,
}

impl<'a> Table<'a> {
    /// Begins a table.
    ///
    /// # Errors
    /// The build does not have the format ([`io::ErrorKind::Unsupported`]); it cannot be written.
    pub fn begin(format: Format, heading: &Heading, out: &'a mut (dyn Write + Send)) -> io::Result<Self> {
        Ok(Self { batch: Batch::new(&heading.columns), target: target(format, heading, out)? })
    }

    /// Adds a row: a value for each column, of its kind or missing.
    ///
    /// # Errors
    /// It has other values ([`io::ErrorKind::InvalidInput`]); it cannot be written.
    pub fn row<'v>(&mut self, values: impl IntoIterator<Item = Value<'v>>) -> io::Result<()> {
        self.batch.push(values)?;
        if self.batch.is_full() { self.flush() } else { Ok(()) }
    }

    /// Writes what is left, and the end of the file.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn finish(mut self) -> io::Result<()> {
        if !self.batch.is_empty() {
            self.flush()?;
        }
        self.target.finish()
    }

    fn flush(&mut self) -> io::Result<()> {
        self.target.write(&self.batch)?;
        self.batch.clear();
        Ok(())
    }
}

#[cfg_attr(
    not(any(feature = "parquet", feature = "npz")),
    expect(unused_variables, reason = "no format reads them")
)]
fn target<'a>(
    format: Format,
    heading: &Heading,
    out: &'a mut (dyn Write + Send),
) -> io::Result<Box<dyn Target + 'a>> {
    match format {
        #[cfg(feature = "parquet")]
        Format::Parquet => Ok(Box::new(crate::parquet::Parquet::begin(heading, out)?)),
        #[cfg(feature = "parquet")]
        Format::Arrow => Ok(Box::new(crate::ipc::Ipc::begin(heading, out)?)),
        #[cfg(feature = "npz")]
        Format::Npz => Ok(Box::new(crate::npz::Npz::begin(heading, out)?)),
        #[cfg(not(all(feature = "parquet", feature = "npz")))]
        missing => Err(io::Error::new(io::ErrorKind::Unsupported, crate::NotBuilt(missing))),
    }
}
