//! Journals of a sweep, cut, mutated and arbitrary: a row that is taken from one is a row that was
//! written to it.

use std::fmt;
use std::path::PathBuf;
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use liftoff_models::models;
use liftoff_studio::sweep::{Outcome, Sweep, SweepError};
use liftoff_tests::random::Source;

use crate::expression::check_message;
use crate::{Fate, Finding, Subject};

/// Parts of lines.
const WORDS: [&str; 20] = [
    "# liftoff sweep ",
    "{}",
    "member,end,failed,checksum\n",
    "0,",
    "1,",
    "\"",
    "\n",
    "\r\n",
    ",,,",
    "\0",
    "nan",
    "inf",
    "-0",
    "1e999",
    "é",
    "18446744073709551615,",
    "P",
    "0.5",
    "\"\"",
    "{\"version\":\"0.1.0\"}",
];

/// Journals of one sweep.
pub struct Journals {
    folder: PathBuf,
    whole: OnceLock<(Vec<u8>, Vec<Outcome>)>,
}

impl Default for Journals {
    fn default() -> Self {
        let folder = std::env::temp_dir().join(format!("liftoff-fuzz-{}", std::process::id()));
        Self { folder, whole: OnceLock::new() }
    }
}

impl Drop for Journals {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// What a journal has.
#[derive(Clone, Debug)]
pub struct Bytes(Vec<u8>);

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}", self.0.escape_ascii())
    }
}

fn sweep(path: PathBuf) -> Result<Sweep<'static>, SweepError> {
    let ball = models().find("bouncing-ball").map_err(|error| SweepError::Invalid(error.to_string()))?;
    let sweep = Sweep::new(ball).vary("e=0:1.5:12")?.set("g=9.81")?;
    Ok(sweep.observe("first impact y'")?.observe("end")?.threads(1).journal(path))
}

impl Journals {
    /// The journal as it was written, and what the members came to.
    fn whole(&self) -> &(Vec<u8>, Vec<Outcome>) {
        self.whole.get_or_init(|| {
            let path = self.folder.join("whole");
            let made = std::fs::create_dir_all(&self.folder)
                .ok()
                .and_then(|()| sweep(path.clone()).ok()?.run().ok());
            let rows = made.map(|table| table.rows.into_iter().map(|row| row.outcome).collect());
            (std::fs::read(path).unwrap_or_default(), rows.unwrap_or_default())
        })
    }
}

impl Subject for Journals {
    type Case = Bytes;

    fn generate(&self, seed: u64) -> Bytes {
        let source = &mut Source::new(seed);
        let mut bytes = self.whole().0.clone();
        if source.chance(0.05) {
            bytes = (0..source.below(20)).flat_map(|_| source.choose(&WORDS).bytes()).collect();
        }
        let rows = bytes.iter().position(|&byte| byte == b'\n').map_or(0, |at| at + 1);
        for _ in 0..source.choose(&[0, 1, 1, 2, 3, 10]) {
            // Mostly behind the first line: where that differs the rest is not read.
            let from = if source.chance(0.9) { rows.min(bytes.len()) } else { 0 };
            let at = from + source.below(bytes.len() - from + 1);
            let to = (at + source.choose(&[0, 1, 1, 3, 40])).min(bytes.len());
            match source.below(8) {
                0 => bytes.truncate(at),
                1 => _ = bytes.splice(at..to, []),
                2 => {
                    let copied = bytes[at..to].to_vec();
                    _ = bytes.splice(at..at, copied);
                }
                3..5 => _ = bytes.splice(at..to, [source.below(256) as u8]),
                5 => _ = bytes.splice(at..to, (b'0' + source.below(10) as u8..=b'9').take(1)),
                _ => _ = bytes.splice(at..to, source.choose(&WORDS).bytes()),
            }
        }
        Bytes(bytes)
    }

    fn check(&self, Bytes(bytes): &Bytes) -> Result<Fate, Finding> {
        let failed = |error: std::io::Error| Finding(format!("no file: {error}"));
        let (_, outcomes) = self.whole();
        let path = self.folder.join("mutated");
        std::fs::write(&path, bytes).map_err(failed)?;
        let stop = AtomicBool::new(true);
        let read = sweep(path.clone()).and_then(|sweep| sweep.cancel(&stop).run());
        let table = match read {
            Ok(table) => table,
            Err(error) => {
                let left = std::fs::read(&path).map_err(failed)?;
                if left != *bytes {
                    return Err(Finding(format!("refused, and changed: {error}")));
                }
                return Ok(vec![check_message("refused", "", &error.to_string())?]);
            }
        };
        let wrong = table.rows.iter().find(|row| outcomes.get(row.member) != Some(&row.outcome));
        match wrong {
            Some(row) => Err(Finding(format!("a row that was not written: {row:?}"))),
            None if table.rows.len() == outcomes.len() => Ok(vec!["whole"]),
            None => Ok(vec!["in part"]),
        }
    }
}
