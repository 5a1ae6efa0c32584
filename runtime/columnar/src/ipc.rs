//! Arrow's IPC file.

use crate::Heading;
use crate::arrow::{record, schema};
use crate::batch::Batch;
use crate::table::Target;
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, SchemaRef};
use std::io::{self, Write};

pub(crate) struct Ipc<'a> {
    schema: SchemaRef,
    writer: FileWriter<&'a mut (dyn Write + Send)>,
}

impl<'a> Ipc<'a> {
    pub fn begin(heading: &Heading, out: &'a mut (dyn Write + Send)) -> io::Result<Self> {
        let schema = schema(heading);
        let writer = FileWriter::try_new(out, &schema).map_err(plain)?;
        Ok(Self { schema, writer })
    }
}

impl Target for Ipc<'_> {
    fn write(&mut self, batch: &Batch) -> io::Result<()> {
        record(&self.schema, batch).and_then(|record| self.writer.write(&record)).map_err(plain)
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        self.writer.finish().map_err(plain)
    }
}

/// What the file system says, where it is that.
pub(crate) fn plain(error: ArrowError) -> io::Error {
    match error {
        ArrowError::IoError(_, source) => source,
        other => io::Error::other(other),
    }
}
