//! Rows by columns.

use crate::{Column, Kind, Value};
use std::io::{self, ErrorKind};

/// Entries of a batch; of texts, which have no size of their own, they are counted as of numbers.
const ENTRIES: usize = 1 << 19;
/// Rows of a batch at least and at most.
const ROWS: [usize; 2] = [1 << 10, 1 << 16];

/// The entries of a column.
#[derive(Debug)]
pub(crate) enum Entries {
    Integers(Vec<Option<i64>>),
    Numbers(Vec<Option<f64>>),
    Texts(Vec<Option<String>>),
}

/// As many rows as are written at once.
#[derive(Debug)]
pub(crate) struct Batch {
    names: Vec<String>,
    pub columns: Vec<Entries>,
    rows: usize,
}

impl Batch {
    pub fn new(columns: &[Column]) -> Self {
        let entries = columns.iter().map(|column| match column.kind {
            Kind::Integer => Entries::Integers(Vec::new()),
            Kind::Number => Entries::Numbers(Vec::new()),
            Kind::Text => Entries::Texts(Vec::new()),
        });
        let names = columns.iter().map(|column| column.name.clone()).collect();
        Self { names, columns: entries.collect(), rows: 0 }
    }

    /// Takes a row; one that does not fit is refused whole or leaves a batch that is not to be
    /// written.
    pub fn push<'v>(&mut self, row: impl IntoIterator<Item = Value<'v>>) -> io::Result<()> {
        let mut row = row.into_iter();
        for (column, name) in self.columns.iter_mut().zip(&self.names) {
            let value = row.next().ok_or_else(|| misfit(format!("a row has nothing for `{name}`")))?;
            column.push(value).map_err(|kind| misfit(format!("`{name}` takes {kind}, not {value:?}")))?;
        }
        match row.next() {
            Some(value) => Err(misfit(format!("a row has {value:?} behind its last column"))),
            None => {
                self.rows += 1;
                Ok(())
            }
        }
    }

    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    #[cfg(feature = "npz")]
    pub fn len(&self) -> usize {
        self.rows
    }

    pub fn is_full(&self) -> bool {
        let [least, most] = ROWS;
        self.rows >= (ENTRIES / self.columns.len().max(1)).clamp(least, most)
    }

    pub fn clear(&mut self) {
        self.rows = 0;
        self.columns.iter_mut().for_each(Entries::clear);
    }
}

impl Entries {
    /// Or what it takes.
    fn push(&mut self, value: Value<'_>) -> Result<(), &'static str> {
        match (self, value) {
            (Self::Integers(entries), Value::Integer(value)) => entries.push(Some(value)),
            (Self::Integers(entries), Value::Missing) => entries.push(None),
            (Self::Numbers(entries), Value::Number(value)) => entries.push(Some(value)),
            (Self::Numbers(entries), Value::Missing) => entries.push(None),
            (Self::Texts(entries), Value::Text(value)) => entries.push(Some(value.to_owned())),
            (Self::Texts(entries), Value::Missing) => entries.push(None),
            (Self::Integers(_), _) => return Err("whole numbers"),
            (Self::Numbers(_), _) => return Err("numbers"),
            (Self::Texts(_), _) => return Err("texts"),
        }
        Ok(())
    }

    fn clear(&mut self) {
        match self {
            Self::Integers(entries) => entries.clear(),
            Self::Numbers(entries) => entries.clear(),
            Self::Texts(entries) => entries.clear(),
        }
    }
}

fn misfit(text: String) -> io::Error {
    io::Error::new(ErrorKind::InvalidInput, text)
}
