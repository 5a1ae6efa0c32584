//! A guard with what is known of it from step to step, and the guards of a contact set.

use std::cell::Cell;

use super::{Guard, Rub, StepView};
use crate::contact::friction::Grip;
use crate::expression::Condition;
use crate::model::{ContactKind, ContactSet, Layout, Slip};

/// A condition is evaluated so often in a step at most, or bounded over a piece of it. Beyond, it is undecided whether it is met
/// there, and less is tried in the steps that follow.
const PATIENCE: u32 = 100_000;
/// Order of the first derivative of the gap of a low flight that does not vanish.
const ORDER: usize = 3;

/// Contacts as the run treats them.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ContactStatus<'a> {
    /// Closed contacts: those that bear, and those that depend on them.
    pub(crate) closed: ContactSet,
    pub(crate) held: ContactSet,
    pub(crate) removed: ContactSet,
    /// Open contacts whose foot is not under the bar.
    pub(crate) off: ContactSet,
    /// Open contacts below their bars, which they have come to from beyond the ends.
    pub(crate) passed: ContactSet,
    /// Closed contacts whose reaction or slip velocity is zero, or whose friction force is at its limit, and that have just been
    /// decided to go on as they are.
    pub(crate) kept: ContactSet,
    /// Closed contacts with friction that share their load.
    pub(crate) grip: Grip,
    /// Heights that bouncing contacts are to reach.
    pub(crate) heights: &'a [(usize, f64)],
    /// Gaps that are zero at the start, each with the order of its first nonzero derivative.
    pub(crate) orders: &'a [(usize, usize)],
    /// The size of each reaction.
    pub(crate) forces: &'a [f64],
    /// The natural slip velocity of each contact with friction.
    pub(crate) slips: &'a [f64],
}

impl ContactStatus<'_> {
    /// Whether a guard is zero of which the decision says that it has not crossed.
    fn keeps(&self, guard: Guard) -> bool {
        match guard {
            Guard::Reaction(contact)
            | Guard::Side(contact, _)
            | Guard::Limit(Rub { contact, .. })
            | Guard::Slip(Rub { contact, .. }) => self.kept.contains(contact),
            Guard::Grip => !self.kept.intersection(self.grip.sticking).is_empty(),
            // It parts as soon as that is seen.
            Guard::Parting(_) => true,
            Guard::Gap(_) | Guard::Foot { .. } | Guard::Condition(_) => false,
        }
    }
}

/// A flight of a contact that has lifted off with its reaction at zero: g and ġ at the start of a
/// step, integrated since the lift-off.
#[derive(Debug, Clone, Copy)]
pub(super) struct LowFlight {
    pub(super) gap: f64,
    pub(super) rate: f64,
}

impl LowFlight {
    /// At a lift-off where the first nonzero derivative is of this order.
    fn begin(order: usize) -> Option<Self> {
        (order == ORDER).then_some(Self { gap: 0.0, rate: 0.0 })
    }
}

/// A guard.
pub(super) struct Watch {
    pub(super) guard: Guard,
    /// How high it will be in a low flight, whose bound is tighter than for its kind; else infinite. No `Option`: what that has in
    /// place of a value may be a subnormal, which compilers multiply all the same, and processors slowly.
    pub(super) height: f64,
    /// A corner beyond the end of its bar, which does not close before it has come back.
    pub(super) off: bool,
    /// A corner below its bar, which it has come to from beyond the end: it closes only after it has come back.
    pub(super) passed: bool,
    /// Where in the step it has gone below beyond the end.
    pub(super) passes: Cell<Option<f64>>,
    /// A reaction at zero of which more is known than its value: its contact stays closed; or a limit of friction or a slip
    /// velocity: it goes on as it is.
    pub(super) kept: bool,
    /// Its value has not left its bound since the phase began with it at zero.
    pub(super) at_root: bool,
    /// If it is zero at the start of the phase, the order of its first nonzero derivative.
    pub(super) order: Option<usize>,
    /// Of a contact that has lifted off with its reaction at zero, while its gap is low.
    pub(super) flight: Option<LowFlight>,
    /// The sign of a condition's difference, or of the gap of a drive, at the end of the last step.
    pub(super) sign: Option<bool>,
    /// Its place in the list.
    pub(super) index: usize,
    /// Of a limit of friction, its coefficient.
    pub(super) limit: f64,
    /// Of a guard of friction, its own series over the step.
    pub(super) rubbing: Vec<f64>,
    /// Whether its own series over the step counts as it.
    pub(super) has_series: bool,
    /// Whether its own series proves that it stays above its bound in the step.
    pub(super) is_clear: bool,
    /// Whether it is taken for noise where it turns too often to be followed.
    pub(super) is_noisy: bool,
    /// Whether a condition arms or disarms: what holds or not on either side of a pole is then there or not.
    pub(super) is_state: bool,
    /// Of a condition, whether series of its sides show by their size how well they converge.
    pub(super) is_entire: bool,
    /// Of a condition, its difference at the end of the step, if its series is known there to be beyond its bound.
    pub(super) end: Cell<Option<f64>>,
    /// Of a condition, what counted as zero in the step.
    pub(super) zero: Cell<f64>,
    /// Whether a comparison has ended the last step at zero: it is on the side that it came from.
    pub(super) stays: bool,
    /// How often a condition is evaluated in a step at most.
    pub(super) patience: Cell<u32>,
}

