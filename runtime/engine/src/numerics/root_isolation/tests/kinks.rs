//! Functions that no polynomial fits over all of the step.

use super::super::polynomial::{FINE, node};
use super::super::{Accuracy, GuardError, RootStart, watch};
use super::first_root;
use super::{ULPS, crossing};

/// Eight kinks are followed, each in a 32nd of the step, and what comes behind them is seen; nine
/// are too many.
#[test]
fn some_kinks_are_followed() {
    for (count, first) in [(8_u32, 0), (8, 4), (9, 0), (9, 5)] {
        let places: Vec<f64> = (first..first + count).map(|k| (f64::from(k) + 0.4) / 32.0).collect();
        let kinked = |theta: f64| {
            2.0 * (0.9 - theta) - 0.01 * places.iter().map(|p| (p - theta).max(0.0)).sum::<f64>()
        };
        let found = watch(kinked, RootStart::Free, 1e-12);
        match count {
            8 => assert!(crossing(found).is_some_and(|at| (at - 0.9).abs() < ULPS), "{first} {found:?}"),
            _ => assert!(matches!(found, Err(GuardError::Unresolved { .. })), "{first} {found:?}"),
        }
        let noisy = Accuracy { delta: 1e-12, is_noisy: true };
        let found = crossing(watch(kinked, RootStart::Free, noisy));
        assert!(found.is_some_and(|at| (at - 0.9).abs() < ULPS), "{count} {first} {found:?}");
    }
}

/// Rounded to 2⁻²⁰, a kink between two of the last places of a piece is as far from both, and is
/// seen.
#[test]
fn a_kink_between_places_of_the_same_value_is_seen() {
    let unit = f64::powi(2.0, 20);
    for piece in [0.0, 10.0, 31.0] {
        for j in [3, 15, 16, 28] {
            let [before, after] = [j, j + 1].map(|j| (piece + node(j, FINE)) / 32.0);
            let p = 0.5 * (before + after);
            for sign in [1.0, -1.0] {
                let kink = |theta: f64| sign * (unit * (theta - p).abs()).round() / unit;
                assert_eq!(kink(before), kink(after));
                let accuracy = Accuracy { delta: 1e-9, is_noisy: true };
                let root = first_root(kink, RootStart::Free, accuracy).expect("followed").expect("a root");
                assert!((root - p).abs() <= 0.5 / unit, "{p} {root}");
            }
        }
    }
}
