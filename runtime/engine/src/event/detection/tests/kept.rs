//! Reactions, friction forces and slips that begin at zero, and have been decided to go on as they
//! are.

use super::super::guard_source::Suppression;
use super::super::{ContactStatus, Guard};
use super::given::*;
use crate::contact::friction::SharedFriction;
use crate::model::{ContactSet, Form, Slip};

const BOUND: f64 = BOUNDS.relative * FORCES[PLAIN];

fn of_reaction(g: impl Fn(f64) -> f64 + Copy + Send + Sync + 'static) -> Scene {
    Scene::closed(set(&[PLAIN]), move |t| {
        let mut shown = Shown::default();
        shown.reactions[PLAIN] = g(t);
        shown
    })
}

/// When a reaction of so many bounds vanishes, kept or not.
fn vanishes(g: impl Fn(f64) -> f64 + Copy + Send + Sync + 'static, kept: bool) -> Option<f64> {
    let scene = of_reaction(move |t| BOUND * g(t));
    let kept = if kept { set(&[PLAIN]) } else { ContactSet::EMPTY };
    scene.first(ContactStatus { suppressed: kept, ..roles(set(&[PLAIN])) }, &[1.0])
}

#[test]
fn a_kept_reaction_vanishes_where_it_leaves_its_bound() {
    assert_eq!(vanishes(|t| -8.0 * t, false), Some(0.0));
    let at = vanishes(|t| -8.0 * t, true).unwrap();
    assert!((at - 0.125).abs() < 1e-12, "{at}");
    let at = vanishes(|t| -0.4 - 8.0 * t, true).unwrap();
    assert!((at - 0.075).abs() < 1e-12, "{at}");
    let at = vanishes(|t| -0.5 - 8.0 * t, true).unwrap();
    assert!((at - 0.0625).abs() < 1e-12, "{at}");
    // What is so far below is not kept.
    assert_eq!(vanishes(|t| -0.6 - 8.0 * t, true), Some(0.0));
    // A turning point above −bound does not count.
    let at = vanishes(|t| -0.4 * (6.0 * t).sin() - 40.0 * t.powi(8), true).unwrap();
    let value = -0.4 * (6.0 * at).sin() - 40.0 * at.powi(8);
    assert!((value + 1.0).abs() < 1e-9 && at > 0.5, "{at}");
}

/// Down to 1.5 bounds and back within one step: it leaves its bound where sin πt = 2/3.
#[test]
fn a_kept_reaction_that_dips_has_vanished() {
    let at = vanishes(|t| -1.5 * (core::f64::consts::PI * t).sin(), true).unwrap();
    assert!((at - f64::asin(2.0 / 3.0) / core::f64::consts::PI).abs() < 1e-9, "{at}");
}

/// It is at zero until it has left its bound; from there on a zero is one.
#[test]
fn a_reaction_that_has_left_its_bound_vanishes_at_zero() {
    for kept in [false, true] {
        let at = vanishes(|t| 100.0 * t * (0.75 - t), kept).unwrap();
        assert!((at - 0.75).abs() < 1e-9, "{kept} {at}");
        assert_eq!(vanishes(|t| 100.0 * t, kept), None);
        assert_eq!(vanishes(|t| 0.9 * (9.0 * t).sin(), kept), None);
    }
}

/// A force that begins within its bound of its limit reaches it at zero, not at −bound.
#[test]
fn a_limit_that_is_not_reached_at_the_start_is_located() {
    let closed = ContactSet::EMPTY.slipping(RUBBING, Slip::Stick);
    let bound = BOUNDS.relative * FORCES[RUBBING];
    for sign in [1.0, -1.0] {
        for (first, expected) in [(0.5, 0.0625), (0.0, 0.125), (-0.25, 0.09375)] {
            // μₛ N − |R| = bound (first − 8 t).
            let scene = Scene::closed(closed, move |t| {
                let mut shown = Shown::default();
                shown.reactions[RUBBING] = 4.0;
                shown.slips[0] = [0.0, 0.25];
                shown.reactions[CONTACTS] = sign * (1.0 - bound * (first - 8.0 * t));
                shown
            });
            let at = scene.first(ContactStatus { suppressed: closed, ..roles(closed) }, &[1.0]).unwrap();
            assert!((at - expected).abs() < 1e-8, "{sign} {first} {at}");
        }
    }
}

/// A slip velocity that begins at zero and reverses, with the opposite sense at once.
#[test]
fn a_slip_vanishes_in_its_sense() {
    for (slip, sign) in [(Slip::Forward, 1.0), (Slip::Backward, -1.0)] {
        let closed = ContactSet::EMPTY.slipping(RUBBING, slip);
        let stops = |v: fn(f64) -> f64| {
            let scene = Scene::closed(closed, move |t| {
                let mut shown = Shown::default();
                shown.reactions[RUBBING] = 1.0;
                shown.slips[0] = [sign * v(t), 0.25];
                shown
            });
            scene.first(roles(closed), &[0.5, 1.0])
        };
        let at = stops(|t| 0.7 - t).unwrap();
        assert!((at - 0.7).abs() < 1e-12, "{at}");
        assert_eq!((stops(|t| -t), stops(|t| t)), (Some(0.0), None));
    }
}

/// Of which contacts and guards it is said.
#[test]
fn suppressed_guards_stay_suppressed() {
    let closed = set(&[PLAIN, CORNER, THREAD]).slipping(RUBBING, Slip::Stick).slipping(GUIDE, Slip::Forward);
    let scene = Scene::new((closed, Form::Reduced), |_| Shown::default());
    let conditions = [scene.condition("z > 1")];
    for kept in [set(&[PLAIN]), set(&[RUBBING]), set(&[GUIDE]), set(&[CORNER, THREAD])] {
        let depends = closed.with(DRIVE);
        let detector =
            scene.begun(ContactStatus { suppressed: kept, ..roles(depends) }, (&conditions, false));
        for watch in &detector.list {
            let name = watch.tracking.guard;
            let (is_kept, suppression) = match name {
                Guard::Reaction(contact) | Guard::Side(contact, _) => {
                    (kept.contains(contact), Suppression::ToBound)
                }
                Guard::Slip(rub) => (kept.contains(rub.contact), Suppression::ToBound),
                Guard::Limit(rub) => (kept.contains(rub.contact), Suppression::ToZero),
                _ => (false, Suppression::None),
            };
            let expected = if is_kept { suppression } else { Suppression::None };
            assert_eq!(watch.tracking.suppression, expected, "{name:?}");
        }
    }
    let depends = Scene::new((ContactSet::EMPTY, Form::Reduced), |_| Shown::default());
    let detector = depends.begun(roles(set(&[PLAIN])), (&[], false));
    assert_eq!(detector.find(Guard::RedundantGap(PLAIN)).tracking.suppression, Suppression::ToBound);
    for (kept, expected) in
        [(set(&[PLAIN]), Suppression::None), (set(&[PLAIN, RUBBING]), Suppression::ToZero)]
    {
        let grip = SharedFriction { sticking: set(&[RUBBING]), normals: ContactSet::EMPTY };
        let detector = scene
            .begun(ContactStatus { suppressed: kept, shared_friction: grip, ..roles(closed) }, (&[], false));
        assert_eq!(detector.find(Guard::SharedFriction).tracking.suppression, expected);
    }
}
