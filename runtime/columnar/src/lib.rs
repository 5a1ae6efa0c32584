//! Tables of named columns with units, written row by row as columnar files: Parquet, Arrow's IPC
//! file, NumPy's NPZ.
//!
//! - `format`: which formats there are, and which of them this build has; `heading`: columns, and
//!   what is said of the whole table; `value`: what stands in a row.
//! - `table`: takes rows, and writes them in batches, so that memory does not grow with their
//!   number; `batch`: rows by columns.
//! - `metadata`: what is said of the whole, with hashes; `arrow`: batches as Arrow's record
//!   batches; `parquet`, `ipc`, `npz`: the files.
//!
//! ```no_run
//! use liftoff_columnar::{Column, Format, Heading, Kind, Table, Value};
//!
//! let columns = vec![Column::new("t", Kind::Number, Some("s")), Column::new("phi", Kind::Number, Some("rad"))];
//! let heading = Heading::new(columns)?.entry("model", "pendulum");
//! let mut file = std::fs::File::create("motion.parquet")?;
//! let mut table = Table::begin(Format::Parquet, &heading, &mut file)?;
//! table.row([0.0, 1.3].map(Value::Number))?;
//! table.finish()?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "parquet")]
mod arrow;
mod batch;
mod format;
mod heading;
#[cfg(feature = "parquet")]
mod ipc;
#[cfg(any(feature = "parquet", feature = "npz"))]
mod metadata;
#[cfg(feature = "npz")]
mod npz;
#[cfg(feature = "parquet")]
mod parquet;
mod table;
#[cfg(all(test, any(feature = "parquet", feature = "npz")))]
mod tests;
mod value;

pub use format::{Format, NotBuilt};
pub use heading::{Column, DuplicateColumn, Heading, Kind};
pub use table::Table;
pub use value::Value;
