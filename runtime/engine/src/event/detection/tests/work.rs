//! The work of friction over a step from the series of its forces and slips.

use super::super::EventDetector;
use super::super::guard_source::EXACT;
use super::given::*;
use crate::integrate::Guards;
use crate::model::{ContactSet, Slip};
use crate::series::ORDERS;
use crate::system::DenseOutput;

/// Terms of a series whose rest sums to 0.002/0.9 by the last four.
const TERMS: [f64; 5] = [1.0, 0.1, 0.1, 0.01, 0.01];
const REST: f64 = 0.002 / 0.9;

fn series(terms: [f64; 5], size: f64) -> [f64; ORDERS] {
    let mut series = [0.0; ORDERS];
    series.iter_mut().zip(terms).for_each(|(c, term)| *c = size * term);
    series
}

/// v° of the surface that the contact rubs on.
const SURFACE: f64 = 0.75;

/// A contact that is closed with a slip, on that surface.
fn rubbing(slip: Slip) -> (ContactSet, Scene) {
    let closed = ContactSet::EMPTY.slipping(RUBBING, slip);
    let scene = Scene::closed(closed, |_| {
        let mut shown = Shown::default();
        shown.slips[0] = [SURFACE, 0.25];
        shown
    });
    (closed, scene)
}

/// The work over half a second up to `end`, of these series.
fn work((closed, scene): &(ContactSet, Scene), [force, slip]: [[f64; ORDERS]; 2], end: f64) -> Option<f64> {
    let still = DenseOutput::still(0.0, &[0.0]);
    let mut detector =
        EventDetector::new(scene.context.layout(), *closed, roles(*closed), (&[], &[]), BOUNDS);
    detector.begin(&scene.view(&still));
    let (mut reactions, mut gaps) =
        ([[0.0; ORDERS]; CONTACTS + FRICTIONS], [[0.0; ORDERS]; CONTACTS + FRICTIONS]);
    (reactions[CONTACTS], gaps[CONTACTS]) = (force, slip);
    let guards = Guards::new(TERMS.len(), &reactions, &gaps, &[[0.0; ORDERS]; 2]);
    detector.friction_work(&scene.view(&scene.dense([1.0, 1.5])).with_series(Some(guards)), end)
}

/// ∫ R (v − v°) dt where both are known to a tenth of what counts as zero of them, nothing where
/// one is not.
#[test]
fn the_work_is_reported_where_series_are_exact() {
    let scene = rubbing(Slip::Forward);
    let most = [FORCES[RUBBING], SLIPS[0]].map(|unit| EXACT * BOUNDS.relative * unit / REST);
    for (parts, is_told) in [([0.99, 0.99], true), ([1.01, 0.99], false), ([0.99, 1.01], false)] {
        let [force, slip] = [0, 1].map(|k| parts[k] * most[k]);
        for end in [0.5, 1.0_f64] {
            let found = work(&scene, [series(TERMS, force), series(TERMS, slip)], end);
            assert_eq!(found.is_some(), is_told, "{parts:?}");
            // By Simpson's rule on 64 parts.
            let at = |theta: f64| TERMS.iter().rev().fold(0.0, |sum, c| sum * theta + c);
            let power = |theta: f64| force * at(theta) * (slip * at(theta) - SURFACE);
            let weight = |k: u32| if k == 0 || k == 64 { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
            let sum: f64 = (0..=64).map(|k| weight(k) * power(end * f64::from(k) / 64.0)).sum();
            let expected = 0.5 * sum * end / (3.0 * 64.0);
            assert!(found.is_none_or(|work| (work / expected - 1.0).abs() < 1e-7), "{found:?} {expected}");
        }
    }
}

/// A contact that does not slip, but for what counts as zero, does no work, however roughly its
/// force is known.
#[test]
fn without_slip_the_force_need_not_be_exact() {
    let scene = rubbing(Slip::Stick);
    let (most, zero) = (EXACT * FORCES[RUBBING] / REST, BOUNDS.relative * SLIPS[0]);
    for (force, slip, is_told) in
        [(0.99, 0.99, true), (0.99, -0.99, true), (0.99, 1.01, false), (1.01, 0.0, false)]
    {
        let slip_velocity = series([SURFACE + slip * zero, 0.0, 0.0, 0.0, 0.0], 1.0);
        let found = work(&scene, [series(TERMS, force * most), slip_velocity], 1.0);
        assert_eq!(found.is_some(), is_told, "{force} {slip}");
        assert!(found.is_none_or(|work| work.abs() <= 0.5 * 1.2 * most * zero), "{found:?}");
    }
}
