//! Unknown names and what may have been meant.

use crate::error::NameError;

/// The error for an unknown name, with the known ones and the nearest of them: within two edits that leave half of it
/// standing, or that only add to it or take from its end.
pub(crate) fn unknown<'a>(
    kind: &'static str,
    name: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> NameError {
    nearest(kind, name, &known.into_iter().collect::<Vec<_>>())
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
    let edits = distance(given, candidate);
    let continued = given.starts_with(candidate) || candidate.starts_with(given);
    let most = if continued { 2 } else { 2.min(candidate.chars().count() / 2) };
    (edits <= most).then_some(edits)
}

/// Levenshtein's edit distance.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// `StepLadder` as `step-ladder`.
#[cfg(feature = "report")]
pub(crate) fn kebab(name: &str) -> String {
    let mut kebab = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !kebab.is_empty() {
            kebab.push('-');
        }
        kebab.extend(letter.to_lowercase());
    }
    kebab
}
