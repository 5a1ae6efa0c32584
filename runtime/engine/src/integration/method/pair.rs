//! Two integrations of one phase, of which one is at work: another method takes over from the usual
//! one, and gives back.

use crate::integrate::Counts;
use crate::system::PhaseStepper;

/// The usual integration and another.
pub(super) struct StepperPair<'a> {
    pub(super) usual: Box<dyn PhaseStepper + 'a>,
    pub(super) other: Option<Box<dyn PhaseStepper + 'a>>,
    /// Whether the other one is at work.
    pub(super) is_other: bool,
}

impl<'a> StepperPair<'a> {
    pub(super) fn new(usual: Box<dyn PhaseStepper + 'a>, other: Option<Box<dyn PhaseStepper + 'a>>) -> Self {
        Self { usual, other, is_other: false }
    }

    /// The one at work.
    pub(super) fn active(&self) -> &(dyn PhaseStepper + 'a) {
        match &self.other {
            Some(other) if self.is_other => &**other,
            _ => &*self.usual,
        }
    }

    pub(super) fn active_mut(&mut self) -> &mut (dyn PhaseStepper + 'a) {
        match &mut self.other {
            Some(other) if self.is_other => &mut **other,
            _ => &mut *self.usual,
        }
    }

    /// The work of both.
    pub(super) fn counts(&self) -> Counts {
        self.other.iter().fold(self.usual.counts(), |sum, other| sum + other.counts())
    }
}
