//! What the guards at zero say of contacts and conditions.

use crate::contact::friction::{SharedFrictionMargin, SlipDirection};
use crate::event::detection::Guard;
use crate::model::{ContactSet, Slip};
use crate::simulation::awaited::Role;
use crate::simulation::decide::LocatedSlips;
use crate::simulation::snapshot::Snapshot;

/// What has been located at an event.
#[derive(Default)]
pub(super) struct Located {
    /// Contacts whose reaction is zero.
    pub(super) unloaded: ContactSet,
    /// Contacts whose gap closes.
    pub(super) closing: ContactSet,
    /// Contacts whose foot is at the end of its bar.
    pub(super) sliding: ContactSet,
    pub(super) slips: LocatedSlips,
    /// Whether contacts that share their load are at their limits.
    pub(super) shares: bool,
    /// Conditions that end the run.
    pub(super) stops: Vec<usize>,
    /// Entries of the plan.
    pub(super) planned: Vec<usize>,
    /// Switches, and whether each arms.
    pub(super) switched: Vec<(usize, bool)>,
}

impl Snapshot<'_> {
    pub(super) fn locate(&self, guards: &[Guard]) -> Located {
        let mut located = Located::default();
        for guard in guards {
            match *guard {
                Guard::Reaction(contact) => located.unloaded = located.unloaded.with(contact),
                Guard::Side(contact, _) => {
                    located.unloaded = located.unloaded.with(contact);
                    // With N = 0 it may slide in either sense.
                    if self.closed().slip(contact) == Slip::Stick {
                        located.slips.stop(contact);
                    }
                }
                Guard::Gap(contact) => located.closing = located.closing.with(contact),
                Guard::Foot { contact, .. } => located.sliding = located.sliding.with(contact),
                Guard::Limit(rub) if rub.slip == Slip::Backward => {
                    located.slips.leave(rub.contact, SlipDirection::Backward);
                }
                Guard::Limit(rub) => located.slips.leave(rub.contact, SlipDirection::Forward),
                Guard::Slip(rub) => located.slips.stop(rub.contact),
                Guard::SharedFriction => {
                    located.shares = true;
                    let SharedFrictionMargin { leaving, unloaded, .. } = self.shared_margin();
                    leaving.into_iter().for_each(|(contact, sense)| located.slips.leave(contact, sense));
                    located.unloaded = located.unloaded.union(unloaded);
                }
                Guard::Condition(condition) => match self.awaited.role(condition) {
                    Role::Stop => located.stops.push(condition),
                    Role::Planned(entry) => located.planned.push(entry),
                    Role::Switch { switch, arms } => located.switched.push((switch, arms)),
                    // The run has ended with an error.
                    Role::Domain(_) => {}
                },
                // It opened where the phase began.
                Guard::RedundantGap(_) => {}
            }
        }
        located.closing = located.closing.difference(self.find_beyond_end());
        located
    }
}
