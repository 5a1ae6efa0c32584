//! What is measured.

use core::fmt;

use liftoff::__private::event::Occurrence;
use liftoff::EventFilter;
use liftoff::{Output, Trajectory};
use liftoff_replay::{Moment, Reading};

use super::trial::TrialError;

/// A measured value.
#[derive(Debug, Clone, PartialEq)]
pub struct Datum {
    /// Time, s.
    pub place: Place,
    /// Of what; none for the time of an event.
    pub output: Option<Output>,
    /// The value, in SI units.
    pub value: f64,
    /// Its standard deviation, or another measure of what it is worth beside others; above 0.
    pub deviation: f64,
}

/// When something is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// At this time, s.
    Time(f64),
    /// Right behind an event.
    Event(Occurrence, EventFilter),
    /// At the end of the run.
    End,
}

impl Datum {
    /// When that is in a run.
    pub(super) fn moment(&self, run: &Trajectory) -> Result<Moment, TrialError> {
        let last = || run.events().last().map_or_else(String::new, ToString::to_string);
        match &self.place {
            &Place::Time(t) if t > run.end_time() => {
                Err(TrialError::Short { what: self.to_string(), last: last() })
            }
            &Place::Time(t) => Ok(Moment::Time(t)),
            Place::End => Ok(Moment::Event(run.events().len() - 1)),
            Place::Event(which, filter) => {
                let found = which.find(run.events(), filter).map(Moment::Event);
                found.ok_or_else(|| TrialError::NoEvent { event: self.place.to_string(), last: last() })
            }
        }
    }

    /// The value in a run.
    pub(super) fn computed(&self, run: &Trajectory, moment: Moment) -> Result<f64, TrialError> {
        let t = match moment {
            Moment::Time(t) => t,
            Moment::Event(k) => run.events()[k].t,
        };
        let value = self.output.as_ref().map_or(t, |output| run.value(output, t));
        let finite = Some(value).filter(|value| value.is_finite());
        finite.ok_or_else(|| TrialError::NotFinite { what: self.to_string() })
    }

    pub(super) fn reading(&self, moment: Moment) -> Reading<'_> {
        Reading { moment, output: self.output.as_ref() }
    }
}

impl fmt::Display for Datum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.output {
            Some(output) => write!(f, "{output} at {}", self.place),
            None => write!(f, "the time of {}", self.place),
        }
    }
}

impl Place {
    /// The time, unless it is that of an event.
    pub fn time(&self) -> Option<f64> {
        if let Self::Time(t) = self { Some(*t) } else { None }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Time(t) => write!(f, "t = {t}"),
            Self::Event(which, filter) => write!(f, "{which} {filter}"),
            Self::End => f.write_str("the end"),
        }
    }
}
