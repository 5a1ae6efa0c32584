//! A column whose entries are in the temporary file.

use crate::batch::Entries;
use crate::{Column, Kind};
use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};

/// Numbers have 8 bytes there, texts their length and their bytes.
pub(super) struct Spooled {
    pub name: String,
    kind: &'static str,
    /// Characters of the longest text.
    longest: usize,
    /// Where the entries of each batch are, and how many.
    pub pieces: Vec<(u64, usize)>,
}

impl Spooled {
    pub fn new(column: &Column) -> Self {
        let kind = match column.kind {
            Kind::Integer => "<i8",
            Kind::Number => "<f8",
            Kind::Text => "<U",
        };
        Self { name: column.name.clone(), kind, longest: 1, pieces: Vec::new() }
    }

    /// The type of its entries as NumPy calls it, and how many bytes one has.
    pub fn kind(&self) -> (String, u64) {
        match self.kind {
            "<U" => (format!("<U{}", self.longest), 4 * self.longest as u64),
            kind => (kind.to_owned(), 8),
        }
    }

    pub fn spool(&mut self, entries: &Entries, spool: &mut impl Write) -> io::Result<()> {
        match entries {
            Entries::Integers(entries) => entries.iter().try_for_each(|entry| {
                let missing =
                    || io::Error::new(ErrorKind::InvalidInput, "NumPy has no missing whole numbers");
                spool.write_all(&entry.ok_or_else(missing)?.to_le_bytes())
            }),
            Entries::Numbers(entries) => {
                entries.iter().try_for_each(|entry| spool.write_all(&entry.unwrap_or(f64::NAN).to_le_bytes()))
            }
            Entries::Texts(entries) => entries.iter().try_for_each(|entry| {
                let text = entry.as_deref().unwrap_or_default();
                self.longest = self.longest.max(text.chars().count());
                spool.write_all(&(text.len() as u64).to_le_bytes())?;
                spool.write_all(text.as_bytes())
            }),
        }
    }

    /// Copies its entries, texts with zeros up to the length of the longest.
    pub fn copy(&self, spool: &mut BufReader<File>, out: &mut impl Write) -> io::Result<()> {
        for &(start, count) in &self.pieces {
            spool.seek(SeekFrom::Start(start))?;
            if self.kind != "<U" {
                io::copy(&mut spool.take(8 * count as u64), out)?;
                continue;
            }
            for _ in 0..count {
                let mut length = [0; 8];
                spool.read_exact(&mut length)?;
                let mut text = String::new();
                spool.take(u64::from_le_bytes(length)).read_to_string(&mut text)?;
                let mut padded = characters(&text);
                padded.resize(4 * self.longest, 0);
                out.write_all(&padded)?;
            }
        }
        Ok(())
    }
}

/// The characters of a text, 32 bits each.
pub(super) fn characters(text: &str) -> Vec<u8> {
    text.chars().flat_map(|letter| u32::from(letter).to_le_bytes()).collect()
}
