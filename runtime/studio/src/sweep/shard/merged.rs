//! Shards that are whole and belong together, written as one table: their lines are taken in turn.

use super::head::Head;
use super::lines::Line;
use super::part::Part;
use crate::sweep::{SweepError, columnar};
use liftoff_columnar::Format;
use std::collections::BTreeMap;
use std::io::{self, ErrorKind};
use std::path::Path;

/// Bytes of all shards that are read at once, and of each at most and at least.
const AT_ONCE: usize = 32 << 20;
const OF_EACH: [usize; 2] = [4 << 10, 256 << 10];

/// All shards of a sweep, whole.
#[derive(Debug)]
pub struct Merged {
    /// Number of members.
    pub members: usize,
    /// How many members have failed.
    pub failed: usize,
    head: Head,
    parts: BTreeMap<usize, Part>,
}

impl Merged {
    pub(super) fn new(head: Head, parts: BTreeMap<usize, Part>, failed: usize) -> Self {
        Self { members: head.members, failed, head, parts }
    }

    /// The name of the model.
    pub fn model(&self) -> &str {
        self.head.model()
    }

    /// Number of shards.
    pub fn shards(&self) -> usize {
        self.head.shard.count()
    }

    /// How many members of how many shards, in a line.
    pub fn summary(&self) -> String {
        let (model, shards, failed) = (self.model(), self.shards(), self.failed);
        let plural = if shards == 1 { "" } else { "s" };
        let failed = if failed > 0 { format!(", {failed} failed") } else { String::new() };
        format!("{} members of {model} from {shards} shard{plural}{failed}\n", self.members)
    }

    /// Writes the table of the whole sweep, byte for byte that of one process.
    ///
    /// # Errors
    /// It cannot be written; a shard has changed since it was checked. Nothing is written then.
    pub fn write_csv(&self, path: &Path) -> Result<(), SweepError> {
        let failed = |source| SweepError::File { doing: "write", path: path.to_owned(), source };
        let written = crate::file::replace(path, |out| {
            out.write_all(self.head.names.as_bytes())?;
            self.each_line(&mut |line| {
                out.write_all(line.as_bytes())?;
                out.write_all(b"\n")
            })
        });
        written.map_err(failed)
    }

    /// The same as a columnar file.
    ///
    /// # Errors
    /// The same; two columns have one name; the build does not have the format.
    pub fn write_columnar(&self, format: Format, path: &Path) -> Result<(), SweepError> {
        columnar::write((format, path), &self.head.heading()?, |table| {
            self.each_line(&mut |line| {
                let mut reader = csv::ReaderBuilder::new();
                let reader = reader.has_headers(false).buffer_capacity(line.len().max(1));
                let record = reader.from_reader(line.as_bytes()).into_records().next().transpose()?;
                let values =
                    record.as_ref().and_then(|record| columnar::parse_row(record, &self.head.columns));
                table.row(values.ok_or_else(changed)?)
            })
        })
    }

    /// The lines of the table; what is not as it has just been found makes it fail.
    fn each_line(&self, take: &mut dyn FnMut(&str) -> io::Result<()>) -> io::Result<()> {
        let [least, most] = OF_EACH;
        let size = (AT_ONCE / self.parts.len()).clamp(least, most);
        let readers = self.parts.values().map(|part| part.rows(size));
        let mut readers = readers.collect::<io::Result<Vec<_>>>()?;
        for member in 0..self.members {
            let (index, place) = (member % self.parts.len(), member / self.parts.len());
            match readers[index].next(&self.parts[&index].head)? {
                Some(Line::Member(at, line)) if at == place => take(line)?,
                _ => return Err(changed()),
            }
        }
        Ok(())
    }
}

fn changed() -> io::Error {
    io::Error::new(ErrorKind::InvalidData, "a shard has changed meanwhile")
}
