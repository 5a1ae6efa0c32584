//! Which guards a phase has, and how large what counts as zero is.

use super::super::guards::list_guards;
use super::super::sample::Quantities;
use super::super::{ContactStatus, EventDetector, FrictionGuard, Guard, LOW};
use super::given::*;
use crate::contact::friction::SharedFriction;
use crate::model::{ContactSet, Form, Side, Slip};

fn rub(contact: usize, friction: usize, slip: Slip, side: Side) -> FrictionGuard {
    FrictionGuard { contact, friction, slip, side }
}

/// Closed contacts of all kinds: the rubbing one as said, the guide slides forward on its negative
/// side.
fn all(slip: Slip) -> ContactSet {
    let set = set(&[PLAIN, CORNER, THREAD, DRIVE, TURN]).slipping(RUBBING, slip);
    set.slipping(GUIDE, Slip::Forward).pressing(GUIDE, Side::Negative).slipping(HINGE, Slip::Backward)
}

fn listed(set: ContactSet, roles: &ContactStatus<'_>) -> Vec<Guard> {
    list_guards(&LAYOUT, &set, roles, (&[], &[])).iter().map(|watch| watch.tracking.guard).collect()
}

const FEET: [Guard; 2] =
    [Guard::Foot { contact: CORNER, entry: 0 }, Guard::Foot { contact: CORNER, entry: 1 }];

#[test]
fn open_contacts_have_gaps() {
    let none = ContactSet::EMPTY;
    let gaps = [PLAIN, RUBBING, CORNER, THREAD, DRIVE, TURN].map(Guard::Gap);
    assert_eq!(listed(none, &roles(none)), gaps);
    let removed = set(&[PLAIN, THREAD]);
    let left = [RUBBING, CORNER, DRIVE, TURN].map(Guard::Gap);
    assert_eq!(listed(none, &ContactStatus { removed, ..roles(none) }), left);
}

#[test]
fn closed_contacts_have_reactions_and_friction() {
    let slides = Guard::Slip(rub(GUIDE, 1, Slip::Forward, Side::Negative));
    let journal = Guard::Slip(rub(HINGE, 2, Slip::Backward, Side::Positive));
    for slip in [Slip::Stick, Slip::Forward, Slip::Backward] {
        let rubbing = match slip {
            Slip::Stick => [Slip::Forward, Slip::Backward]
                .map(|sense| Guard::Limit(rub(RUBBING, 0, sense, Side::Positive)))
                .to_vec(),
            _ => vec![Guard::Slip(rub(RUBBING, 0, slip, Side::Positive))],
        };
        for held in [ContactSet::EMPTY, set(&[PLAIN, DRIVE, TURN])] {
            let reaction = |contact: usize| (!held.contains(contact)).then_some(Guard::Reaction(contact));
            let mut expected: Vec<Guard> = reaction(PLAIN).into_iter().collect();
            expected.push(Guard::Reaction(RUBBING));
            expected.extend(&rubbing);
            expected.extend([Guard::Side(GUIDE, Side::Negative), slides, Guard::Reaction(CORNER)]);
            expected.extend(FEET);
            expected.extend([THREAD, DRIVE, TURN].into_iter().filter_map(reaction));
            expected.push(journal);
            let status = ContactStatus { held, ..roles(all(slip)) };
            assert_eq!(listed(all(slip), &status), expected, "{slip:?}");
        }
    }
}

/// A contact that is closed because others are has no reaction; it parts, and slips if it does.
#[test]
fn contacts_that_depend_on_others_part() {
    let none = ContactSet::EMPTY;
    for (slip, held) in [(Slip::Stick, none), (Slip::Backward, set(&[PLAIN])), (Slip::Forward, none)] {
        let mut expected = vec![Guard::Gap(PLAIN)];
        expected.extend((!held.contains(PLAIN)).then_some(Guard::RedundantGap(PLAIN)));
        expected.extend([Guard::Gap(RUBBING), Guard::RedundantGap(RUBBING)]);
        let slides = Guard::Slip(rub(RUBBING, 0, slip, Side::Positive));
        expected.extend((slip != Slip::Stick).then_some(slides));
        expected.push(Guard::Slip(rub(GUIDE, 1, Slip::Forward, Side::Negative)));
        expected.extend([Guard::Gap(CORNER), Guard::RedundantGap(CORNER)]);
        expected.extend(FEET);
        expected.extend([
            Guard::Gap(THREAD),
            Guard::RedundantGap(THREAD),
            Guard::Gap(DRIVE),
            Guard::Gap(TURN),
        ]);
        expected.push(Guard::Slip(rub(HINGE, 2, Slip::Backward, Side::Positive)));
        let status = ContactStatus { held, ..roles(all(slip)) };
        assert_eq!(listed(none, &status), expected, "{slip:?}");
    }
}

