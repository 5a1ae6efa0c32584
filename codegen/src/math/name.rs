//! Names of symbols: `phi_inner` is φ with an index, `m1` is m₁, `lean` a word.

use super::numbers::subscript;

const GREEK: [(&str, char); 34] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("omicron", 'ο'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// Combining dots for the first to the fourth derivative.
pub(super) const DOTS: [char; 4] = ['\u{307}', '\u{308}', '\u{20db}', '\u{20dc}'];

/// A name: a letter or word, and what stands below it. Greek letters are given spelled out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The letter, Greek where it was spelled, or the word.
    stem: String,
    /// Digits right after it, or what follows from an underscore on.
    suffix: String,
}

impl Name {
    /// A declared name.
    pub fn new(name: &str) -> Self {
        let end = name.find(|c: char| c == '_' || c.is_ascii_digit());
        let (stem, suffix) = name.split_at(end.unwrap_or(name.len()));
        Self { stem: greek(stem).map_or_else(|| stem.to_owned(), String::from), suffix: suffix.to_owned() }
    }

    /// The letter or word, without dots of its own; how many dots it has.
    pub(super) fn stem(&self) -> (&str, u8) {
        match self.stem.as_str() {
            "ḋ" => ("d", 1),
            stem => (stem, 0),
        }
    }

    /// The letter or word, and what stands lowered beside it.
    pub(crate) fn lettered(self) -> [String; 2] {
        [self.stem, self.suffix.trim_start_matches('_').to_owned()]
    }

    /// What stands below, part by part.
    pub(super) fn indices(&self) -> Vec<String> {
        let parts = self.suffix.split('_').filter(|part| !part.is_empty());
        parts.map(|part| greek(part).map_or_else(|| part.to_owned(), String::from)).collect()
    }

    /// Whether it is one letter, with an index or not.
    pub fn is_letter(&self) -> bool {
        self.stem().0.chars().count() == 1
    }

    /// As text: dots over a single letter, else primes at the end.
    pub(super) fn text(&self, order: u8) -> String {
        let Self { stem, suffix } = self;
        let number = suffix.trim_start_matches('_');
        let suffix = if number.parse::<u32>().is_ok() { &subscript(number) } else { suffix };
        let dots = usize::from(order).checked_sub(1).map(|i| DOTS.get(i));
        match dots {
            None => format!("{stem}{suffix}"),
            Some(Some(dots)) if self.is_letter() && !suffix.starts_with('_') => {
                format!("{stem}{dots}{suffix}")
            }
            Some(_) => format!("{stem}{suffix}{}", "'".repeat(order.into())),
        }
    }
}

fn greek(name: &str) -> Option<char> {
    GREEK.iter().find(|(spelled, _)| *spelled == name).map(|(_, letter)| *letter)
}

/// How a Greek letter is spelled.
pub(crate) fn spelled(letter: char) -> Option<&'static str> {
    GREEK.iter().find(|(_, greek)| *greek == letter).map(|(spelled, _)| *spelled)
}
