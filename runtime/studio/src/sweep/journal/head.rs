//! The head of a journal: which sweep it is of, and its columns.

use super::record;
use crate::sweep::Observation;
use serde_json::{Map, Value};

pub(in crate::sweep) const MARK: &str = "# liftoff sweep ";
pub(in crate::sweep) const FOREIGN: &str = "is not a journal of a sweep and was not changed";
/// How rows are written.
pub(in crate::sweep) const FORM: u32 = 2;
/// Letters of a value that are told.
const TOLD: usize = 60;
/// A difference in one of these explains those in others.
const FIRST: [&str; 3] = ["journal", "version", "model"];

/// What makes two sweeps one: words by their names.
pub(in crate::sweep) type Identity = Map<String, Value>;

/// The identity of a sweep, with that of the form of its rows.
pub(in crate::sweep) fn recorded(mut identity: Identity) -> Identity {
    identity.insert("journal".to_owned(), FORM.into());
    identity
}

/// The first line without its end, and the names of the columns.
pub(super) fn lines(identity: &Identity, observations: &[Observation]) -> [String; 2] {
    let columns = observations.iter().map(Observation::text);
    let columns = ["member"].into_iter().chain(columns).chain(["failed", "checksum"]);
    [format!("{MARK}{}", Value::Object(identity.clone())), record(columns)]
}

/// Whether these may be the first bytes of a journal, or all of one whose first line was not
/// written to its end.
pub(in crate::sweep) fn may_be_ours(bytes: &[u8]) -> bool {
    bytes.starts_with(MARK.as_bytes()) || MARK.as_bytes().starts_with(bytes)
}

/// What a first line says, if it is one.
pub(in crate::sweep) fn identity_of(first: &[u8]) -> Option<Identity> {
    serde_json::from_slice(first.strip_prefix(MARK.as_bytes())?).ok()
}

/// Refuses the head of another sweep, by the word in which they differ.
pub(in crate::sweep) fn same(first: &[u8], identity: &Identity) -> Result<(), String> {
    let found = identity_of(first).ok_or(FOREIGN)?;
    match difference(&found, identity) {
        Some(text) => {
            Err(format!("is the journal of another sweep: {text}; start afresh or name another file"))
        }
        None => Ok(()),
    }
}

/// The word in which two sweeps differ, with what it is and what was expected; words that say most
/// come first.
pub(in crate::sweep) fn difference(found: &Identity, expected: &Identity) -> Option<String> {
    let words = FIRST.into_iter().chain(expected.keys().chain(found.keys()).map(String::as_str));
    let word = words.into_iter().find(|word| found.get(*word) != expected.get(*word))?;
    Some(format!("its `{word}` is {}", describe_difference(found.get(word), expected.get(word))))
}

fn describe_difference(found: Option<&Value>, expected: Option<&Value>) -> String {
    let [found, expected] = [found, expected].map(|value| value.map_or("nothing".into(), Value::to_string));
    match found.chars().count().max(expected.chars().count()) {
        ..=TOLD => format!("{found}, not {expected}"),
        _ => found.chars().take(TOLD).collect(),
    }
}
