//! What is expected of a case, and what it answers.

use super::event_summary::event_summary;

use liftoff::__private::expression::significant;
use liftoff::Trajectory;
use std::fmt::Write;

/// A named number with its expected value and the largest absolute error that passes.
#[derive(Clone, PartialEq, Debug)]
pub struct Expectation {
    name: &'static str,
    value: f64,
    within: f64,
}

/// Expects `name` = `value` within the absolute error `within`.
pub fn expect(name: &'static str, value: f64, within: f64) -> Expectation {
    Expectation { name, value, within }
}

/// Expects |`name`| ≤ `most`.
pub fn at_most(name: &'static str, most: f64) -> Expectation {
    Expectation { name, value: 0.0, within: most }
}

/// The outcome that a case has to have to pass.
#[derive(Clone, PartialEq, Debug)]
pub enum Expected {
    /// This text and these numbers.
    Answer {
        /// The exact text of the answer.
        text: String,
        /// One for each number of the answer, in order.
        expectations: Vec<Expectation>,
    },
    /// A typed error that contains this text.
    Refusal(String),
    /// These numbers, or else a typed error.
    Either(Vec<Expectation>),
    /// This text and these numbers; with an error that begins with `excuse` there is nothing to
    /// compare, and no verdict.
    Unless {
        /// The exact text of the answer.
        text: String,
        /// One for each number of the answer, in order.
        expectations: Vec<Expectation>,
        /// Prefix of that error: `no reference`.
        excuse: &'static str,
    },
}

/// The measured outcome of a case that ended without an error.
#[derive(Clone, PartialEq, Debug)]
pub struct Answer {
    /// The events, as [`event_summary`] writes them, or another outcome in words.
    pub text: String,
    /// Measured values, in the order of the expectations.
    pub numbers: Vec<f64>,
}

impl Answer {
    /// The events of a run and no numbers.
    pub fn of_events(record: &Trajectory) -> Self {
        Self { text: event_summary(record), numbers: Vec::new() }
    }

    /// The text, and each number with its distance from what is wanted.
    pub fn text(&self, expected: &Expected) -> String {
        let mut text = self.text.clone();
        for (expectation, number) in expected.expectations().iter().zip(&self.numbers) {
            let separator = if text.is_empty() { "" } else { ", " };
            let _ = match expectation.value {
                0.0 => write!(text, "{separator}{} = {}", expectation.name, rounded(*number)),
                value => {
                    write!(text, "{separator}{} off by {:.1e}", expectation.name, (number - value).abs())
                }
            };
        }
        text
    }
}

impl Expected {
    fn expectations(&self) -> &[Expectation] {
        match self {
            Self::Answer { expectations, .. }
            | Self::Either(expectations)
            | Self::Unless { expectations, .. } => expectations,
            Self::Refusal(_) => &[],
        }
    }

    /// Whether an error says that there is nothing to compare with.
    pub fn excuses(&self, error: &str) -> bool {
        matches!(self, Self::Unless { excuse, .. } if error.starts_with(excuse))
    }

    /// Whether an answer, or the text of an error, is what is expected.
    pub fn is_met(&self, outcome: Result<&Answer, &str>) -> bool {
        match (self, outcome) {
            (Self::Answer { text, expectations } | Self::Unless { text, expectations, .. }, Ok(answer)) => {
                *text == answer.text && near(expectations, answer)
            }
            (Self::Either(expectations), Ok(answer)) => near(expectations, answer),
            (Self::Refusal(part), Err(error)) => error.contains(part.as_str()),
            (Self::Either(_), Err(error)) => !error.is_empty(),
            (Self::Answer { .. } | Self::Unless { .. }, Err(_)) | (Self::Refusal(_), Ok(_)) => false,
        }
    }

    /// In words and numbers.
    pub fn text(&self) -> String {
        let numbers: Vec<_> = self.expectations().iter().map(Expectation::text).collect();
        let numbers = numbers.join(", ");
        match self {
            Self::Answer { text, .. } => joined(text, &numbers),
            Self::Unless { text, excuse, .. } => format!("{}, or {excuse}", joined(text, &numbers)),
            Self::Refusal(part) => format!("an error: {part}"),
            Self::Either(_) => format!("{numbers}, or a typed error"),
        }
    }
}

fn joined(text: &str, numbers: &str) -> String {
    let parts = [text, numbers].into_iter().filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join(", ")
}

fn near(expectations: &[Expectation], answer: &Answer) -> bool {
    // Written so that NaN is never near.
    let close = |(expectation, number): (&Expectation, &f64)| {
        (number - expectation.value).abs() <= expectation.within
    };
    expectations.len() == answer.numbers.len() && expectations.iter().zip(&answer.numbers).all(close)
}

impl Expectation {
    fn text(&self) -> String {
        let Self { name, value, within } = self;
        match (*value, *within) {
            (0.0, 0.0) => format!("{name} = 0"),
            (0.0, _) => format!("|{name}| ≤ {}", rounded(*within)),
            (_, 0.0) => format!("{name} = {}", short(*value)),
            _ => format!("{name} = {} ± {within:.0e}", short(*value)),
        }
    }
}

/// All digits, with an exponent where that is shorter.
fn short(value: f64) -> String {
    if (1e-3..1e6).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}

/// A count, or three digits of what is none.
fn rounded(value: f64) -> String {
    let count = value.fract() == 0.0 && value.abs() < 1e9;
    let text = if count { format!("{value}") } else { significant(value, 3) };
    match text.split_once('e') {
        Some((digits, exponent)) => format!("{}e{exponent}", trimmed(digits)),
        None => trimmed(&text).to_owned(),
    }
}

/// Without zeros at the end of a fraction.
fn trimmed(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_whole_and_limits_have_three_digits() {
        assert_eq!(at_most("steps", 26972.005677001536).text(), "|steps| ≤ 26972");
        assert_eq!(at_most("E", 1e-10).text(), "|E| ≤ 1e-10");
        let expected = Expected::Answer { text: String::new(), expectations: vec![at_most("steps", 2500.0)] };
        assert_eq!(Answer { text: String::new(), numbers: vec![423.0] }.text(&expected), "steps = 423");
        assert_eq!(
            Answer { text: String::new(), numbers: vec![4.23456e-7] }.text(&expected),
            "steps = 4.23e-7"
        );
    }

    #[test]
    fn what_has_nothing_to_be_judged_by_says_so_and_nothing_else_is_excused() {
        let expectations = vec![at_most("error", 1e-9)];
        let expected = Expected::Unless { text: String::new(), expectations, excuse: "no reference" };
        assert_eq!(expected.text(), "|error| ≤ 1e-9, or no reference");
        assert!(expected.excuses("no reference: infinitely many impacts"));
        assert!(!expected.excuses("the run stopped short") && !expected.is_met(Err("the run stopped short")));
        let off = Answer { text: String::new(), numbers: vec![1e-8] };
        assert!(!expected.is_met(Ok(&off)));
    }
}
