//! Reactions and supports by their names.

mod reported;

use super::{Reaction, reactions, supports};
use crate::model::{Contact, ContactKind, ContactSet, Friction, Joint, Law, Layout};
use crate::system::Model;

use liftoff_fixtures::Particle;

const fn contact(
    label: &'static str,
    supports: &'static [&'static str],
    shared: bool,
    friction: Option<usize>,
) -> Contact {
    let (foot, armed, law) = (None, None, Law::Newton);
    let kind = ContactKind::Support;
    Contact {
        label,
        supports,
        shared,
        foot,
        kind,
        rough: false,
        friction,
        jams: false,
        law,
        stop: false,
        armed,
        breaks: armed,
    }
}

/// Two mirror images, two supports whose shares are open, and one alone, with a joint between their
/// rows and those of friction.
const CONTACTS: [Contact; 3] = [
    contact("B, A", &["B", "A"], true, Some(0)),
    contact("E, C", &["E", "C"], false, None),
    contact("D", &["D"], true, Some(1)),
];

fn layout() -> Layout {
    (*Model::new(&Particle { m: 1.0, g: 1.0, e: 0.0 }).layout())
        .contacts(&CONTACTS)
        .joints(&[Joint { name: "hinge J", is_angle: false }])
        .tangents(&[0, 2])
        .frictions(&[
            Friction { contact: 0, row: 4, follows_slip: false },
            Friction { contact: 2, row: 5, follows_slip: false },
        ])
}

#[test]
fn reactions_are_shared_where_the_shares_are_known() {
    let one = |contact, label: &'static str, value, friction| Reaction { contact, label, value, friction };
    let expected = [
        one(0, "B", 3.0, Some(-1.0)),
        one(0, "A", 3.0, Some(-1.0)),
        one(1, "E, C", 5.0, None),
        one(2, "D", 7.0, Some(4.0)),
    ];
    // As phases have them, and as rows of the kernel.
    assert_eq!(reactions(&layout(), &[6.0, 5.0, 7.0, -2.0, 4.0]), expected);
    assert_eq!(reactions(&layout(), &[6.0, 5.0, 7.0, 9.0, -2.0, 4.0]), expected);
    let without = expected.map(|it| Reaction { friction: None, ..it });
    assert_eq!(reactions(&layout(), &[6.0, 5.0, 7.0]), without);
}

#[test]
fn supports_are_reported_by_name() {
    let of = |bits: u64| supports(&layout(), ContactSet::from_bits(bits));
    assert_eq!(of(0b011), ["A", "B", "C", "E"]);
    assert_eq!(of(0b101), ["A", "B", "D"]);
    assert!(of(0).is_empty());
}
