//! What is expected of a case, and what it answers.

use super::story::story;
use liftoff::catalog::Record;
use std::fmt::Write;

/// A number wanted.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Want {
    name: &'static str,
    value: f64,
    within: f64,
}

/// `name` = `value`, off by `within` at most.
pub(super) fn want(name: &'static str, value: f64, within: f64) -> Want {
    Want { name, value, within }
}

/// `name` between zero and `most`.
pub(super) fn at_most(name: &'static str, most: f64) -> Want {
    Want { name, value: 0.0, within: most }
}

/// What is expected.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Expected {
    /// This text and these numbers.
    Answer { said: String, wants: Vec<Want> },
    /// A typed error that contains this text.
    Refusal(String),
    /// These numbers, or else a typed error.
    Either(Vec<Want>),
}

/// What a case answers, where it answers.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Answer {
    pub(super) said: String,
    pub(super) numbers: Vec<f64>,
}

impl Answer {
    /// The events of a run and no numbers.
    pub(super) fn of_story(record: &dyn Record) -> Self {
        Self { said: story(record), numbers: Vec::new() }
    }

    /// The text, and each number with its distance from what is wanted.
    pub(super) fn text(&self, expected: &Expected) -> String {
        let mut text = self.said.clone();
        for (want, number) in expected.wants().iter().zip(&self.numbers) {
            let separator = if text.is_empty() { "" } else { ", " };
            let _ = match want.value {
                0.0 if *number == 0.0 => write!(text, "{separator}{} = 0", want.name),
                0.0 => write!(text, "{separator}{} = {number:.2e}", want.name),
                value => write!(text, "{separator}{} off by {:.1e}", want.name, (number - value).abs()),
            };
        }
        text
    }
}

impl Expected {
    fn wants(&self) -> &[Want] {
        match self {
            Self::Answer { wants, .. } | Self::Either(wants) => wants,
            Self::Refusal(_) => &[],
        }
    }

    /// Whether an answer, or the text of an error, is what is expected.
    pub(super) fn is_met(&self, outcome: Result<&Answer, &str>) -> bool {
        match (self, outcome) {
            (Self::Answer { said, wants }, Ok(answer)) => *said == answer.said && near(wants, answer),
            (Self::Either(wants), Ok(answer)) => near(wants, answer),
            (Self::Refusal(part), Err(error)) => error.contains(part.as_str()),
            (Self::Either(_), Err(error)) => !error.is_empty(),
            (Self::Answer { .. }, Err(_)) | (Self::Refusal(_), Ok(_)) => false,
        }
    }

    /// In words and numbers.
    pub(super) fn text(&self) -> String {
        let numbers: Vec<_> = self.wants().iter().map(Want::text).collect();
        let numbers = numbers.join(", ");
        match self {
            Self::Answer { said, .. } if said.is_empty() => numbers,
            Self::Answer { said, .. } if numbers.is_empty() => said.clone(),
            Self::Answer { said, .. } => format!("{said}, {numbers}"),
            Self::Refusal(part) => format!("an error: {part}"),
            Self::Either(_) => format!("{numbers}, or a typed error"),
        }
    }
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
            (0.0, _) => format!("|{name}| ≤ {}", short(*within)),
            (_, 0.0) => format!("{name} = {}", short(*value)),
            _ => format!("{name} = {} ± {within:.0e}", short(*value)),
        }
    }
}

/// All digits, with an exponent where that is shorter.
fn short(value: f64) -> String {
    if (1e-3..1e6).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}
