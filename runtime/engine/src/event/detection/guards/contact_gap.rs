//! The gap of an open contact as a function.

use crate::event::detection::LOW;
use crate::event::detection::contact_status::ContactStatus;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::{SampledStep, Scales};
use crate::event::detection::step::StepView;

/// g of a contact.
pub(super) struct Gap {
    pub(super) contact: usize,
    /// How high it will be in a low flight; else infinite.
    pub(super) height: f64,
}

impl Gap {
    pub(super) fn new(contact: usize, status: &ContactStatus<'_>) -> Self {
        let height = status.heights.iter().find(|(known, _)| *known == contact);
        Self { contact, height: height.map_or(f64::INFINITY, |(_, height)| *height) }
    }

    /// A flight that begins so deep has its ground there.
    pub(super) fn begin(&mut self, start: &SampledStep<'_>) {
        self.height = self.height.max(2.0 * (-self.value(start, 0.0)).max(0.0) / LOW);
    }

    pub(super) fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.value(theta, Quantities::GAPS, |sample| sample.gaps[self.contact])
    }

    pub(super) fn series<'s>(&self, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        view.guards.map(|guards| guards.gap(self.contact))
    }

    pub(super) fn may_have_crossed(&self, scales: &Scales<'_>, gaps: &[f64]) -> bool {
        scales.may_cross(gaps[self.contact], scales.size_of_gap(self.contact))
    }
}
