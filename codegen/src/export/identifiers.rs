//! Identifiers for what has a name, no two alike.

use std::collections::BTreeSet;

use crate::math::spelled;

/// Identifiers of a language, given one after the other.
#[derive(Debug)]
pub(super) struct Identifiers {
    taken: BTreeSet<String>,
}

impl Identifiers {
    /// Those of a language whose words, and whatever else the source itself uses, are `reserved`.
    pub fn new<'a>(reserved: impl IntoIterator<Item = &'a str>) -> Self {
        Self { taken: reserved.into_iter().map(str::to_owned).collect() }
    }

    /// The identifier for a name: its letters and digits, Greek letters spelled, an underscore at
    /// its end for each time that it is taken.
    pub fn make_unique(&mut self, name: &str) -> String {
        let mut identifier = plain(name);
        while !self.taken.insert(identifier.clone()) {
            identifier.push('_');
        }
        identifier
    }
}

/// ASCII letters, digits and single underscores between them, a letter first.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for letter in name.chars() {
        match spelled(letter) {
            Some(greek) => plain.push_str(greek),
            None if letter.is_ascii_alphanumeric() => plain.push(letter),
            None if letter == '_' || letter.is_ascii() => plain.push('_'),
            None => plain.push_str(&format!("u{:x}", u32::from(letter))),
        }
    }
    let parts: Vec<&str> = plain.split('_').filter(|part| !part.is_empty()).collect();
    let joined = parts.join("_");
    if joined.starts_with(|first: char| first.is_ascii_alphabetic()) { joined } else { format!("x{joined}") }
}

#[cfg(test)]
mod tests {
    use super::Identifiers;

    #[test]
    fn every_name_has_an_identifier_of_its_own() {
        let mut identifiers = Identifiers::new(["lambda"]);
        let names = ["lambda", "lambda", "N(A, E)", "μ_A", "2nd", "q̈", "φ1", "phi1"];
        let given = names.map(|name| identifiers.make_unique(name));
        assert_eq!(given, ["lambda_", "lambda__", "N_A_E", "mu_A", "x2nd", "qu308", "phi1", "phi1_"]);
    }
}
