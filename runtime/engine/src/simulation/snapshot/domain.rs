//! Runs that leave the domain of their equations end with an error that names what has left it.

use super::Snapshot;
use crate::event::Guard;
use crate::numerics::zero::MARGIN;
use crate::simulation::awaited::Role;
use crate::simulation::domain::{BoundedQuantity, driven};
use crate::simulation::{Domain, RunCause};

impl Snapshot<'_> {
    /// Whether a bound matters now: of a drive that is there, of a contact that slides.
    pub(in crate::simulation) fn is_bound(&self, domain: usize) -> bool {
        match self.setup.rules.domains[domain].of {
            BoundedQuantity::Distance(_, contact) => {
                contact.is_none_or(|contact| !self.contacts.absent().contains(contact))
            }
            BoundedQuantity::Friction(entry) => {
                self.closed().sense(self.layout().frictions[entry].contact) != 0
            }
        }
    }

    /// The equations have left a bound.
    pub(in crate::simulation) fn left(&self, domain: usize) -> RunCause {
        let (t, layout) = (self.t, self.layout());
        match self.setup.rules.domains[domain].of {
            BoundedQuantity::Distance(entry, _) => {
                RunCause::DrivenDistance { t, drive: driven(layout.quantities[entry].name).to_owned() }
            }
            BoundedQuantity::Friction(entry) => {
                let contact = layout.contacts[layout.frictions[entry].contact].label.to_owned();
                RunCause::NegativeFriction { t, contact, velocity: self.slip_states()[entry].velocity }
            }
        }
    }

    /// Refuses guards at zero where the equations leave a bound.
    pub(in crate::simulation) fn refuse_left(&self, guards: &[Guard]) -> Result<(), RunCause> {
        let domain = |guard: &Guard| {
            let Guard::Condition(k) = guard else { return None };
            if let Role::Domain(domain) = self.awaited.role(*k) { Some(domain) } else { None }
        };
        guards.iter().find_map(domain).map_or(Ok(()), |domain| Err(self.left(domain)))
    }

    /// The cause of a failed step or of a singular loop may be a driven distance that vanishes;
    /// then that is the error.
    pub(in crate::simulation) fn refuse_vanishing(&self) -> Result<(), RunCause> {
        let (context, domains) = (&self.setup.context, &self.setup.rules.domains);
        if domains.is_empty() {
            return Ok(());
        }
        let (zero, point) = (MARGIN * context.scales.length, self.point());
        let is_below = |(k, domain): &(usize, &Domain)| {
            matches!(domain.of, BoundedQuantity::Distance(..))
                && self.is_bound(*k)
                && domain.left.difference(context, &point).0 <= zero
        };
        domains.iter().enumerate().find(is_below).map_or(Ok(()), |(k, _)| Err(self.left(k)))
    }
}
