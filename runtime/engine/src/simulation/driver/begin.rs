//! The start of a run.

use std::sync::Arc;

use super::{Driver, Next};
use crate::assembly::CLOSED;
use crate::error::{RunCause, StartError};
use crate::event::{EventKind, Note};
use crate::integration::equilibrium::is_equilibrium;
use crate::model::ContactSet;
use crate::simulation::Simulation;
use crate::system::Phase;

impl Driver<'_> {
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
        self.reactions = vec![0.0; self.layout().contacts.len()];
        self.record(EventKind::Start, ContactSet::EMPTY, Some(Note::BeforeImpact));
        if !self.terminal(striking).is_empty() {
            self.record(EventKind::Close, striking, None);
            return Ok(Next::Finished);
        }
        self.resolve_impact(striking)?;
        Ok(Next::Continue)
    }

    /// Contacts with g = 0 > ġ at the start.
    pub(super) fn striking(&self) -> ContactSet {
        let context = &self.setup.context;
        let contacts = self.layout().contacts.len();
        if self.touching.len() == contacts {
            return ContactSet::EMPTY;
        }
        let equations = context.system().equations(&self.state);
        let n = self.layout().coordinates.len();
        let rates = &self.state[n..2 * n];
        let closes = |i: &usize| {
            !self.touching.contains(*i)
                && equations.gap()[*i].abs() <= CLOSED * context.scales.length
                && equations.gap_rate(*i, rates) < 0.0
        };
        (0..contacts).filter(closes).collect()
    }

    pub(super) fn check(&self) -> Result<(), RunCause> {
        let Simulation { tolerance, limit, .. } = *self.setup;
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(RunCause::Tolerance(tolerance));
        }
        if !(limit > 0.0 && limit.is_finite()) {
            return Err(RunCause::Limit(limit));
        }
        let Some(i) = self.held.iter().find(|&i| !self.touching.contains(i)) else { return Ok(()) };
        let gap = self.setup.context.system().equations(&self.state).gap()[i];
        Err(StartError::HeldOpen { support: self.layout().contacts[i].label.to_owned(), gap }.into())
    }

    /// Refuses a start in equilibrium unless something is planned: nothing would ever set it in motion.
    pub(super) fn refuse_equilibrium(&self) -> Result<(), RunCause> {
        let rests = |phase: &Arc<dyn Phase>| is_equilibrium(&self.setup.context, &**phase, &self.state);
        if self.setup.plan.is_empty() && self.phase.as_ref().is_some_and(rests) {
            return Err(StartError::Equilibrium.into());
        }
        Ok(())
    }
}
