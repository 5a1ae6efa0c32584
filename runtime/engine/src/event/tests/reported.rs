//! Events by their names and numbers.

use core::f64::consts::{FRAC_PI_2, PI};

use liftoff_fixtures::Particle;

use super::layout;
use crate::event::{Event, EventFilter, EventKind, FrictionState, Note, Occurrence, Reaction};
use crate::model::{Coordinate, Energy, Layout};
use crate::system::Model;

const COORDINATES: [Coordinate; 2] =
    [Coordinate { name: "phi", is_angle: true }, Coordinate { name: "x", is_angle: false }];

fn event(kind: EventKind, supports: &[&'static str]) -> Event {
    let reaction = |label: &'static str, value| Reaction { contact: 0, label, value, friction: None };
    Event {
        t: 2.5,
        kind,
        supports: supports.to_vec(),
        state: vec![FRAC_PI_2, -0.25, 3.0, 7.0],
        reactions: vec![reaction("A", 1.5), reaction("B, C", -2.5)],
        energy: Energy { kinetic: 0.0, potential: 0.0 },
        before: None,
        impulses: Vec::new(),
        note: None,
        coordinates: &COORDINATES,
        dependent: vec![("psi", [-PI, -6.0])],
        length: 1.0,
    }
}

#[test]
fn coordinates_rates_and_time_are_reported_by_name() {
    let event = event(EventKind::Stop, &[]);
    for (name, value) in [
        ("phi", FRAC_PI_2),
        ("x", -0.25),
        ("phi'", 3.0),
        ("x'", 7.0),
        ("psi", -PI),
        ("psi'", -6.0),
        ("t", 2.5),
    ] {
        assert_eq!((event.get(name), event[name]), (Some(value), value), "{name}");
    }
    for name in ["y", "y'", "phi''", "", "'"] {
        assert_eq!(event.get(name), None, "{name}");
    }
}

#[test]
#[should_panic(expected = "no coordinate `y` in an event; known: phi, x")]
fn a_name_that_is_none_is_reported() {
    let _ = event(EventKind::Stop, &[])["y"];
}

#[test]
fn reactions_are_reported_by_support() {
    let event = event(EventKind::Open, &["D"]);
    let told = ["A", "B", "C", "D", "B, C"].map(|support| event.reaction(support));
    assert_eq!(told, [Some(1.5), Some(-2.5), Some(-2.5), None, None]);
}

#[test]
fn what_is_undecided_is_reported_by_the_note() {
    let friction = |undecided: [bool; 2]| {
        let of = |undecided| FrictionState {
            contact: "A",
            normal: 1.0,
            force: 0.5,
            limit: 0.5,
            slides: false,
            undecided,
        };
        Note::Friction(undecided.map(of).to_vec())
    };
    for (note, is_undecided) in [
        (None, false),
        (Some(Note::Undecided), true),
        (Some(Note::GapUndecided), true),
        (Some(Note::GapTouches), false),
        (Some(friction([false, false])), false),
        (Some(friction([false, true])), true),
        (Some(friction([true, false])), true),
    ] {
        assert_eq!(Event { note, ..event(EventKind::Touch, &[]) }.is_undecided(), is_undecided);
    }
}

/// What is rounding of the natural length, or of an angle of 1, is zero.
#[test]
fn a_line_has_what_there_is_to_say() {
    let open = event(EventKind::Open, &["A", "C"]);
    assert_eq!(open.to_string(), "A, C open at t = 2.500, phi = 1.571, x = -0.2500, psi = -3.142");
    let stop = Event { note: Some(Note::Undecided), ..event(EventKind::Stop, &[]) };
    assert_eq!(stop.to_string(), "stop at t = 2.500, phi = 1.571, x = -0.2500, psi = -3.142 (undecided)");
    let small = |length, state: [f64; 2]| {
        Event { length, state: state.to_vec(), ..event(EventKind::End, &[]) }.to_string()
    };
    assert_eq!(small(1e-20, [1e-17, 1e-17]), "end at t = 2.500, phi = 0, x = 1.000e-17, psi = -3.142");
    assert_eq!(small(1e20, [1e-3, 1e-3]), "end at t = 2.500, phi = 0.001000, x = 0, psi = -3.142");
}

#[test]
fn events_are_looked_up_by_kind_and_support() {
    let layout: &'static Layout = Box::leak(Box::new(layout()));
    let of = |kind, support: Option<&str>| EventFilter::new(layout, kind, support).expect("a support");
    let (open, impact) = (event(EventKind::Open, &["A", "C"]), event(EventKind::Impact, &["A"]));
    for (kind, support, expected) in [
        (EventKind::Open, None, [true, false]),
        (EventKind::Open, Some("A"), [true, false]),
        (EventKind::Open, Some("C"), [true, false]),
        (EventKind::Open, Some("B"), [false, false]),
        (EventKind::Impact, Some("A"), [false, true]),
        (EventKind::Impact, Some("C"), [false, false]),
    ] {
        let filter = of(kind, support);
        assert_eq!([&open, &impact].map(|event| filter.is(event)), expected, "{filter}");
        assert_eq!((filter.kind, filter.support), (kind, support));
    }
    assert_eq!(of(EventKind::SlideOff, Some("E")).to_string(), "slide-off E");
    assert_eq!(of(EventKind::SlideOff, None).to_string(), "slide-off");
    let error = EventFilter::new(layout, EventKind::Open, "F").expect_err("no support");
    assert!(error.to_string().starts_with("no support `F`; known: "), "{error}");
    assert!(
        EventFilter::new(Model::new(&Particle { m: 1.0, g: 1.0, e: 0.0 }).layout(), open.kind, "A").is_err()
    );
}

/// English ordinals: of the tens all but the second end by their last digit.
#[test]
fn occurrences_are_read_as_they_are_written() {
    let ordinal = |n: usize| match (n / 10 % 10, n % 10) {
        (1, _) => "th",
        (_, 1) => "st",
        (_, 2) => "nd",
        (_, 3) => "rd",
        _ => "th",
    };
    for n in 1..1200 {
        let word = format!("{n}{}", ordinal(n));
        let nth = Occurrence::Nth(n);
        assert_eq!(Occurrence::parse(&word), Some(nth));
        assert_eq!(nth.to_string(), if n == 1 { "first" } else { &word });
        for other in ["st", "nd", "rd", "th", "", "x"].into_iter().filter(|other| *other != ordinal(n)) {
            assert_eq!(Occurrence::parse(&format!("{n}{other}")), None, "{n}{other}");
        }
    }
    assert_eq!(Occurrence::parse("first"), Some(Occurrence::Nth(1)));
    assert_eq!(Occurrence::parse("last"), Some(Occurrence::Last));
    assert_eq!(Occurrence::Last.to_string(), "last");
    for word in
        ["0th", "00th", "01st", "+1st", "-1st", "st", "", "1 st", "1stx", "First", "99999999999999999999th"]
    {
        assert_eq!(Occurrence::parse(word), None, "{word}");
    }
}

#[test]
fn an_event_is_found_by_its_number() {
    let kinds = [EventKind::Start, EventKind::Open, EventKind::Impact, EventKind::Open, EventKind::End];
    let events = kinds.map(|kind| event(kind, &["A"]));
    let found = |occurrence: Occurrence, kind| occurrence.find(&events, &EventFilter { kind, support: None });
    let open = [0, 1, 2, 3].map(|n| found(Occurrence::Nth(n), EventKind::Open));
    assert_eq!(open, [None, Some(1), Some(3), None]);
    assert_eq!(found(Occurrence::Last, EventKind::Open), Some(3));
    assert_eq!(found(Occurrence::Last, EventKind::Impact), Some(2));
    assert_eq!(found(Occurrence::Last, EventKind::Slip), None);
}
