//! Parquet: a batch is a row group.

use crate::arrow::{record, schema};
use crate::batch::Batch;
use crate::ipc;
use crate::metadata::metadata;
use crate::table::Target;
use crate::{Heading, Kind};
use arrow_schema::SchemaRef;
use parquet::arrow::ArrowWriter;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::schema::types::ColumnPath;
use std::io::{self, Write};

pub(crate) struct Parquet<'a> {
    schema: SchemaRef,
    writer: ArrowWriter<&'a mut (dyn Write + Send)>,
}

impl<'a> Parquet<'a> {
    pub fn begin(heading: &Heading, out: &'a mut (dyn Write + Send)) -> io::Result<Self> {
        let schema = schema(heading);
        // Beside Arrow's schema, which has them too, for programs that do not read that.
        let entries = metadata(heading).into_iter().map(|(name, text)| KeyValue::new(name, text));
        let properties = WriterProperties::builder()
            // Numbers hardly ever occur twice.
            .set_dictionary_enabled(false)
            .set_created_by(concat!("liftoff ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(entries.collect()));
        let texts = heading.columns.iter().filter(|column| column.kind == Kind::Text);
        let properties = texts.fold(properties, |properties, column| {
            properties.set_column_dictionary_enabled(ColumnPath::new(vec![column.name.clone()]), true)
        });
        let writer = ArrowWriter::try_new(out, schema.clone(), Some(properties.build())).map_err(plain)?;
        Ok(Self { schema, writer })
    }
}

impl Target for Parquet<'_> {
    fn write(&mut self, batch: &Batch) -> io::Result<()> {
        let record = record(&self.schema, batch).map_err(ipc::plain)?;
        self.writer.write(&record).and_then(|()| self.writer.flush()).map_err(plain)
    }

    fn finish(self: Box<Self>) -> io::Result<()> {
        self.writer.close().map(drop).map_err(plain)
    }
}

/// What the file system says, where it is that.
fn plain(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(source) => match source.downcast() {
            Ok(source) => *source,
            Err(other) => io::Error::other(other),
        },
        other => io::Error::other(other),
    }
}
