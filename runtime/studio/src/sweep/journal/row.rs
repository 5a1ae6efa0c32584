//! The rows of a journal: member, cells, why it failed, checksum.

use super::Known;
use crate::sweep::Observation;
use crate::sweep::cell::{Cell, Outcome};

/// Of FNV-1a with 64 bits: the offset, and the prime, an odd number, so that no two bytes in one
/// place have one checksum.
pub(in crate::sweep) const SEED: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0100_0000_01b3;

pub(in crate::sweep) fn checksum(seed: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(seed, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(PRIME))
}

/// A line of a table. Most have nothing to quote, and need no writer of their own.
pub(in crate::sweep) fn record<T: AsRef<str>>(fields: impl IntoIterator<Item = T>) -> String {
    let fields: Vec<T> = fields.into_iter().collect();
    let fields: Vec<&str> = fields.iter().map(AsRef::as_ref).collect();
    let is_plain = |field: &&str| !field.contains([',', '"', '\n', '\r']);
    match fields.len() > 1 && fields.iter().all(is_plain) {
        true => fields.join(",") + "\n",
        false => quoted(&fields),
    }
}

/// A line in which fields are quoted where they have to be.
fn quoted(fields: &[&str]) -> String {
    let mut writer = csv::WriterBuilder::new().flexible(true).from_writer(Vec::new());
    // Writing into memory does not fail.
    let _ = writer.write_record(fields);
    String::from_utf8_lossy(&writer.into_inner().unwrap_or_default()).into_owned()
}

/// The line of a member in the journal whose head has this checksum.
pub(in crate::sweep) fn line(member: usize, outcome: &Outcome, columns: usize, seed: u64) -> String {
    let mut fields = vec![member.to_string()];
    fields.extend(written(outcome, columns));
    sealed(&record(fields), seed)
}

/// A line with its checksum.
pub(in crate::sweep) fn sealed(line: &str, seed: u64) -> String {
    let line = line.trim_end_matches('\n');
    let sum = checksum(seed, line.as_bytes());
    format!("{line},{sum:016x}\n")
}

/// What a line says that is as it was written.
pub(in crate::sweep) fn unsealed(line: &[u8], seed: u64) -> Option<&str> {
    let (row, sum) = std::str::from_utf8(line).ok()?.strip_suffix('\n')?.rsplit_once(',')?;
    (sum == format!("{:016x}", checksum(seed, row.as_bytes()))).then_some(row)
}

/// The cells, and why the member failed.
pub(in crate::sweep) fn written(outcome: &Outcome, columns: usize) -> Vec<String> {
    match outcome {
        Ok(cells) => cells.iter().map(ToString::to_string).chain([String::new()]).collect(),
        Err(reason) => (0..columns).map(|_| String::new()).chain([reason.clone()]).collect(),
    }
}

/// What was read of the rows.
#[derive(Default)]
pub(super) struct Rows {
    pub(super) known: Known,
    /// Whole lines behind the first one that is damaged: they are to be written once more in its
    /// place.
    pub(super) moved: String,
}

impl Rows {
    /// Reads a journal with this head, and how many of its bytes may stay.
    pub(super) fn parse(bytes: &[u8], head: &str, seed: u64, observations: &[Observation]) -> (usize, Self) {
        let mut rows = Self::default();
        let mut kept = if bytes.starts_with(head.as_bytes()) { head.len() } else { 0 };
        // Of a head that is not whole the first line is.
        let start = bytes
            .iter()
            .enumerate()
            .filter(|(_, byte)| **byte == b'\n')
            .nth(1)
            .map_or(bytes.len(), |(i, _)| i + 1);
        rows.known.damaged += usize::from(kept == 0 && start < bytes.len());
        for line in bytes[start..].split_inclusive(|byte| *byte == b'\n').filter(|line| line.ends_with(b"\n"))
        {
            match parsed(line, seed, observations) {
                None => rows.known.damaged += 1,
                Some(row) => {
                    rows.known.done.push(row);
                    match rows.known.damaged {
                        0 => kept += line.len(),
                        _ => rows.moved.push_str(&String::from_utf8_lossy(line)),
                    }
                }
            }
        }
        (kept, rows)
    }
}

/// A line as it was written.
fn parsed(line: &[u8], seed: u64, observations: &[Observation]) -> Option<(usize, Outcome)> {
    let row = unsealed(line, seed)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(row.as_bytes());
    outcome(&reader.records().next()?.ok()?, observations)
}

/// The member and what came of it, of a row without its checksum.
pub(in crate::sweep) fn outcome(
    row: &csv::StringRecord,
    observations: &[Observation],
) -> Option<(usize, Outcome)> {
    let fields: Vec<&str> = row.iter().collect();
    let [member, cells @ .., failed] = &fields[..] else { return None };
    if cells.len() != observations.len() {
        return None;
    }
    let cell = |(text, observation): (&&str, &Observation)| Cell::parse(text, observation.is_category());
    let outcome = match *failed {
        "" => Ok(cells.iter().zip(observations).map(cell).collect::<Option<_>>()?),
        reason => Err(reason.to_owned()),
    };
    Some((member.parse().ok()?, outcome))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever a field has in it, and of any number of fields, empty ones too.
    #[test]
    fn a_record_is_what_a_writer_of_tables_makes_of_it() {
        let texts = ["", "a", "1.5e-3", "a b", "a,b", "say \"a\"", "two\nlines", "a\r", "#", ";\t|"];
        for a in texts {
            assert_eq!(record([a]), quoted(&[a]));
            for b in texts {
                assert_eq!(record([a, b]), quoted(&[a, b]));
                assert_eq!(record([a, b, "c"]), quoted(&[a, b, "c"]));
            }
        }
        assert_eq!(record(["a", "b,c", ""]), "a,\"b,c\",\n");
    }
}
