//! What was read of a member.

use std::fmt;

/// A value of an observation.
#[derive(Clone, PartialEq, Debug)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// A category.
    Name(String),
    /// No such event.
    Missing,
}

/// The values of all observations, or why the member failed.
pub type Outcome = Result<Vec<Cell>, String>;

/// A member of a sweep.
#[derive(Clone, PartialEq, Debug)]
pub struct MemberResult {
    /// Index of the member, from 0.
    pub member: usize,
    /// The values of the varied names.
    pub point: Vec<f64>,
    /// The observed values, or why the member failed.
    pub outcome: Outcome,
}

impl Cell {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        if let Self::Number(value) = self { Some(*value) } else { None }
    }

    /// Reads what it is written as.
    pub(super) fn parse(text: &str, is_category: bool) -> Option<Self> {
        match text {
            "" => Some(Self::Missing),
            name if is_category => Some(Self::Name(name.to_owned())),
            number => number.parse().ok().map(Self::Number),
        }
    }
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => f.write_str(&written(*value)),
            Self::Name(name) => f.write_str(name),
            Self::Missing => Ok(()),
        }
    }
}

/// The fewest digits that read as the same number.
pub(super) fn written(value: f64) -> String {
    let plain = value == 0.0 || (1e-5..1e16).contains(&value.abs()) || !value.is_finite();
    if plain { value.to_string() } else { format!("{value:e}") }
}
