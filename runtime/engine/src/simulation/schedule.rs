//! What is planned for a run: supports that vanish, threads that are cut, impulses.

use crate::error::ScheduleError;
use crate::expression::Condition;
use crate::model::ContactSet;

/// Something that is to happen once.
#[derive(Debug, Clone)]
pub(crate) struct Scheduled {
    pub(crate) action: Action,
    pub(crate) when: Trigger,
}

/// What is to happen.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Action {
    /// Contacts cease to exist.
    Remove(ContactSet),
    /// An impulse at a point.
    Impulse { point: usize, impulse: [f64; 2] },
}

/// When it is to happen.
#[derive(Debug, Clone)]
pub(crate) enum Trigger {
    At(f64),
    If(Condition),
}

impl Trigger {
    pub(crate) fn from_time(at: f64) -> Result<Self, ScheduleError> {
        if at >= 0.0 && at.is_finite() { Ok(Self::At(at)) } else { Err(ScheduleError::Time { at }) }
    }
}
