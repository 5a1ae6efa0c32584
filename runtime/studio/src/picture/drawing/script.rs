//! Words of a drawing: names as they are printed, quantities slanted.

use crate::explain::names::lettered;
use crate::html::escaped;

/// A word in parts.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Script(pub Vec<Run>);

/// A part of a word.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Run {
    pub text: String,
    /// Whether it stands for a number.
    pub slanted: bool,
    pub lowered: bool,
}

/// Size of what is lowered.
const LOWERED: f64 = 0.72;

impl Script {
    /// A name of a point or a part.
    pub fn upright(text: &str) -> Self {
        Self(vec![Run { text: text.to_owned(), slanted: false, lowered: false }])
    }

    /// A name of a quantity: `phi_inner` as a slanted φ with the word lowered.
    pub fn quantity(name: &str) -> Self {
        let [letter, lowered] = lettered(name);
        let part = |text: String, lowered: bool| Run { slanted: !lowered, text, lowered };
        let all = [part(letter, false), part(lowered.replace('_', " "), true)];
        Self(all.into_iter().filter(|run| !run.text.is_empty()).collect())
    }

    /// An expression as it is printed: letters slanted, all else upright.
    pub fn formula(text: &str) -> Self {
        let mut runs: Vec<Run> = Vec::new();
        for letter in text.chars() {
            let slanted = letter.is_alphabetic();
            match runs.last_mut().filter(|run| run.slanted == slanted) {
                Some(run) => run.text.push(letter),
                None => runs.push(Run { text: letter.into(), slanted, lowered: false }),
            }
        }
        Self(runs)
    }

    /// The same as the name of a point: upright.
    #[must_use]
    pub fn standing(mut self) -> Self {
        self.0.iter_mut().for_each(|run| run.slanted = false);
        self
    }

    #[must_use]
    pub fn then(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }

    /// As SVG in letters of this size: its parts, what is lowered in smaller letters.
    pub fn markup(&self, size: f64) -> String {
        let (mut markup, mut lowered) = (String::new(), false);
        for run in &self.0 {
            let slant = if run.slanted { " font-style=\"italic\"" } else { "" };
            let small =
                if run.lowered { format!(" font-size=\"{:.1}\"", LOWERED * size) } else { String::new() };
            let step = match (lowered, run.lowered) {
                (false, true) => format!(" dy=\"{:.1}\"", 0.22 * size),
                (true, false) => format!(" dy=\"{:.1}\"", -0.22 * size),
                _ => String::new(),
            };
            lowered = run.lowered;
            markup += &format!("<tspan{slant}{small}{step}>{}</tspan>", escaped(&run.text));
        }
        markup
    }

    /// About how wide it is in letters of this size, rather too wide than too narrow.
    pub fn width(&self, size: f64) -> f64 {
        let run = |run: &Run| {
            let scale = if run.lowered { LOWERED } else { 1.0 };
            run.text.chars().map(|letter| breadth(letter) * scale).sum::<f64>()
        };
        size * self.0.iter().map(run).sum::<f64>()
    }
}

/// The width of a letter over the size of its font, of common sans-serif fonts.
fn breadth(letter: char) -> f64 {
    match letter {
        '\u{300}'..='\u{36f}' | '\u{20d0}'..='\u{20ff}' => 0.0,
        'i' | 'j' | 'l' | '.' | ',' | ':' | '\'' | '|' | 'I' => 0.32,
        'f' | 't' | 'r' | ' ' | '(' | ')' | '/' => 0.42,
        'm' | 'w' | 'M' | 'W' | '=' | '−' => 0.9,
        'A'..='Z' | 'ω' | 'ψ' => 0.72,
        _ => 0.62,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_quantities_are_printed_as_in_books() {
        let name = Script::quantity("phi_inner");
        assert_eq!((name.0[0].text.as_str(), name.0[1].text.as_str()), ("φ", "inner"));
        assert!(name.0[0].slanted && name.0[1].lowered && !name.0[1].slanted);
        assert_eq!(Script::quantity("x").0.len(), 1);
        assert_eq!(Script::formula("½ l").0.iter().filter(|run| run.slanted).count(), 1);
    }

    #[test]
    fn dots_over_letters_take_no_width() {
        assert_eq!(Script::upright("φ\u{307}").width(10.0), Script::upright("φ").width(10.0));
    }
}
