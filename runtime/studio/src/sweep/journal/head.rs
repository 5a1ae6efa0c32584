//! The head of a journal: which sweep it is of, and its columns.

use super::record;
use crate::sweep::Observation;
use serde_json::{Map, Value};

pub(super) const MARK: &str = "# liftoff sweep ";
pub(super) const FOREIGN: &str = "is no journal of a sweep, and is left as it is";
/// How rows are written.
const FORM: u32 = 2;
/// Letters of a value that are told.
const TOLD: usize = 60;

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

/// Refuses the head of another sweep, by the word in which they differ.
pub(super) fn same(first: &[u8], identity: &Identity) -> Result<(), String> {
    let json = first.strip_prefix(MARK.as_bytes());
    let found = json.and_then(|json| serde_json::from_slice::<Identity>(json).ok()).ok_or(FOREIGN)?;
    let differs = identity.iter().find(|(word, value)| found.get(*word) != Some(value));
    match differs.map(|(word, _)| word).or_else(|| found.keys().find(|word| !identity.contains_key(*word))) {
        Some(word) => Err(format!(
            "is the journal of another sweep: its `{word}` is {}; start afresh or name another file",
            difference(found.get(word), identity.get(word))
        )),
        None => Ok(()),
    }
}

fn difference(found: Option<&Value>, expected: Option<&Value>) -> String {
    let [found, expected] = [found, expected].map(|value| value.map_or("nothing".into(), Value::to_string));
    match found.chars().count().max(expected.chars().count()) {
        ..=TOLD => format!("{found}, not {expected}"),
        _ => found.chars().take(TOLD).collect(),
    }
}
