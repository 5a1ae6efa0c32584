//! Which of several events of a kind.

use core::fmt;

use super::{Event, EventFilter};

/// Which of the events that a filter lets pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Occurrence {
    /// The n-th, counted from 1.
    Nth(usize),
    /// The last.
    Last,
}

impl Occurrence {
    /// Reads `first`, `2nd`, `3rd`, `11th`, …, `last`; none of other words.
    ///
    /// ```
    /// use liftoff::__private::event::Occurrence;
    /// assert_eq!(Occurrence::parse("22nd"), Some(Occurrence::Nth(22)));
    /// assert_eq!(Occurrence::parse("22th"), None);
    /// ```
    pub fn parse(word: &str) -> Option<Self> {
        match word {
            "first" => return Some(Self::Nth(1)),
            "last" => return Some(Self::Last),
            _ => {}
        }
        let digits = word.trim_end_matches(|letter: char| letter.is_ascii_lowercase());
        let n: usize = digits.parse().ok().filter(|_| !digits.starts_with(['+', '0']))?;
        (word.strip_prefix(digits) == Some(ending(n))).then_some(Self::Nth(n))
    }

    /// The place of that event in a run's list of them.
    pub fn find(self, events: &[Event], filter: &EventFilter) -> Option<usize> {
        let mut found = (0..events.len()).filter(|&k| filter.is(&events[k]));
        match self {
            Self::Nth(n) => found.nth(n.checked_sub(1)?),
            Self::Last => found.next_back(),
        }
    }
}

fn ending(n: usize) -> &'static str {
    match (n % 10, n % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    }
}

impl fmt::Display for Occurrence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nth(1) => f.write_str("first"),
            Self::Nth(n) => write!(f, "{n}{}", ending(*n)),
            Self::Last => f.write_str("last"),
        }
    }
}
