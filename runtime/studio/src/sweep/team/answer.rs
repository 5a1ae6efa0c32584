//! What a worker sends.

use super::Found;
use crate::sweep::Observation;
use crate::sweep::journal::{outcome, record, written};

const READY: &str = "ready\n";
const ROWS: &str = "rows\n";
const LEFT: &str = "left\n";
const REFUSED: &str = "refused\n";
const END: &str = "end\n";

/// What a worker sends.
#[derive(PartialEq, Debug)]
pub(in crate::sweep) enum Answer {
    /// It can compute this sweep: what identifies it, as JSON.
    Ready(String),
    /// What came of the members that it was given; those that it has not begun are not among them.
    Rows(Vec<Found>),
    /// The same from one that was interrupted.
    Left(Vec<Found>),
    /// Why it cannot take part.
    Refused(String),
    /// It sends no more.
    End,
}

impl Answer {
    /// With so many observations of each member.
    pub(in crate::sweep) fn text(&self, observations: usize) -> String {
        let rows = |kind: &str, found: &[Found]| {
            let fields = |(member, outcome): &Found| {
                [member.to_string()].into_iter().chain(written(outcome, observations)).collect::<Vec<_>>()
            };
            found.iter().fold(kind.to_owned(), |text, found| text + &record(fields(found)))
        };
        match self {
            Self::Ready(identity) => format!("{READY}{identity}"),
            Self::Rows(found) => rows(ROWS, found),
            Self::Left(found) => rows(LEFT, found),
            Self::Refused(reason) => format!("{REFUSED}{reason}"),
            Self::End => END.to_owned(),
        }
    }

    /// Reads what [`Answer::text`] has written.
    pub(in crate::sweep) fn parse(text: &str, observations: &[Observation]) -> Option<Self> {
        let (kind, rest) = text.split_at(text.find('\n')? + 1);
        match kind {
            READY => Some(Self::Ready(rest.to_owned())),
            ROWS => found(rest, observations).map(Self::Rows),
            LEFT => found(rest, observations).map(Self::Left),
            REFUSED => Some(Self::Refused(rest.to_owned())),
            END => Some(Self::End),
            _ => None,
        }
    }
}

fn found(lines: &str, observations: &[Observation]) -> Option<Vec<Found>> {
    let mut reader =
        csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(lines.as_bytes());
    reader.records().map(|row| outcome(&row.ok()?, observations)).collect()
}
