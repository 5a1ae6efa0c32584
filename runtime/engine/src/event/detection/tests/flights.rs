//! Low flights: gaps that are lost in rounding, and heights that are known.

use super::super::{ContactStatus, LOW};
use super::given::*;
use crate::model::ContactSet;

fn alone(contact: usize) -> ContactStatus<'static> {
    let removed = (0..CONTACTS).filter(|other| *other != contact).collect();
    ContactStatus { removed, ..roles(ContactSet::EMPTY) }
}

/// g = k t³ (τ − t) with the curvature of k t³ (ρ − t).
fn lifted(k: f64, tau: f64, rho: f64, noise: f64) -> Scene {
    Scene::closed(ContactSet::EMPTY, move |t| {
        let mut shown = Shown::default();
        let hash = t.to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11;
        let rounding = noise * (hash as f64 / (1u64 << 52) as f64 - 1.0);
        shown.gaps[PLAIN] = k * t.powi(3) * (tau - t) + rounding;
        shown.curvatures[PLAIN] = k * (6.0 * rho * t - 12.0 * t * t);
        shown
    })
}

const STEPS: [&[f64]; 3] = [&[1.0], &[0.3, 1.0], &[0.1, 0.3, 0.5, 0.7, 1.0]];

/// Whatever rounding makes of the gap: it lands where its acceleration says.
#[test]
fn a_low_flight_lands_where_its_acceleration_says() {
    let roles = ContactStatus { orders: &[(PLAIN, 3)], ..alone(PLAIN) };
    for k in [1e-12, 1e-10, 1e-9] {
        for tau in [0.6, 0.75, 0.9] {
            let scene = lifted(k, tau, tau, 4e-16);
            for steps in STEPS {
                let at = scene.first(roles, steps);
                assert!(at.is_some_and(|at| (at - tau).abs() < 1e-9), "{k} {tau} {steps:?} {at:?}");
            }
        }
    }
}

/// k t³ (τ − t) (1 − t) with τ = 0.9 bends up again from 0.805 on, and lands as it still falls.
#[test]
fn a_flight_that_slows_down_lands_as_well() {
    let tau = 0.9;
    let scene = Scene::closed(ContactSet::EMPTY, move |t| {
        let mut shown = Shown::default();
        shown.gaps[PLAIN] = 1e-10 * t.powi(3) * (tau - t) * (1.0 - t);
        shown.curvatures[PLAIN] = 1e-10 * (6.0 * tau * t - 12.0 * (1.0 + tau) * t.powi(2) + 20.0 * t.powi(3));
        shown
    });
    let roles = ContactStatus { orders: &[(PLAIN, 3)], ..alone(PLAIN) };
    for steps in [&[1.0][..], &[0.3, 0.6, 1.0], &[0.3, 0.6, 0.82, 1.0], &[0.3, 0.6, 0.82, 0.89, 1.0]] {
        let at = scene.first(roles, steps);
        assert!(at.is_some_and(|at| (at - tau).abs() < 1e-9), "{steps:?} {at:?}");
    }
    // Before it lands nothing does.
    assert_eq!(scene.first(roles, &[0.3, 0.6, 0.82, 0.89]), None);
}

/// A high one is seen by its gap; so is one that has closed before.
#[test]
fn a_high_flight_lands_where_its_gap_says() {
    let roles = ContactStatus { orders: &[(PLAIN, 3)], ..alone(PLAIN) };
    for (k, rho) in [(1.0, 0.78), (1.0, 0.82), (1.0, 0.5), (1e-3, 0.95)] {
        let at = lifted(k, 0.8, rho, 0.0).first(roles, &[1.0]);
        assert!(at.is_some_and(|at| (at - 0.8).abs() < 1e-9), "{k} {rho} {at:?}");
    }
    // Of another order nothing but the gap is followed.
    let other = ContactStatus { orders: &[(PLAIN, 2)], ..alone(PLAIN) };
    let at = lifted(1e-4, 0.8, 0.6, 0.0).first(other, &[1.0]);
    assert!(at.is_some_and(|at| (at - 0.8).abs() < 1e-9), "{at:?}");
}

/// A flight of known height is followed to a 64th of it, and its end to rounding.
#[test]
fn a_flight_of_known_height_is_seen_below_the_usual_bound() {
    for height in [1e-7, 1e-9] {
        let scene = Scene::closed(ContactSet::EMPTY, move |t| {
            let mut shown = Shown::default();
            shown.gaps[PLAIN] = 4.0 * height * t * (0.75 - t) / (0.75 * 0.75);
            shown
        });
        let heights = [(PLAIN, height)];
        for steps in STEPS {
            let at = scene.first(ContactStatus { heights: &heights, ..alone(PLAIN) }, steps);
            assert!(at.is_some_and(|at| (at - 0.75).abs() < 1e-7), "{height} {steps:?} {at:?}");
            assert_eq!(scene.first(alone(PLAIN), &steps[..steps.len() - 1]), None);
        }
    }
}

/// One that begins below its ground by more than that has its bound there.
#[test]
fn a_flight_that_begins_deep_has_its_ground_there() {
    for depth in [1e-9, 1e-8] {
        let scene = Scene::closed(ContactSet::EMPTY, move |t| {
            let mut shown = Shown::default();
            shown.gaps[PLAIN] = -depth + t;
            shown
        });
        let heights = [(PLAIN, 1e-9)];
        let detector = scene.begun(ContactStatus { heights: &heights, ..alone(PLAIN) }, (&[], false));
        let watch = &detector.list[0];
        assert_eq!(watch.tracking.height, 2.0 * depth / LOW);
        assert!(watch.tracking.at_root);
    }
}

/// A part of the natural length, which is two here.
#[test]
fn heights_within_the_gap_bound_are_low() {
    let scene = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
    let detector = scene.begun(alone(PLAIN), (&[], false));
    let (most, is_low) = (BOUNDS.relative * BOUNDS.length, |gap| detector.scales.is_low(0, gap));
    assert!(is_low(most) && is_low(0.0) && !is_low(1.001 * most));
}

/// Of several the lowest; none where something else is zero at the start, or nothing is.
#[test]
fn the_lowest_flight_that_a_phase_begins_with() {
    let lowest = |gaps: [f64; 2], heights: &[(usize, f64)]| {
        let scene = Scene::closed(ContactSet::EMPTY, move |_| {
            let mut shown = Shown { gaps: [1.0; CONTACTS], ..Shown::default() };
            [shown.gaps[PLAIN], shown.gaps[THREAD]] = gaps;
            shown
        });
        scene.begun(ContactStatus { heights, ..roles(ContactSet::EMPTY) }, (&[], false)).lowest_flight()
    };
    let both = [(PLAIN, 1e-3), (THREAD, 1e-5)];
    assert_eq!(lowest([0.0, 0.0], &both), 1e-5);
    assert_eq!(lowest([0.0, 1.0], &both), 1e-3);
    assert_eq!(lowest([0.0, 0.0], &both[..1]), 0.0);
    assert_eq!(lowest([1.0, 1.0], &both), 0.0);
}
