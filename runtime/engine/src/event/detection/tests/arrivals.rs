//! What is zero at the end of a run, together, or in doubt.

use super::super::{ContactStatus, Guard};
use super::given::*;
use crate::contact::friction::SharedFriction;
use crate::model::{ContactSet, Form, Side, Slip};
use crate::numerics::root_isolation::GuardError;

const BOUND: f64 = BOUNDS.relative * FORCES[PLAIN];

fn of_reaction(g: impl Fn(f64) -> f64 + Copy + Send + Sync + 'static) -> Scene {
    Scene::closed(set(&[PLAIN]), move |t| {
        let mut shown = Shown::default();
        shown.reactions[PLAIN] = g(t);
        shown
    })
}

/// A reaction that has fallen into its bound at the end of the last step counts there, unless it
/// turns there.
#[test]
fn a_run_ends_with_what_falls_to_zero_there() {
    let ends = |g: fn(f64) -> f64, steps: &[f64]| of_reaction(g).first(roles(set(&[PLAIN])), steps);
    for steps in [&[1.0][..], &[0.5, 1.0], &[0.3, 0.9, 1.0]] {
        assert_eq!(ends(|t| 1.0 - t + 0.5 * BOUND, steps), Some(1.0));
        assert_eq!(ends(|t| 1.0 - t + 2.0 * BOUND, steps), None);
        assert_eq!(ends(|t| (1.0 - t) * (1.0 - t) + 0.5 * BOUND, steps), None);
        assert_eq!(ends(|t| (1.0 - t) * (2.0 - t) + 0.5 * BOUND, steps), Some(1.0));
        // Known to be zero from the start on.
        assert_eq!(ends(|t| 0.5 * BOUND * (1.0 - t), steps), None);
    }
    // The same in a step that is not the last one.
    let scene = of_reaction(|t| (1.0 - t).abs() + 0.5 * BOUND);
    let mut detector = scene.begun(roles(set(&[PLAIN])), (&[], false));
    let dense = scene.dense([0.0, 1.0]);
    assert!(detector.examine(&scene.view(&dense), false).unwrap().first.is_none());
}

/// It falls by more than its bound over the last 64th, and by three quarters of what it fell by
/// over the one before.
#[test]
fn what_falls_to_zero_at_the_end_keeps_falling() {
    // α x + β x² with x = 1 − t falls by (α + β/64)/64 at last, and by (α + 3β/64)/64 before.
    for (alpha, beta, arrives) in [
        (5.25 / 64.0, 1.0, true),
        (4.75 / 64.0, 1.0, false),
        (65.0 * BOUND, 0.0, true),
        (63.0 * BOUND, 0.0, false),
    ] {
        for last in [0.5 * BOUND, -0.5 * BOUND, BOUND] {
            let scene = of_reaction(move |t| alpha * (1.0 - t) + beta * (1.0 - t) * (1.0 - t) + last);
            let found = scene.first(roles(set(&[PLAIN])), &[1.0]);
            assert_eq!(found, arrives.then_some(1.0), "{alpha} {beta} {last}");
        }
        let scene = of_reaction(move |t| alpha * (1.0 - t) + beta * (1.0 - t) * (1.0 - t) + BOUND.next_up());
        assert_eq!(scene.first(roles(set(&[PLAIN])), &[1.0]), None, "{alpha} {beta}");
    }
    // By its bound itself is not by more.
    assert_eq!(of_reaction(|t| 64.0 * BOUND * (1.0 - t)).first(roles(set(&[PLAIN])), &[1.0]), None);
}

#[test]
fn a_condition_does_not_arrive() {
    let scene = Scene::closed(ContactSet::EMPTY, |t| Shown { z: [1.0 - t + 1e-7, -1.0], ..Shown::default() });
    let conditions = [scene.condition("z < 0")];
    let mut detector = scene.begun(
        ContactStatus { removed: set(&[0, 1, 3, 4, 5, 6]), ..roles(ContactSet::EMPTY) },
        (&conditions, false),
    );
    assert_eq!(detector.list.len(), 1);
    assert!(scene.follow(&mut detector, &[1.0]).unwrap().0.is_none());
}

/// Three reactions fall at once, two of them to zero.
#[test]
fn guards_that_are_zero_together_are_reported_together() {
    for (late, together) in [(0.4, true), (0.9, true), (1.2, false), (-0.9, true), (5.0, false)] {
        let closed = set(&[PLAIN, CORNER, THREAD]);
        let scene = Scene::closed(closed, move |t| {
            let mut shown = Shown { feet: [1.0; 2], ..Shown::default() };
            shown.reactions[PLAIN] = 0.5 - t;
            shown.reactions[CORNER] = FORCES[CORNER] * (0.5 - t + late * BOUNDS.relative);
            shown.reactions[THREAD] = 1.0 - t;
            shown
        });
        let mut detector = scene.begun(roles(closed), (&[], false));
        let (first, _) = scene.follow(&mut detector, &[1.0]).unwrap();
        let (at, guards) = first.unwrap();
        assert!((at - 0.5 - late.min(0.0) * BOUNDS.relative).abs() < 1e-12, "{at}");
        let expected = [Guard::Reaction(PLAIN), Guard::Reaction(CORNER)];
        assert_eq!(guards, expected[..if together { 2 } else { 1 }], "{late}");
    }
}

