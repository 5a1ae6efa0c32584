//! The guards of a contact set.

use core::ops::{Deref, DerefMut};

use super::condition::ConditionGuard;
use super::drive::DriveGuard;
use super::foot::FootGuard;
use super::gap::GapGuard;
use super::grip::GripGuard;
use super::limit::LimitGuard;
use super::parting::PartingGuard;
use super::reaction::ReactionGuard;
use super::slip::SlipGuard;
use super::watched::Watched;
use crate::event::detection::Rub;
use crate::event::detection::contact_status::ContactStatus;
use crate::expression::Condition;
use crate::model::{ContactKind, ContactSet, Layout, Slip};

/// A guard of any kind, without an allocation of its own.
pub(crate) enum Kind<'a> {
    Reaction(ReactionGuard),
    Gap(GapGuard),
    Drive(DriveGuard),
    Parting(PartingGuard),
    Foot(FootGuard),
    Limit(LimitGuard),
    Slip(SlipGuard),
    Grip(GripGuard),
    Condition(ConditionGuard<'a>),
}

impl<'a> Deref for Kind<'a> {
    type Target = dyn Watched + 'a;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Reaction(guard) => guard,
            Self::Gap(guard) => guard,
            Self::Drive(guard) => guard,
            Self::Parting(guard) => guard,
            Self::Foot(guard) => guard,
            Self::Limit(guard) => guard,
            Self::Slip(guard) => guard,
            Self::Grip(guard) => guard,
            Self::Condition(guard) => guard,
        }
    }
}

impl DerefMut for Kind<'_> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            Self::Reaction(guard) => guard,
            Self::Gap(guard) => guard,
            Self::Drive(guard) => guard,
            Self::Parting(guard) => guard,
            Self::Foot(guard) => guard,
            Self::Limit(guard) => guard,
            Self::Slip(guard) => guard,
            Self::Grip(guard) => guard,
            Self::Condition(guard) => guard,
        }
    }
}

/// The guards of a phase in which a set of contacts bears: of all contacts, then of conditions, each with whether it arms
/// or disarms.
pub(crate) fn list_guards<'a>(
    layout: &'static Layout,
    set: &ContactSet,
    status: &ContactStatus<'_>,
    (conditions, located): (&'a [Condition], &[(usize, bool)]),
    watch: &mut impl FnMut(Kind<'a>),
) {
    for (contact, description) in layout.contacts.iter().enumerate() {
        let (bears, closed) = (set.contains(contact), status.closed.contains(contact));
        if let Some(own) = own_guard(layout, contact, bears, status) {
            watch(own);
        }
        let parts = matches!(description.kind, ContactKind::Support | ContactKind::Thread);
        if closed && !bears && parts && !status.held.contains(contact) {
            watch(Kind::Parting(PartingGuard { contact }));
        }
        let (slip, side) = (status.closed.slip(contact), status.closed.side(contact));
        // One that only depends on those that bear has no reaction to watch, and slips all the same.
        let is_watched = bears || closed && slip != Slip::Stick;
        if let Some(friction) =
            description.friction.filter(|_| is_watched && !status.grip.sticking.contains(contact))
        {
            let rub = |slip| Rub { contact, friction, slip, side };
            let (force, kept) = (layout.contacts.len() + friction, status.kept.contains(contact));
            match slip {
                Slip::Stick => [Slip::Forward, Slip::Backward]
                    .into_iter()
                    .for_each(|slip| watch(Kind::Limit(LimitGuard::new(rub(slip), force, kept)))),
                slip => watch(Kind::Slip(SlipGuard::new(rub(slip), force, kept))),
            }
        }
        if let Some(foot) = description.foot.filter(|_| closed) {
            for entry in [2 * foot, 2 * foot + 1] {
                watch(Kind::Foot(FootGuard { contact, entry }));
            }
        }
    }
    if !status.grip.is_empty() {
        let kept = !status.kept.intersection(status.grip.sticking).is_empty();
        watch(Kind::Grip(GripGuard { kept }));
    }
    for &(place, is_state) in located {
        watch(Kind::Condition(ConditionGuard::new(place, &conditions[place], is_state)));
    }
}

/// The guard of a contact's own reaction or gap.
fn own_guard<'a>(
    layout: &Layout,
    contact: usize,
    bears: bool,
    status: &ContactStatus<'_>,
) -> Option<Kind<'a>> {
    let kind = layout.contacts[contact].kind;
    let kept = status.kept.contains(contact);
    match (kind, bears) {
        // That of a hinge has no sign to watch.
        (ContactKind::Hinge { .. }, _) => None,
        // Of a guide that depends on those that bear there is nothing to watch.
        (ContactKind::Guide, false) => None,
        (_, false) if status.removed.contains(contact) => None,
        // What it drives may come from either side.
        (_, false) if kind.is_drive() => Some(Kind::Drive(DriveGuard::new(contact, status))),
        (_, false) => Some(Kind::Gap(GapGuard::new(contact, layout, status))),
        _ if status.grip.normals.contains(contact) => None,
        (ContactKind::Guide, true) => {
            Some(Kind::Reaction(ReactionGuard::new(contact, Some(status.closed.side(contact)), kept)))
        }
        (_, true) if status.held.contains(contact) => None,
        (_, true) => Some(Kind::Reaction(ReactionGuard::new(contact, None, kept))),
    }
}
