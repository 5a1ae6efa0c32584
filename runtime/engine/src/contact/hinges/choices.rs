//! What each contact may do.

use crate::contact::ContactProblem;
use crate::contact::friction::{SlipDirection, SlipVelocity as KnownSlip};
use crate::model::{ContactKind, ContactSet, Layout, Side, Slip};

/// What a contact does.
#[derive(Debug, Clone, Copy)]
pub(super) struct HingeChoice {
    pub(super) is_open: bool,
    /// Closed whatever its reaction.
    pub(super) is_held: bool,
    /// Whether its opening, or the sense of its slip, is known and not asked for.
    pub(super) is_known: bool,
    /// Closed with its reaction at zero.
    pub(super) is_unloaded: bool,
    /// Of a closed contact with friction.
    pub(super) slip: Option<Slip>,
    pub(super) side: Side,
}

const CLOSED: HingeChoice = HingeChoice {
    is_open: false,
    is_held: false,
    is_known: false,
    is_unloaded: false,
    slip: None,
    side: Side::Positive,
};

impl HingeChoice {
    /// Of a hinge with a sense, 0 where it sticks.
    pub(super) fn of_hinge(sense: f64) -> Self {
        let slip = if sense == 0.0 {
            Slip::Stick
        } else if sense > 0.0 {
            Slip::Forward
        } else {
            Slip::Backward
        };
        Self { slip: Some(slip), ..CLOSED }
    }

    /// The set with a contact that does this.
    pub(super) fn close(&self, set: ContactSet, contact: usize) -> ContactSet {
        match self.slip {
            _ if self.is_open => set,
            None => set.with(contact),
            Some(slip) => set.slipping(contact, slip).pressing(contact, self.side),
        }
    }
}

/// A contact, and what it may do.
pub(super) type Options = (usize, Vec<HingeChoice>);

/// Of each touching contact.
pub(super) fn choices(layout: &Layout, question: &ContactProblem) -> Vec<Options> {
    let touching = question.touching.union(question.held).iter();
    touching.map(|contact| (contact, list_choices(layout, question, contact))).collect()
}

fn list_choices(layout: &Layout, question: &ContactProblem, contact: usize) -> Vec<HingeChoice> {
    let description = &layout.contacts[contact];
    let always = matches!(description.kind, ContactKind::Guide | ContactKind::Hinge { .. });
    let held = question.held.contains(contact);
    let is_unloaded = question.unloaded.contains(contact);
    let open = HingeChoice { is_open: true, is_known: is_unloaded, ..CLOSED };
    if open.is_known && !always {
        return vec![open];
    }
    let known = question.slips.iter().find(|(of, _)| *of == contact).map(|(_, known)| *known);
    let closed = match (description.friction, known) {
        (None, _) | (_, None) => vec![HingeChoice { is_held: held, ..CLOSED }],
        (Some(_), Some(known)) => slipping(known),
    };
    let sided = closed.iter().flat_map(|&closed| {
        let sides = [Side::Positive, Side::Negative].into_iter();
        sides.take(1 + usize::from(description.kind == ContactKind::Guide)).map(move |side| HingeChoice {
            side,
            is_unloaded,
            ..closed
        })
    });
    let can_open = !always && !held;
    sided.chain(can_open.then_some(open)).collect()
}

fn slipping(known: KnownSlip) -> Vec<HingeChoice> {
    let slides = |slip: Slip| HingeChoice { slip: Some(slip), is_known: true, ..CLOSED };
    match known {
        KnownSlip::Forward | KnownSlip::Leaves(SlipDirection::Forward) => vec![slides(Slip::Forward)],
        KnownSlip::Backward | KnownSlip::Leaves(SlipDirection::Backward) => vec![slides(Slip::Backward)],
        KnownSlip::Rest => [Slip::Stick, Slip::Forward, Slip::Backward]
            .map(|slip| HingeChoice { slip: Some(slip), ..CLOSED })
            .to_vec(),
    }
}
