//! Painlevé's paradox in a run: a slip that no reaction obeys the law of friction in, or whose
//! reaction grows beyond all bounds, is ended by an impact without collision, unless a contact
//! jams.

use super::collide::allowed_gain;
use crate::contact::friction::{SlipDirection, SlipVelocity as KnownSlip};
use crate::contact::impulse::Row;
use crate::contact::{ContactError, labels};
use crate::event::{EventKind, Note};
use crate::model::{ContactSet, Slip};
use crate::numerics::zero::{MARGIN, SOLVED};
use crate::simulation::RunCause;
use crate::simulation::decide::{DecisionInput, LocatedSlips};
use crate::simulation::snapshot::Snapshot;

impl Snapshot<'_> {
    /// Ends a slip at the border of Painlevé's region, where the reaction grows beyond all bounds.
    pub(in crate::simulation) fn cross_border(&mut self) -> Result<(), RunCause> {
        let contacts = labels(self.layout(), self.closed());
        let holds = self.find_holds(&self.active_basis());
        self.end_slip(self.closed(), ContactError::Jammed { contacts }, &holds)
    }

    /// What holds each contact that slides in a set.
    fn find_holds(&self, set: &ContactSet) -> Vec<(usize, f64)> {
        let rough = self.setup.parts.laws.rough;
        rough.map_or_else(Vec::new, |rough| (rough.holds)(self.setup.context.system(), &self.state, set))
    }

    /// Ends a slip that no reaction obeys the law of friction in.
    pub(super) fn unjam(&mut self, question: &DecisionInput, source: ContactError) -> Result<(), RunCause> {
        let touching = question.touching;
        let known = self.known_slips(&DecisionInput { located: LocatedSlips::default(), ..question.clone() });
        let set = known.iter().fold(touching, |set, &(contact, slip)| match slip {
            KnownSlip::Forward | KnownSlip::Leaves(SlipDirection::Forward) => {
                set.slipping(contact, Slip::Forward)
            }
            KnownSlip::Backward | KnownSlip::Leaves(_) => set.slipping(contact, Slip::Backward),
            KnownSlip::Rest => set.slipping(contact, Slip::Stick),
        });
        let mut near = self.find_holds(&set);
        near.retain(|(_, hold)| (0.0..MARGIN).contains(hold));
        self.end_slip(touching, source, &near)
    }

    /// Ends a slip by an impact without collision, unless a contact jams. Contacts at the border,
    /// with what holds them, are just beyond it: so near it does not matter.
    fn end_slip(
        &mut self,
        touching: ContactSet,
        source: ContactError,
        at_border: &[(usize, f64)],
    ) -> Result<(), RunCause> {
        let layout = self.layout();
        let rubs = layout.frictions.iter().any(|friction| touching.contains(friction.contact));
        let rough = self.setup.parts.laws.rough.filter(|_| rubs && !layout.has_hinges());
        let jams = touching.iter().any(|i| layout.contacts[i].jams);
        self.bounces.wedged += 1;
        let gives_up = self.bounces.wedged > 4 + layout.contacts.len();
        let is_jammed = matches!(source, ContactError::Jammed { .. });
        let Some(rough) = rough.filter(|_| is_jammed && !jams && !gives_up) else {
            return Err(self.contact_error(source));
        };
        let found = self.pre_impact();
        let mut collision = self.collision(touching, &self.setup.context.system().equations(&self.state));
        for row in &mut collision.rows {
            if let Row::Friction { of, mu, .. } = row
                && let Some((_, hold)) = at_border.iter().find(|(contact, _)| contact == of)
            {
                // Beyond the border.
                *mu *= (1.0 + SOLVED) / (1.0 - hold);
            }
        }
        let Ok(outcome) = (rough.end_slip)(&collision, self.setup.budget.trials) else {
            return Err(self.contact_error(source));
        };
        let touching = touching.iter().filter(|i| outcome.opening[*i] == 0.0).collect();
        self.proceed(&outcome.rates, touching)?;
        self.refuse_gain(&found.energy, allowed_gain(collision.prescribed_gap_rate.as_slice(), &outcome))?;
        let acting: ContactSet = outcome.acting.iter().copied().collect();
        let acting = acting.union(self.both_ways_struck(&outcome));
        let note = Some(Note::WithoutCollision);
        self.record_impact(EventKind::Impact, acting, acting, (Some(found), &outcome.impulses), note);
        Ok(())
    }
}
