//! Guards by the series of the method, against closed forms.

use super::super::{ContactStatus, Guard};
use super::given::*;
use crate::integrate::Guards;
use crate::model::ContactSet;
use crate::series::ORDERS;

/// The first event of one guard by its series, Σ cₖ tᵏ over the step from 0 to 1.
fn first(guard: Guard, c: &[f64], status: ContactStatus<'_>, is_fitted: bool) -> Option<f64> {
    let terms = padded(c);
    let (mut reactions, mut gaps) =
        ([[0.0; ORDERS]; CONTACTS + FRICTIONS], [padded(&[9.0]); CONTACTS + FRICTIONS]);
    match guard {
        Guard::Reaction(contact) => reactions[contact] = terms,
        Guard::Gap(contact) => gaps[contact] = terms,
        _ => unreachable!("a reaction or a gap"),
    }
    let closed = status.closed;
    let start = c[0];
    let scene = Scene::closed(closed, move |_| {
        let mut shown = Shown { gaps: [9.0; CONTACTS], ..Shown::default() };
        match guard {
            Guard::Reaction(contact) => shown.reactions[contact] = start,
            Guard::Gap(contact) => shown.gaps[contact] = start,
            _ => (),
        }
        shown
    });
    let mut detector = scene.begun(status, (&[], false));
    let dense = scene.dense([0.0, 1.0]);
    let guards = Guards::new(c.len() + 4, &reactions, &gaps, &[[1.0; ORDERS]; 2]);
    let view = scene.view(&dense).with_series(Some(guards)).with_fitted(is_fitted);
    detector.examine(&view, false).expect("followed").first.map(|(theta, guards)| {
        assert_eq!(guards, [guard]);
        theta
    })
}

fn alone(contact: usize) -> ContactStatus<'static> {
    let removed = (0..CONTACTS).filter(|other| *other != contact).collect();
    ContactStatus { removed, ..roles(ContactSet::EMPTY) }
}

/// (t − a)(t − b) with a sign.
#[test]
fn guards_by_series_fall_where_their_polynomials_do() {
    let closed = ContactStatus { removed: ContactSet::EMPTY, ..roles(set(&[PLAIN])) };
    for (a, b) in [(0.3, 0.8), (0.25, 0.26), (0.5, 1.5)] {
        let up = [a * b, -a - b, 1.0];
        let down = up.map(|c| -c);
        for (c, at) in [(up, Some(a)), (down, Some(0.0))] {
            for (guard, status) in [(Guard::Reaction(PLAIN), closed), (Guard::Gap(PLAIN), alone(PLAIN))] {
                let found = first(guard, &c, status, false);
                let near = found.zip(at).is_some_and(|(found, at)| (found - at).abs() < 1e-14);
                assert!(near, "{guard:?} {c:?}: {found:?}");
            }
        }
        for contact in [DRIVE, TURN] {
            for c in [up, down] {
                let found = first(Guard::Gap(contact), &c, alone(contact), false);
                assert!(found.is_some_and(|at| (at - a).abs() < 1e-14), "{contact} {c:?} {found:?}");
            }
        }
    }
    for guard in [Guard::Gap(PLAIN), Guard::Gap(DRIVE)] {
        assert_eq!(first(guard, &[1.0, -1.0, 0.5], alone(guard.contact().unwrap()), false), None);
    }
}

/// tᵐ (b − t) whose terms below the order are noise within the bound: the order says that they are
/// nothing, but not of series that are fitted.
#[test]
fn a_known_order_leaves_out_what_is_below_it() {
    for order in [1, 2, 3] {
        let orders = [(PLAIN, order)];
        let status = ContactStatus { orders: &orders, ..alone(PLAIN) };
        for (noise, b) in [(1e-9, 0.7), (-1e-9, 0.4)] {
            let mut c = vec![noise; order];
            c.extend([b, -1.0]);
            let found = first(Guard::Gap(PLAIN), &c, status, false);
            assert!(found.is_some_and(|at| (at - b).abs() < 1e-15), "{order} {b} {found:?}");
            // By the first order of the noise, whose sum is Σ bᵏ, over the slope −bᵐ.
            let moved = noise * (0..order).map(|k| b.powi(k as i32)).sum::<f64>() / b.powi(order as i32);
            let fitted = first(Guard::Gap(PLAIN), &c, status, true).expect("a root");
            assert!((fitted - b - moved).abs() < 1e-3 * moved.abs(), "{order} {b} {fitted}");
            let down: Vec<f64> = c.iter().map(|c| -c).collect();
            // It closes as soon as that is seen: where it leaves its bound.
            let at = first(Guard::Gap(PLAIN), &down, status, false).expect("it closes");
            let gap = down.iter().rev().fold(0.0, |sum, c| sum * at + c);
            assert!((gap + BOUNDS.relative * BOUNDS.length).abs() < 1e-14, "{order} {at} {gap}");
        }
    }
}
