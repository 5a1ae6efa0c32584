//! Gaps of corners beyond the ends of their bars, and of drives, which come from either side.

use super::super::{ContactStatus, Guard};
use super::given::*;
use crate::model::ContactSet;

/// The gap of a corner and the lesser distance of its foot from the ends of its bar.
fn corner(gap: fn(f64) -> f64, foot: fn(f64) -> f64, end: usize) -> Scene {
    Scene::closed(ContactSet::EMPTY, move |t| {
        let mut shown = Shown { gaps: [1.0; CONTACTS], ..Shown::default() };
        shown.gaps[CORNER] = gap(t);
        shown.feet = [1.0; 2];
        shown.feet[end] = foot(t);
        shown
    })
}

fn alone(contact: usize) -> ContactStatus<'static> {
    let removed = (0..CONTACTS).filter(|other| *other != contact).collect();
    ContactStatus { removed, ..roles(ContactSet::EMPTY) }
}

const STEPS: [&[f64]; 3] = [&[1.0], &[0.45, 1.0], &[0.2, 0.4, 0.6, 0.8, 1.0]];

fn closes(scene: &Scene, roles: ContactStatus<'_>) -> Option<f64> {
    let [first, rest @ ..] = STEPS.map(|steps| scene.first(roles, steps));
    for other in rest {
        match (first, other) {
            (Some(first), Some(other)) => assert!((first - other).abs() < 1e-11, "{first} {other}"),
            _ => assert_eq!(first, other),
        }
    }
    first
}

/// Above its bar up to 0.3 and from 0.7 to 0.9.
fn gap(t: f64) -> f64 {
    (t - 0.3) * (t - 0.7) * (0.9 - t)
}

#[test]
fn a_corner_closes_under_its_bar_only() {
    for end in [0, 1] {
        let near = |found: Option<f64>, at: f64| found.is_some_and(|found| (found - at).abs() < 1e-11);
        assert!(near(closes(&corner(gap, |_| 1.0, end), alone(CORNER)), 0.3));
        // It has gone below beside the bar, and does not close as it comes under it from there.
        assert!(near(closes(&corner(gap, |t| t - 0.5, end), alone(CORNER)), 0.9));
        assert!(near(closes(&corner(gap, |t| 0.95 - t, end), alone(CORNER)), 0.3));
        assert_eq!(closes(&corner(gap, |t| t - 0.95, end), alone(CORNER)), None);
        // Up to its bound beyond the end.
        let bound = |_| -BOUNDS.relative * BOUNDS.length;
        assert!(near(closes(&corner(gap, bound, end), alone(CORNER)), 0.3));
        assert_eq!(closes(&corner(gap, |_| -2.1e-6, end), alone(CORNER)), None);
    }
}

/// Below its bar from the start, as is said, it closes only after it has come back.
#[test]
fn a_corner_that_has_passed_its_bar_comes_back_first() {
    let below = |t: f64| (t - 0.35) * (0.85 - t);
    let status = ContactStatus { below: set(&[CORNER]), ..alone(CORNER) };
    let found = closes(&corner(below, |_| 1.0, 0), status);
    assert!(found.is_some_and(|at| (at - 0.85).abs() < 1e-11), "{found:?}");
    assert_eq!(corner(below, |_| 1.0, 0).first(alone(CORNER), &[1.0]), Some(0.0));
}

/// A corner that is off and begins a step within its bound has not come there from below: it closes
/// as it falls.
#[test]
fn a_corner_within_its_bound_is_not_below_its_bar() {
    let bound = BOUNDS.relative * BOUNDS.length;
    for part in [0.5, -0.5] {
        let scene = Scene::closed(ContactSet::EMPTY, move |t| {
            let mut shown = Shown { gaps: [1.0; CONTACTS], feet: [1.0; 2], ..Shown::default() };
            shown.gaps[CORNER] = 0.5 - t + part * bound;
            shown
        });
        let at = scene.first(ContactStatus { below: set(&[CORNER]), ..alone(CORNER) }, &[0.5, 1.0]);
        // What is below zero as the step begins has closed at once.
        let expected = 0.5 + part.max(0.0) * bound;
        assert!(at.is_some_and(|at| (at - expected).abs() < 1e-12), "{part} {at:?}");
    }
}

