//! Names of symbols: `phi_inner` prints as φ_inner, `m1` as m₁, the rate of `phi` as φ̇.

use super::super::Symbol;
use super::numbers::subscript;

/// The names under which symbols are printed; Greek letters are given spelled out.
pub trait Names {
    /// The name of parameter `index`.
    fn parameter(&self, index: u16) -> String;
    /// The name of coordinate `index`.
    fn coordinate(&self, index: u16) -> String;
    /// The name of reaction `index`.
    fn reaction(&self, index: u16) -> String;
    /// The name of atom `index`.
    fn atom(&self, index: u16) -> String {
        format!("a{index}")
    }
}

/// Combining dots for the first to the fourth derivative.
const DOTS: [&str; 4] = ["\u{307}", "\u{308}", "\u{20db}", "\u{20dc}"];

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

/// A name in print: letters or letter, then digits lowered, then the rest from an underscore on.
struct Printed {
    stem: String,
    suffix: String,
}

impl Printed {
    fn of(name: &str) -> Self {
        let end = name.find(|c: char| c == '_' || c.is_ascii_digit());
        let (stem, suffix) = name.split_at(end.unwrap_or(name.len()));
        let greek = GREEK.iter().find(|(spelled, _)| *spelled == stem);
        let lowered = suffix.parse::<u32>().is_ok();
        Self {
            stem: greek.map_or_else(|| stem.to_owned(), |(_, letter)| letter.to_string()),
            suffix: if lowered { subscript(suffix) } else { suffix.to_owned() },
        }
    }

    fn has_letter(&self) -> bool {
        self.stem.chars().count() == 1
    }

    /// Dots over a single letter, else primes at the end.
    fn derivative(&self, order: u8) -> String {
        let Self { stem, suffix } = self;
        let dots = usize::from(order).checked_sub(1).map(|i| DOTS.get(i));
        match dots {
            None => format!("{stem}{suffix}"),
            Some(Some(dots)) if self.has_letter() && !suffix.starts_with('_') => {
                format!("{stem}{dots}{suffix}")
            }
            Some(_) => format!("{stem}{suffix}{}", "'".repeat(order.into())),
        }
    }
}

/// A name in print as its letter or word, and what stands lowered beside it: `phi_inner` as φ and inner, `m1` as m and 1.
pub fn lettered(name: &str) -> [String; 2] {
    let end = name.find(|c: char| c == '_' || c.is_ascii_digit()).unwrap_or(name.len());
    let (stem, suffix) = name.split_at(end);
    [Printed::of(stem).stem, suffix.trim_start_matches('_').to_owned()]
}

/// The name of a coordinate in print, or of its derivative of this order: `phi` as φ, φ̇, φ̈.
pub fn printed(name: &str, order: u8) -> String {
    Printed::of(name).derivative(order)
}

/// A symbol in print.
pub(super) fn symbol(symbol: Symbol, names: &dyn Names) -> String {
    match symbol {
        Symbol::Parameter(i) => Printed::of(&names.parameter(i)).derivative(0),
        Symbol::Reaction(i) => Printed::of(&names.reaction(i)).derivative(0),
        Symbol::Coordinate { index, order } => Printed::of(&names.coordinate(index)).derivative(order),
        Symbol::Atom { index, order } => Printed::of(&names.atom(index)).derivative(order),
        Symbol::Time => "t".to_owned(),
    }
}
