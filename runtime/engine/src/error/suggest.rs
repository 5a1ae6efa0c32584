//! Unknown names and the known ones nearest to them.

use crate::error::NameError;

impl NameError {
    /// The error for an unknown name, with the known ones and the nearest of them: within two edits
    /// that leave half of both standing, or that only add to it or take from its end.
    pub fn new<'a>(kind: &'static str, name: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        nearest(kind, name, &known.into_iter().collect::<Vec<_>>())
    }
}

fn nearest(kind: &'static str, name: &str, known: &[&str]) -> NameError {
    let mut all: Vec<String> = Vec::new();
    for name in known {
        if !all.iter().any(|earlier| earlier == name) {
            all.push((*name).to_owned());
        }
    }
    let given = name.to_lowercase();
    let near = all
        .iter()
        .map(|candidate| (edits(&given, &candidate.to_lowercase()), candidate))
        .filter_map(|(edits, candidate)| Some((edits?, candidate)))
        .min_by_key(|(edits, _)| *edits);
    let nearest = near.map(|(_, candidate)| candidate.clone());
    NameError { kind, name: name.to_owned(), nearest, known: all }
}

/// The number of edits between two names that are near.
fn edits(given: &str, candidate: &str) -> Option<usize> {
    let edits = strsim::levenshtein(given, candidate);
    let continued = given.starts_with(candidate) || candidate.starts_with(given);
    let shorter = given.chars().count().min(candidate.chars().count());
    let most = if continued { 2 } else { 2.min(shorter / 2) };
    (edits <= most).then_some(edits)
}