/// Which corners are below their bars at the end of a step, having come there from beyond the ends.
#[test]
fn corners_below_their_bars_are_reported() {
    for (foot, ends) in [
        ((|t| t - 0.5) as fn(f64) -> f64, [(0.2, false), (0.4, true), (0.6, true), (0.8, false)]),
        (|t| t - 0.25, [(0.2, false), (0.25, false), (0.28, false), (0.29, false)]),
    ] {
        let scene = corner(gap, foot, 1);
        let mut detector = scene.begun(alone(CORNER), (&[], false));
        let mut from = 0.0;
        for (to, passed) in ends {
            let dense = scene.dense([from, to]);
            assert!(detector.examine(&scene.view(&dense), false).unwrap().first.is_none(), "{to}");
            assert_eq!(detector.below(), if passed { set(&[CORNER]) } else { ContactSet::EMPTY }, "{to}");
            from = to;
        }
    }
}

/// A gap of a drive counts from below, too.
#[test]
fn a_drive_takes_hold_from_either_side() {
    for sign in [1.0, -1.0] {
        for contact in [DRIVE, TURN, PLAIN] {
            let scene = Scene::closed(ContactSet::EMPTY, move |t| {
                let mut shown = Shown::default();
                shown.gaps[contact] = sign * (0.6 - t) * (2.0 + t.sin());
                shown
            });
            match closes(&scene, alone(contact)) {
                Some(at) if contact != PLAIN || sign > 0.0 => assert!((at - 0.6).abs() < 1e-12, "{at}"),
                // What begins below zero has closed at once.
                found => assert_eq!((found, contact), (Some(0.0), PLAIN)),
            }
            assert_eq!(scene.first(alone(contact), &[0.1, 0.5]).is_some(), contact == PLAIN && sign < 0.0);
        }
    }
    // It leaves its root, and comes back.
    let scene = Scene::closed(ContactSet::EMPTY, |t| {
        let mut shown = Shown::default();
        shown.gaps[DRIVE] = t * (t - 0.7);
        shown
    });
    let found = closes(&scene, alone(DRIVE));
    assert!(found.is_some_and(|at| (at - 0.7).abs() < 1e-12), "{found:?}");
    assert_eq!(Guard::Gap(DRIVE).gap(), Some(DRIVE));
}

/// A corner that has gone below beyond the end of its bar and has come back closes as any other; so
/// does one that begins below.
#[test]
fn returning_corners_have_not_passed() {
    for k in 0..40 {
        let falls = 0.72 + 0.005 * f64::from(k);
        let scene = Scene::closed(ContactSet::EMPTY, move |t| {
            let mut shown = Shown { gaps: [1.0; CONTACTS], feet: [1.0, t - 0.5], ..Shown::default() };
            shown.gaps[CORNER] = (t - 0.2) * (t - 0.3) * (falls - t);
            shown
        });
        let mut detector = scene.begun(alone(CORNER), (&[], false));
        let (first, _) = scene.follow(&mut detector, &[0.5, 1.0]).unwrap();
        assert!(first.is_some_and(|(at, _)| (at - falls).abs() < 1e-11), "{falls}");
        assert_eq!(detector.below(), ContactSet::EMPTY, "{falls}");
    }
    let scene = corner(|t| -1.0 - t, |_| 1.0, 0);
    for below in [ContactSet::EMPTY, set(&[CORNER])] {
        let mut detector = scene.begun(ContactStatus { below, ..alone(CORNER) }, (&[], false));
        scene.follow(&mut detector, &[1.0]).unwrap();
        assert_eq!(detector.below(), below);
    }
}
