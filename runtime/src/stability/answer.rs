//! What is expected of a case, and what it answers.

use super::story::story;
use crate::catalog::Record;
use crate::number::significant;
use std::fmt::Write;

/// A number wanted.
#[derive(Clone, PartialEq, Debug)]
pub struct Want {
    name: &'static str,
    value: f64,
    within: f64,
}

/// `name` = `value`, off by `within` at most.
pub fn want(name: &'static str, value: f64, within: f64) -> Want {
    Want { name, value, within }
}

/// `name` between zero and `most`.
pub fn at_most(name: &'static str, most: f64) -> Want {
    Want { name, value: 0.0, within: most }
}

/// What is expected.
#[derive(Clone, PartialEq, Debug)]
pub enum Expected {
    /// This text and these numbers.
    Answer {
        /// The text.
        said: String,
        /// The numbers.
        wants: Vec<Want>,
    },
    /// A typed error that contains this text.
    Refusal(String),
    /// These numbers, or else a typed error.
    Either(Vec<Want>),
    /// This text and these numbers, or else an error that begins so: where there is nothing to judge.
    Unless {
        /// The text.
        said: String,
        /// The numbers.
        wants: Vec<Want>,
        /// How the error begins.
        excuse: &'static str,
    },
}

/// What a case answers, where it answers.
#[derive(Clone, PartialEq, Debug)]
pub struct Answer {
    /// What is said.
    pub said: String,
    /// In the order of those wanted.
    pub numbers: Vec<f64>,
}

impl Answer {
    /// The events of a run and no numbers.
    pub fn of_story(record: &dyn Record) -> Self {
        Self { said: story(record), numbers: Vec::new() }
    }

    /// The text, and each number with its distance from what is wanted.
    pub fn text(&self, expected: &Expected) -> String {
        let mut text = self.said.clone();
        for (want, number) in expected.wants().iter().zip(&self.numbers) {
            let separator = if text.is_empty() { "" } else { ", " };
            let _ = match want.value {
                0.0 => write!(text, "{separator}{} = {}", want.name, rounded(*number)),
                value => write!(text, "{separator}{} off by {:.1e}", want.name, (number - value).abs()),
            };
        }
        text
    }
}

impl Expected {
    fn wants(&self) -> &[Want] {
        match self {
            Self::Answer { wants, .. } | Self::Either(wants) | Self::Unless { wants, .. } => wants,
            Self::Refusal(_) => &[],
        }
    }

    /// Whether an answer, or the text of an error, is what is expected.
    pub fn is_met(&self, outcome: Result<&Answer, &str>) -> bool {
        match (self, outcome) {
            (Self::Answer { said, wants } | Self::Unless { said, wants, .. }, Ok(answer)) => {
                *said == answer.said && near(wants, answer)
            }
            (Self::Either(wants), Ok(answer)) => near(wants, answer),
            (Self::Refusal(part), Err(error)) => error.contains(part.as_str()),
            (Self::Either(_), Err(error)) => !error.is_empty(),
            (Self::Unless { excuse, .. }, Err(error)) => error.starts_with(excuse),
            (Self::Answer { .. }, Err(_)) | (Self::Refusal(_), Ok(_)) => false,
        }
    }

    /// In words and numbers.
    pub fn text(&self) -> String {
        let numbers: Vec<_> = self.wants().iter().map(Want::text).collect();
        let numbers = numbers.join(", ");
        match self {
            Self::Answer { said, .. } => joined(said, &numbers),
            Self::Unless { said, excuse, .. } => format!("{}, or {excuse}", joined(said, &numbers)),
            Self::Refusal(part) => format!("an error: {part}"),
            Self::Either(_) => format!("{numbers}, or a typed error"),
        }
    }
}

fn joined(said: &str, numbers: &str) -> String {
    let parts = [said, numbers].into_iter().filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join(", ")
}

fn near(wants: &[Want], answer: &Answer) -> bool {
    // Written so that NaN is never near.
    let close = |(want, number): (&Want, &f64)| (number - want.value).abs() <= want.within;
    wants.len() == answer.numbers.len() && wants.iter().zip(&answer.numbers).all(close)
}

impl Want {
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
        let expected = Expected::Answer { said: String::new(), wants: vec![at_most("steps", 2500.0)] };
        assert_eq!(Answer { said: String::new(), numbers: vec![423.0] }.text(&expected), "steps = 423");
        assert_eq!(
            Answer { said: String::new(), numbers: vec![4.23456e-7] }.text(&expected),
            "steps = 4.23e-7"
        );
    }

    #[test]
    fn what_has_nothing_to_be_judged_by_says_so_and_nothing_else_is_excused() {
        let wants = vec![at_most("error", 1e-9)];
        let expected = Expected::Unless { said: String::new(), wants, excuse: "no reference" };
        assert_eq!(expected.text(), "|error| ≤ 1e-9, or no reference");
        assert!(expected.is_met(Err("no reference: infinitely many impacts")));
        assert!(!expected.is_met(Err("the run stopped short")));
        let off = Answer { said: String::new(), numbers: vec![1e-8] };
        assert!(!expected.is_met(Ok(&off)));
    }
}
