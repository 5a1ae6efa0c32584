//! The guards of a contact set.

use super::condition::ConditionGuard;
use super::drive::DriveGuard;
use super::foot::FootGuard;
use super::gap::GapGuard;
use super::grip::GripGuard;
use super::limit::LimitGuard;
use super::parting::PartingGuard;
use super::reaction::ReactionGuard;
use super::slip::SlipGuard;
use super::watch::Watch;
use crate::event::detection::FrictionGuard;
use crate::event::detection::contact_status::ContactStatus;
use crate::expression::Condition;
use crate::model::{ContactKind, ContactSet, Layout, Slip};

/// The guards of a phase in which a set of contacts bears: of all contacts, then of conditions,
/// each with whether it arms or disarms.
pub(crate) fn list_guards<'a>(
    layout: &'static Layout,
    set: &ContactSet,
    status: &ContactStatus<'_>,
    (conditions, located): (&'a [Condition], &[(usize, bool)]),
) -> Vec<Watch<'a>> {
    let mut list = Vec::with_capacity(layout.contacts.len() + located.len());
    for (contact, description) in layout.contacts.iter().enumerate() {
        let (bears, closed) = (set.contains(contact), status.closed.contains(contact));
        list.extend(own_guard(layout, contact, bears, status));
        let parts = description.kind.is_one_sided();
        if closed && !bears && parts && !status.held.contains(contact) {
            list.push(PartingGuard::watch(contact));
        }
        let (slip, side) = (status.closed.slip(contact), status.closed.side(contact));
        // One that only depends on those that bear has no reaction to watch, and slips all the
        // same.
        let is_watched = bears || closed && slip != Slip::Stick;
        if let Some(friction) =
            description.friction.filter(|_| is_watched && !status.shared_friction.sticking.contains(contact))
        {
            let rub = |slip| FrictionGuard { contact, friction, slip, side };
            let (row, kept) = (layout.contacts.len() + friction, status.suppressed.contains(contact));
            match slip {
                Slip::Stick => {
                    list.extend(
                        [Slip::Forward, Slip::Backward].map(|slip| LimitGuard::watch(rub(slip), row, kept)),
                    );
                }
                slip => list.push(SlipGuard::watch(rub(slip), row, kept)),
            }
        }
        if let Some(foot) = description.foot.filter(|_| closed) {
            list.extend([2 * foot, 2 * foot + 1].map(|entry| FootGuard::watch(contact, entry)));
        }
    }
    if !status.shared_friction.is_empty() {
        list.push(GripGuard::watch(
            !status.suppressed.intersection(status.shared_friction.sticking).is_empty(),
        ));
    }
    list.extend(located.iter().map(|&(k, is_state)| ConditionGuard::watch(k, &conditions[k], is_state)));
    list
}

/// The guard of a contact's own reaction or gap.
fn own_guard<'a>(
    layout: &Layout,
    contact: usize,
    bears: bool,
    status: &ContactStatus<'_>,
) -> Option<Watch<'a>> {
    let kind = layout.contacts[contact].kind;
    let kept = status.suppressed.contains(contact);
    match (kind, bears) {
        // That of a hinge has no sign to watch.
        (ContactKind::Hinge { .. }, _) => None,
        // Of a guide that depends on those that bear there is nothing to watch.
        (ContactKind::Guide, false) => None,
        (_, false) if status.removed.contains(contact) => None,
        (_, false) if kind.is_drive() => Some(DriveGuard::watch(contact, status)),
        (_, false) => Some(GapGuard::watch(contact, layout.contacts[contact].foot, status)),
        _ if status.shared_friction.normals.contains(contact) => None,
        (ContactKind::Guide, true) => {
            Some(ReactionGuard::watch(contact, Some(status.closed.side(contact)), kept))
        }
        (_, true) => (!status.held.contains(contact)).then(|| ReactionGuard::watch(contact, None, kept)),
    }
}