impl Watch {
    /// A guard as a phase begins; `index` is its place in the list.
    pub(super) fn of(guard: Guard, index: usize, roles: &ContactStatus, conditions: &[Condition]) -> Self {
        let contact = guard.gap();
        let height = contact.and_then(|i| roles.heights.iter().find(|(k, _)| *k == i));
        let order = contact.and_then(|i| roles.orders.iter().find(|(k, _)| *k == i)).map(|(_, m)| *m);
        Self {
            guard,
            height: height.map_or(f64::INFINITY, |(_, height)| *height),
            off: contact.is_some_and(|i| roles.off.contains(i)),
            passed: contact.is_some_and(|i| roles.passed.contains(i)),
            passes: Cell::new(None),
            kept: roles.keeps(guard),
            at_root: false,
            order,
            flight: order.and_then(LowFlight::begin),
            sign: None,
            index,
            limit: 0.0,
            rubbing: Vec::new(),
            has_series: false,
            is_clear: false,
            is_noisy: false,
            is_state: false,
            is_entire: matches!(guard, Guard::Condition(k) if conditions[k].is_entire()),
            end: Cell::new(None),
            zero: Cell::new(0.0),
            stays: false,
            patience: Cell::new(PATIENCE),
        }
    }

    /// Whether its values at the nodes of the first fit are asked for: its series neither counts as it nor proves it clear.
    pub(super) fn is_sampled(&self) -> bool {
        !self.has_series && !self.is_clear
    }

    /// Its own series over the step, if the method has it.
    pub(super) fn series<'s>(&'s self, step: &'s StepView<'_>) -> Option<&'s [f64]> {
        if self.rubbing.is_empty() { step.series(self.guard) } else { Some(&self.rubbing) }
    }
}

/// The guards of all contacts in a phase in which those of a set bear.
pub(super) fn guards(
    layout: &'static Layout,
    set: &ContactSet,
    roles: &ContactStatus<'_>,
    watch: &mut impl FnMut(Guard),
) {
    for (contact, description) in layout.contacts.iter().enumerate() {
        let (bears, closed) = (set.contains(contact), roles.closed.contains(contact));
        if let Some(own) = own_guard(contact, description.kind, bears, roles) {
            watch(own);
        }
        let parts = matches!(description.kind, ContactKind::Support | ContactKind::Thread);
        if closed && !bears && parts && !roles.held.contains(contact) {
            watch(Guard::Parting(contact));
        }
        let (slip, side) = (roles.closed.slip(contact), roles.closed.side(contact));
        // One that only depends on those that bear has no reaction to watch, and slips all the same.
        let is_watched = bears || closed && slip != Slip::Stick;
        if let Some(friction) =
            description.friction.filter(|_| is_watched && !roles.grip.sticking.contains(contact))
        {
            let rub = |slip| Rub { contact, friction, slip, side };
            match slip {
                Slip::Stick => [Slip::Forward, Slip::Backward]
                    .into_iter()
                    .for_each(|slip| watch(Guard::Limit(rub(slip)))),
                slip => watch(Guard::Slip(rub(slip))),
            }
        }
        if let Some(foot) = description.foot.filter(|_| closed) {
            [2 * foot, 2 * foot + 1].into_iter().for_each(|entry| watch(Guard::Foot { contact, entry }));
        }
    }
    if !roles.grip.is_empty() {
        watch(Guard::Grip);
    }
}

/// The guard of a contact's own reaction or gap.
fn own_guard(contact: usize, kind: ContactKind, bears: bool, roles: &ContactStatus<'_>) -> Option<Guard> {
    match (kind, bears) {
        // That of a hinge has no sign to watch.
        (ContactKind::Hinge { .. }, _) => None,
        // Of a guide that depends on those that bear there is nothing to watch.
        (ContactKind::Guide, false) => None,
        (_, false) => (!roles.removed.contains(contact)).then_some(Guard::Gap(contact)),
        _ if roles.grip.normals.contains(contact) => None,
        (ContactKind::Guide, true) => Some(Guard::Side(contact, roles.closed.side(contact))),
        (_, true) => (!roles.held.contains(contact)).then_some(Guard::Reaction(contact)),
    }
}