/// Contacts that share a load have no limits of their own, nor those reactions that are not
/// determined.
#[test]
fn contacts_that_share_a_load_have_one_margin() {
    let stick = all(Slip::Stick);
    let own = listed(stick, &roles(stick));
    let limit = |guard: &Guard| matches!(guard, Guard::Limit(_));
    for normals in [ContactSet::EMPTY, set(&[RUBBING])] {
        let grip = SharedFriction { sticking: set(&[RUBBING]), normals };
        let status = ContactStatus { shared_friction: grip, ..roles(stick) };
        let gone =
            |guard: &Guard| limit(guard) || *guard == Guard::Reaction(RUBBING) && normals.contains(RUBBING);
        let kept = own.iter().copied().filter(|guard| !gone(guard));
        let expected: Vec<Guard> = kept.chain([Guard::SharedFriction]).collect();
        assert_eq!(listed(stick, &status), expected);
    }
}

#[test]
fn each_guard_is_evaluated_from_what_it_follows_from() {
    let (stick, grip) =
        (all(Slip::Stick), SharedFriction { sticking: set(&[GUIDE]), normals: ContactSet::EMPTY });
    let scene = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
    let conditions = [scene.condition("z < 4")];
    for (bearing, closed) in [(stick, stick), (ContactSet::EMPTY, all(Slip::Forward))] {
        let status = ContactStatus { shared_friction: grip, ..roles(closed) };
        for watch in list_guards(&LAYOUT, &bearing, &status, (&conditions, &[(0, false)])) {
            let expected = match watch.tracking.guard {
                Guard::Reaction(_) | Guard::Side(..) => Quantities::REACTIONS,
                Guard::Gap(_) | Guard::RedundantGap(_) => Quantities::GAPS,
                Guard::Foot { .. } => Quantities::FEET,
                Guard::Limit(_) => Quantities::REACTIONS.and(Quantities::SLIPS),
                Guard::SharedFriction => Quantities::REACTIONS.and(Quantities::GRIP),
                Guard::Slip(_) => Quantities::SLIPS,
                Guard::Condition(_) => Quantities::NONE,
            };
            assert_eq!(watch.tracking.asked, expected, "{:?}", watch.tracking.guard);
        }
    }
}

/// Each in its unit; in a low flight a part of its height.
#[test]
fn zero_bounds_of_guards() {
    let closed = set(&[PLAIN, CORNER]).slipping(RUBBING, Slip::Stick).slipping(GUIDE, Slip::Backward);
    let grip = SharedFriction { sticking: set(&[RUBBING]), normals: ContactSet::EMPTY };
    let scene = Scene::new((closed, Form::Reduced), |_| Shown::default());
    let heights = [(THREAD, 1e-6), (DRIVE, 1.0)];
    for grip in [SharedFriction::default(), grip] {
        let roles = ContactStatus { shared_friction: grip, heights: &heights, ..roles(closed) };
        let located = [(0, false)];
        let conditions = [scene.condition("z < 4")];
        let detector = EventDetector::new(&LAYOUT, closed, roles, (&conditions, &located), BOUNDS);
        let dense = scene.dense([0.0, 1.0]);
        let view = scene.view(&dense);
        for watch in &detector.list {
            let expected = match watch.tracking.guard {
                Guard::Reaction(contact) | Guard::Side(contact, _) => FORCES[contact],
                Guard::Limit(rub) => FORCES[rub.contact],
                Guard::Slip(rub) => SLIPS[rub.friction],
                Guard::SharedFriction => 13.0,
                Guard::Gap(TURN) => 1.0,
                // Of its sides the greater one, 4.
                Guard::Condition(_) => 4.0,
                Guard::Gap(THREAD) => LOW,
                Guard::Gap(_) | Guard::RedundantGap(_) | Guard::Foot { .. } => BOUNDS.length,
            };
            let (found, name) = (watch.bound(&detector.sampled(&view), &[0.0, 0.5]), watch.tracking.guard);
            assert!((found / (expected * BOUNDS.relative) - 1.0).abs() < 1e-12, "{name:?} {found}");
        }
    }
}

/// The bound itself is zero yet, on either side, at the start and later; and a guard at zero is
/// known to be so until it has left.
#[test]
fn values_at_their_bound_are_zero() {
    let bound = BOUNDS.relative * FORCES[THREAD];
    for (value, is_zero) in
        [(bound, true), (-bound, true), (bound.next_up(), false), (-bound.next_up(), false)]
    {
        let closed = set(&[THREAD]);
        let scene = Scene::closed(closed, move |_| {
            let mut shown = Shown::default();
            shown.reactions[THREAD] = value;
            shown
        });
        let detector = scene.begun(roles(closed), (&[], false));
        let thread = detector.find(Guard::Reaction(THREAD));
        assert_eq!(thread.tracking.at_root, is_zero, "{value:e}");
        let dense = scene.dense([0.0, 1.0]);
        let view = scene.view(&dense);
        assert_eq!(thread.is_zero(&detector.sampled(&view), 0.5), is_zero, "{value:e}");
    }
}
