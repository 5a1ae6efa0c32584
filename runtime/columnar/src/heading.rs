//! What a table says of itself.

use std::collections::BTreeSet;
use std::error::Error;
use std::fmt;

/// What a column holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Whole numbers, of 64 bits.
    Integer,
    /// Numbers, of 64 bits.
    Number,
    /// Texts in UTF-8.
    Text,
}

/// A column of a table.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// What it holds.
    pub kind: Kind,
    /// The unit of its numbers, `rad/s`, `1` of numbers without one; none where it is not known.
    pub unit: Option<String>,
}

impl Column {
    /// A column.
    pub fn new(name: impl Into<String>, kind: Kind, unit: Option<&str>) -> Self {
        Self { name: name.into(), kind, unit: unit.map(str::to_owned) }
    }
}

/// The columns of a table, no two of one name, and what is said of the whole.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Heading {
    pub(crate) columns: Vec<Column>,
    pub(crate) entries: Vec<Entry>,
}

/// Something said of a whole table.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Entry {
    pub name: String,
    pub text: String,
    /// Whether its hash is told too.
    pub is_hashed: bool,
}

impl Heading {
    /// A table with these columns.
    ///
    /// # Errors
    /// Two of them have one name.
    pub fn new(columns: Vec<Column>) -> Result<Self, DuplicateColumn> {
        let mut names = BTreeSet::new();
        let twice = columns.iter().find(|column| !names.insert(&column.name));
        match twice {
            Some(column) => Err(DuplicateColumn(column.name.clone())),
            None => Ok(Self { columns, entries: Vec::new() }),
        }
    }

    /// Says something of the whole table: `liftoff.name` in its metadata.
    #[must_use]
    pub fn entry(self, name: &str, text: impl Into<String>) -> Self {
        self.with(name, text.into(), false)
    }

    /// The same with the SHA-256 of the text in UTF-8, in hexadecimal, as `liftoff.name.sha256`.
    #[must_use]
    pub fn hashed(self, name: &str, text: impl Into<String>) -> Self {
        self.with(name, text.into(), true)
    }

    fn with(mut self, name: &str, text: String, is_hashed: bool) -> Self {
        self.entries.push(Entry { name: format!("liftoff.{name}"), text, is_hashed });
        self
    }

    /// Its columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }
}

/// Two columns of a table have one name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DuplicateColumn(pub(crate) String);

impl fmt::Display for DuplicateColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "two columns are called `{}`", self.0)
    }
}

impl Error for DuplicateColumn {}
