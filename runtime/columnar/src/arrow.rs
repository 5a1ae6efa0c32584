//! Batches as Arrow's record batches; units are metadata of the columns, `unit`.

use crate::batch::{Batch, Entries};
use crate::metadata::metadata;
use crate::{Column, Heading, Kind};
use arrow_array::{ArrayRef, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use std::collections::HashMap;
use std::sync::Arc;

pub(crate) fn schema(heading: &Heading) -> SchemaRef {
    let fields: Vec<Field> = heading.columns.iter().map(field).collect();
    Arc::new(Schema::new_with_metadata(fields, metadata(heading).into_iter().collect::<HashMap<_, _>>()))
}

fn field(column: &Column) -> Field {
    let kind = match column.kind {
        Kind::Integer => DataType::Int64,
        Kind::Number => DataType::Float64,
        Kind::Text => DataType::Utf8,
    };
    let unit = column.unit.iter().map(|unit| ("unit".to_owned(), unit.clone()));
    Field::new(&column.name, kind, true).with_metadata(unit.collect::<HashMap<_, _>>())
}

pub(crate) fn record(schema: &SchemaRef, batch: &Batch) -> Result<RecordBatch, ArrowError> {
    RecordBatch::try_new(Arc::clone(schema), batch.columns.iter().map(array).collect())
}

fn array(entries: &Entries) -> ArrayRef {
    match entries {
        Entries::Integers(entries) => Arc::new(entries.iter().copied().collect::<Int64Array>()),
        Entries::Numbers(entries) => Arc::new(entries.iter().copied().collect::<Float64Array>()),
        Entries::Texts(entries) => Arc::new(entries.iter().map(Option::as_deref).collect::<StringArray>()),
    }
}
