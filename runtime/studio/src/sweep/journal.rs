//! What is done of a sweep, kept as it is done: a line that identifies the sweep, the names of the columns, then a line for each
//! member in the order in which they ended.

use super::cell::{Cell, Outcome};
use super::{Observation, SweepError};
use serde_json::{Map, Value};
use std::fs::{File, OpenOptions};
use std::io::{BufWriter, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What is lost at most when a program is killed.
const AT_MOST: Duration = Duration::from_millis(200);
const MARK: &str = "# liftoff sweep ";

/// A journal that is written.
pub(super) struct Journal {
    file: BufWriter<File>,
    path: PathBuf,
    flushed: Instant,
}

/// What makes two sweeps one: words by their names.
pub(super) type Identity = Map<String, Value>;

/// Members that are done.
pub(super) type Done = Vec<(usize, Outcome)>;

impl Journal {
    /// Opens the journal of a sweep and reads what is done of it; a last line that was not written to its end is taken away.
    pub(super) fn open(
        path: &Path,
        identity: &Identity,
        observations: &[Observation],
        fresh: bool,
    ) -> Result<(Self, Done), SweepError> {
        let failed = |doing| move |source| SweepError::File { doing, path: path.to_owned(), source };
        let text = match File::open(path) {
            Ok(mut file) => {
                let mut bytes = Vec::new();
                file.read_to_end(&mut bytes).map_err(failed("read"))?;
                bytes
            }
            Err(error) if error.kind() == ErrorKind::NotFound => Vec::new(),
            Err(error) => return Err(failed("read")(error)),
        };
        let text = String::from_utf8_lossy(&text);
        let refused = |reason: String| SweepError::Journal { path: path.to_owned(), reason };
        if !text.starts_with(MARK) && !MARK.starts_with(&*text) {
            return Err(refused("is no journal of a sweep, and is left as it is".into()));
        }
        let head = head(identity, observations);
        let whole = text.rfind('\n').map_or(0, |last| last + 1);
        let (kept, done) = match text[..whole].split_once('\n') {
            Some((first, rest)) if !fresh => {
                same(first, identity).map_err(refused)?;
                // The names of the columns may be what was not written.
                let rows = rest.split_once('\n').map_or("", |(_, rows)| rows);
                let kept = if rest.is_empty() { 0 } else { whole };
                (kept, read(rows, observations).map_err(refused)?)
            }
            _ => (0, Vec::new()),
        };
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(path);
        let mut file = file.map_err(failed("write"))?;
        file.set_len(kept as u64).map_err(failed("write"))?;
        file.seek(SeekFrom::End(0)).map_err(failed("write"))?;
        if kept == 0 {
            file.write_all(head.as_bytes()).map_err(failed("write"))?;
        }
        Ok((Self { file: BufWriter::new(file), path: path.to_owned(), flushed: Instant::now() }, done))
    }

    /// Notes a member that has ended.
    pub(super) fn note(
        &mut self,
        member: usize,
        outcome: &Outcome,
        columns: usize,
    ) -> Result<(), SweepError> {
        let line = line(member, outcome, columns);
        let late = self.flushed.elapsed() > AT_MOST;
        let written = self.file.write_all(line.as_bytes());
        written.and_then(|()| if late { self.file.flush() } else { Ok(()) }).map_err(self.failed())?;
        if late {
            self.flushed = Instant::now();
        }
        Ok(())
    }

    /// Writes what has been noted.
    pub(super) fn close(mut self) -> Result<(), SweepError> {
        self.file.flush().map_err(self.failed())
    }

    fn failed(&self) -> impl Fn(std::io::Error) -> SweepError + use<> {
        let path = self.path.clone();
        move |source| SweepError::File { doing: "write", path: path.clone(), source }
    }
}

fn head(identity: &Identity, observations: &[Observation]) -> String {
    let columns = observations.iter().map(Observation::text);
    format!(
        "{MARK}{}\n{}",
        Value::Object(identity.clone()),
        record(["member"].into_iter().chain(columns).chain(["failed"]))
    )
}

/// A line of a table.
pub(super) fn record<T: AsRef<[u8]>>(fields: impl IntoIterator<Item = T>) -> String {
    let mut writer = csv::WriterBuilder::new().flexible(true).from_writer(Vec::new());
    // Writing into memory does not fail.
    let _ = writer.write_record(fields);
    String::from_utf8_lossy(&writer.into_inner().unwrap_or_default()).into_owned()
}

fn line(member: usize, outcome: &Outcome, columns: usize) -> String {
    let mut fields = vec![member.to_string()];
    fields.extend(written(outcome, columns));
    record(fields)
}

/// The cells, and why the member failed.
pub(super) fn written(outcome: &Outcome, columns: usize) -> Vec<String> {
    match outcome {
        Ok(cells) => cells.iter().map(ToString::to_string).chain([String::new()]).collect(),
        Err(reason) => (0..columns).map(|_| String::new()).chain([reason.clone()]).collect(),
    }
}

/// Refuses the head of another sweep, by the word in which they differ.
fn same(first: &str, identity: &Identity) -> Result<(), String> {
    let found = first.strip_prefix(MARK).and_then(|json| serde_json::from_str::<Identity>(json).ok());
    let found = found.ok_or("is no journal of a sweep, and is left as it is")?;
    let differs = identity.iter().find(|(word, value)| found.get(*word) != Some(value));
    match differs.map(|(word, _)| word).or_else(|| found.keys().find(|word| !identity.contains_key(*word))) {
        Some(word) => {
            let value = found.get(word).map_or("nothing".to_owned(), ToString::to_string);
            let value: String = value.chars().take(60).collect();
            Err(format!(
                "is the journal of another sweep: its `{word}` is {value}; start afresh or name another file"
            ))
        }
        None => Ok(()),
    }
}

fn read(rows: &str, observations: &[Observation]) -> Result<Done, String> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(rows.as_bytes());
    let mut done = Vec::new();
    for (i, row) in reader.records().enumerate() {
        let row = row.ok().and_then(|row| outcome(&row, observations));
        // The head has two lines.
        done.push(row.ok_or_else(|| format!("is damaged in line {}; start afresh", i + 3))?);
    }
    Ok(done)
}

fn outcome(row: &csv::StringRecord, observations: &[Observation]) -> Option<(usize, Outcome)> {
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
