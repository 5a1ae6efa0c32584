//! Names that are not there, and what was probably meant: the least optimal-string-alignment
//! distance (insert, delete, replace a letter, exchange two neighbours).

use std::fmt::Display;

const LISTED: usize = 8;

/// "there is no bar `AE`; did you mean `AD`?", or what there is if nothing is near.
pub(crate) fn unknown<'a>(
    kind: &str,
    name: &impl Display,
    known: impl IntoIterator<Item = &'a str>,
) -> String {
    let name = name.to_string();
    let known: Vec<&str> = known.into_iter().collect();
    let hint = match nearest(&name, &known) {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None if known.is_empty() => format!("no {kind} is declared"),
        None => format!("declared: {}", list(&known)),
    };
    format!("there is no {kind} `{name}`; {hint}")
}

/// The nearest of the names known, if it is near; a name of one letter is near to none.
pub(crate) fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let count = name.chars().count();
    let near = |other: &&str| count > 1 && distance(name, other) <= 1 + count / 4;
    known
        .iter()
        .copied()
        .filter(near)
        .min_by_key(|other| (distance(name, other), letters(name) != letters(other)))
}

/// What is left of a name when the order is forgotten: `BA` is rather `AB` than `CA`.
fn letters(name: &str) -> Vec<char> {
    let mut letters: Vec<char> = name.chars().collect();
    letters.sort_unstable();
    letters
}

fn list(known: &[&str]) -> String {
    let shown: Vec<String> = known.iter().take(LISTED).map(|name| format!("`{name}`")).collect();
    let more = if known.len() > LISTED { ", …" } else { "" };
    shown.join(", ") + more
}

fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::{distance, unknown};

    #[test]
    fn exchanged_letters_are_one_step() {
        assert_eq!(distance("BD", "DB"), 1);
        assert_eq!(distance("lenght", "length"), 1);
        assert_eq!(distance("phi_iner", "phi_inner"), 1);
        assert_eq!(distance("", "abc"), 3);
    }

    #[test]
    fn one_letter_names_are_listed_not_guessed() {
        assert_eq!(unknown("point", &"X", ["A", "D"]), "there is no point `X`; declared: `A`, `D`");
        assert_eq!(unknown("bar", &"CB", ["AB", "BC"]), "there is no bar `CB`; did you mean `BC`?");
        assert_eq!(unknown("bar", &"AE", ["DB", "AD"]), "there is no bar `AE`; did you mean `AD`?");
    }
}
