//! A finished motion as the judge is told of it, in plain numbers: coordinates, then rates.

use crate::condition::Condition;
use crate::motion::{Action, Change};

/// A finished motion.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// When it begins.
    pub t: f64,
    /// In which state.
    pub start: Vec<f64>,
    /// Contacts that do not open.
    pub held: Vec<String>,
    /// What was done from outside, and when, in order of time.
    pub actions: Vec<(f64, Action)>,
    /// What was waited for, and when it was met.
    pub conditions: Vec<(Condition, Option<f64>)>,
    /// What it ends by, if the judge cannot wait for that: the end is given.
    pub given: Option<String>,
    /// Whether any impact ends it.
    pub ends_at_impacts: bool,
    /// Whether an impact ended it.
    pub is_barred: bool,
    /// When and of which contacts it says that they may have opened or not.
    pub undecided: Vec<(f64, Vec<String>)>,
    /// What happened, in order of time; touches that nothing follows from left out.
    pub events: Vec<RecordedEvent>,
    /// Its parts between events, in order of time.
    pub segments: Vec<MotionSegment>,
    /// When it ends.
    pub end: f64,
    /// Natural size of each entry of a state.
    pub units: Vec<f64>,
    /// Natural time.
    pub time: f64,
    /// Errors of its steps, relative.
    pub tolerance: f64,
    /// Errors below this, in natural units relative to the largest entry, are none.
    pub within: f64,
}

/// Something that happened.
#[derive(Clone, Debug)]
pub struct RecordedEvent {
    /// Time, s.
    pub t: f64,
    /// What happened.
    pub change: Change,
    /// Labels of the supports concerned.
    pub contacts: Vec<String>,
    /// The state after it.
    pub state: Vec<f64>,
}

/// A part of a motion with one set of closed contacts.
#[derive(Clone, Debug)]
pub struct MotionSegment {
    /// The closed supports.
    pub closed: Vec<String>,
    /// Times and states from its start to its end.
    pub samples: Vec<(f64, Vec<f64>)>,
}

impl Record {
    /// Whether it ends by what happens, and not at a given time.
    pub(crate) fn ends_by_itself(&self) -> bool {
        let ends = |(condition, met): &(Condition, Option<f64>)| condition.action.is_none() && met.is_some();
        self.is_barred || self.conditions.iter().any(ends)
    }

    /// How far two states are apart, in natural units relative to the largest entry, or to 1 where
    /// all are less.
    pub(crate) fn apart(&self, a: &[f64], b: &[f64]) -> f64 {
        let (mut largest, mut apart) = (1.0_f64, 0.0_f64);
        for ((a, b), unit) in a.iter().zip(b).zip(&self.units) {
            largest = largest.max((a / unit).abs());
            let difference = ((a - b) / unit).abs();
            apart = if difference.is_nan() { f64::INFINITY } else { apart.max(difference) };
        }
        apart / largest
    }

    /// How far two times are apart: relative, or in natural times where that is less.
    pub(crate) fn late(&self, a: f64, b: f64) -> f64 {
        (a - b).abs() / a.abs().max(self.time)
    }
}

/// What the judge finds.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The same events, and states and times apart by this at most.
    Agrees {
        /// In natural units.
        error: f64,
    },
    /// Something else.
    Disagrees {
        /// Time, s.
        t: f64,
        /// What happened.
        what: String,
    },
    /// Nothing is found.
    NotJudged {
        /// Why.
        why: String,
    },
}

impl core::fmt::Display for Verdict {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Agrees { error } => write!(f, "agrees within {error:.1e}"),
            Self::Disagrees { t, what } => write!(f, "disagrees at t = {t}: {what}"),
            Self::NotJudged { why } => write!(f, "not judged: {why}"),
        }
    }
}