/// A touch comes before the first event; one behind it is none.
#[test]
fn touches_before_the_first_event_are_reported_in_order() {
    let closed = set(&[PLAIN, THREAD]);
    let scene = Scene::closed(closed, |t| {
        let mut shown = Shown::default();
        shown.reactions[PLAIN] = (t - 0.75).powi(2) * (0.9 - t);
        shown.reactions[THREAD] = (t - 0.25).powi(2) * (t - 0.95).powi(2);
        shown
    });
    let mut detector = scene.begun(roles(closed), (&[], false));
    let (first, touches) = scene.follow(&mut detector, &[1.0]).unwrap();
    let (at, guards) = first.unwrap();
    assert!((at - 0.9).abs() < 1e-9 && guards == [Guard::Reaction(PLAIN)], "{at}");
    let told: Vec<Guard> = touches.iter().map(|(_, guard)| *guard).collect();
    assert_eq!(told, [Guard::Reaction(THREAD), Guard::Reaction(PLAIN)], "{touches:?}");
    assert!((touches[0].0 - 0.25).abs() < 1e-6 && (touches[1].0 - 0.75).abs() < 1e-6);
}

/// What touches zero where the first event is, at the end of the run, is zero together with it.
#[test]
fn a_touch_at_the_first_event_is_part_of_it() {
    let closed = set(&[PLAIN, THREAD]);
    let scene = Scene::closed(closed, |t| {
        let mut shown = Shown::default();
        shown.reactions[PLAIN] = 1.0 - t;
        shown.reactions[THREAD] = (t - 1.0).powi(2);
        shown
    });
    let mut detector = scene.begun(roles(closed), (&[], false));
    let (first, touches) = scene.follow(&mut detector, &[1.0]).unwrap();
    assert_eq!(first, Some((1.0, vec![Guard::Reaction(PLAIN), Guard::Reaction(THREAD)])));
    assert!(touches.is_empty(), "{touches:?}");
}

/// By more than a 64th of the bound a touch may be a crossing; guards that are neither a reaction
/// nor a gap are decided.
#[test]
fn a_touch_is_undecided_where_it_is_not_at_zero() {
    let closed = set(&[THREAD, CORNER]).slipping(GUIDE, Slip::Forward).pressing(GUIDE, Side::Negative);
    let scene = Scene::new((closed, Form::Reduced), |_| Shown::default());
    let grip = SharedFriction { sticking: set(&[GUIDE]), normals: ContactSet::EMPTY };
    let detector =
        scene.begun(ContactStatus { shared_friction: grip, ..roles(closed.with(PLAIN)) }, (&[], false));
    for (guard, size) in [
        (Guard::Reaction(THREAD), FORCES[THREAD]),
        (Guard::Side(GUIDE, Side::Negative), FORCES[GUIDE]),
        (Guard::Gap(PLAIN), BOUNDS.length),
    ] {
        for sign in [1.0, -1.0] {
            let told = |part: f64| {
                let value = sign * part * BOUNDS.relative * size / 64.0;
                let (mut reactions, mut gaps) = ([f64::INFINITY; CONTACTS], [f64::INFINITY; CONTACTS]);
                match guard {
                    Guard::Gap(contact) => gaps[contact] = value,
                    _ => reactions[guard.contact().unwrap()] = value,
                }
                detector.is_undecided(guard, &reactions, &gaps)
            };
            assert!(told(1.01) && !told(1.0) && !told(0.99) && !told(0.0), "{guard:?}");
        }
    }
    for guard in
        [Guard::RedundantGap(PLAIN), Guard::SharedFriction, Guard::Foot { contact: CORNER, entry: 1 }]
    {
        assert_eq!(detector.find(guard).tracking.guard, guard);
        assert!(!detector.is_undecided(guard, &[f64::INFINITY; CONTACTS], &[f64::INFINITY; CONTACTS]));
    }
}

/// What turns too often is said not to be resolved, and by which guard; it is followed once it is
/// taken for noise, and where a step cannot be made shorter.
#[test]
fn a_guard_that_is_not_resolved_is_reported() {
    let closed = set(&[PLAIN]).slipping(RUBBING, Slip::Forward);
    let scene = Scene::closed(closed, |t| {
        let mut shown = Shown::default();
        shown.reactions[PLAIN] = 1.0 - 0.5 * t;
        // Hashed, above zero up to 1/2 and below behind.
        let hash = t.to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11;
        let noise = hash as f64 / (1u64 << 53) as f64;
        shown.reactions[RUBBING] = if t < 0.5 { 1.0 + noise } else { -1.0 - noise };
        shown.slips[0] = [1.0, 0.1];
        shown
    });
    let mut detector = scene.begun(roles(closed), (&[], false));
    let (dense, first) = (scene.dense([0.0, 1.0]), scene.dense([0.0, 0.4]));
    let error = detector.examine(&scene.view(&dense), false).unwrap_err();
    assert!(matches!(error, GuardError::Unresolved { .. }), "{error}");
    assert_eq!(detector.unresolved(), Some(Guard::Reaction(RUBBING)));
    let bridged = detector.examine(&scene.view(&dense).across(), false).unwrap();
    let is_at_half = |first: Option<(f64, Vec<Guard>)>| {
        first.is_some_and(|(at, guards)| (at - 0.5).abs() < 1e-9 && guards == [Guard::Reaction(RUBBING)])
    };
    assert!(is_at_half(bridged.first) && detector.unresolved() == Some(Guard::Reaction(RUBBING)));
    // Not for good.
    assert!(detector.examine(&scene.view(&dense), false).is_err());
    detector.expect_noise();
    assert!(is_at_half(detector.examine(&scene.view(&dense), false).unwrap().first));
    assert_eq!(detector.unresolved(), None);
    assert!(detector.examine(&scene.view(&first), false).unwrap().first.is_none());
}
