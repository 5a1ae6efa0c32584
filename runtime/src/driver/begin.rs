//! The start of a run.

use super::{Driver, Next};
use crate::error::{RunCause, StartError};
use crate::event::EventKind;
use crate::model::{BarSystem, ContactSet, KernelView};
use crate::rest::Rest;
use crate::simulation::Simulation;
use crate::start::CLOSED;

impl<M: BarSystem> Driver<'_, M> {
    /// The phase of the start, after the impact of what its rates drive into a support.
    pub(super) fn begin(&mut self) -> Result<Next, RunCause> {
        let striking = self.striking();
        if striking.is_empty() {
            self.decide(ContactSet::EMPTY)?;
            self.refuse_equilibrium()?;
            self.record(EventKind::Start, ContactSet::EMPTY, None);
            return Ok(Next::Continue);
        }
        self.closed = self.touching;
        self.reactions = vec![0.0; M::LAYOUT.contacts.len()];
        let note = "before the impact".to_owned();
        self.record(EventKind::Start, ContactSet::EMPTY, Some(note));
        if !self.barred(striking).is_empty() {
            self.record(EventKind::Close, striking, None);
            return Ok(Next::Finished);
        }
        self.strike(striking)?;
        Ok(Next::Continue)
    }

    /// Contacts with g = 0 > ġ at the start.
    pub(super) fn striking(&self) -> ContactSet {
        let scene = &self.setup.scene;
        let kernel = M::kernel(&scene.constants, &self.state);
        let n = M::LAYOUT.coordinates.len();
        let rates = &self.state.as_ref()[n..2 * n];
        let speed = |i: usize| {
            let along = kernel.jacobian(i).iter().zip(rates).map(|(slope, u)| slope * u);
            along.sum::<f64>() + kernel.drift()[i]
        };
        let closes = |i: &usize| {
            !self.touching.contains(*i)
                && kernel.gap()[*i].abs() <= CLOSED * scene.scales.length
                && speed(*i) < 0.0
        };
        (0..M::LAYOUT.contacts.len()).filter(closes).fold(ContactSet::EMPTY, ContactSet::with)
    }

    pub(super) fn check(&self) -> Result<(), RunCause> {
        let Simulation { tolerance, limit, .. } = *self.setup;
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(RunCause::Tolerance(tolerance));
        }
        if !(limit > 0.0 && limit.is_finite()) {
            return Err(RunCause::Limit(limit));
        }
        let kernel = M::kernel(&self.setup.scene.constants, &self.state);
        match self.held.iter().find(|&i| !self.touching.contains(i)) {
            Some(i) => {
                let support = M::LAYOUT.contacts[i].label.to_owned();
                Err(StartError::HeldOpen { support, gap: kernel.gap()[i] }.into())
            }
            None => Ok(()),
        }
    }

    /// Nothing that is at rest now is ever set in motion, unless something is planned.
    pub(super) fn refuse_equilibrium(&self) -> Result<(), RunCause> {
        let scene = &self.setup.scene;
        let rest = Rest { constants: &scene.constants, scales: &scene.scales, state: &self.state };
        if self.setup.plan.is_empty() && M::phase(self.closed, self.form, rest) {
            return Err(StartError::Equilibrium.into());
        }
        Ok(())
    }
}
