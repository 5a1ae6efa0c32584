//! Functions that change much faster than the step: spikes, poles, sines of many turns.

use core::f64::consts::PI;

use super::super::{Crossing, GuardError, RootStart, watch};
use super::crossing;
use super::first_root;
use super::known::Random;

/// 1/(1 + ((θ − p)/w)²) − ½ is zero at p ± w.
#[test]
fn spikes() {
    let mut random = Random(1);
    for _ in 0..2000 {
        let width = 10f64.powf(random.within(-4.0, -1.0));
        let p = random.within(width, 1.0 - width);
        let spike = |theta: f64| 1.0 / (1.0 + ((theta - p) / width).powi(2)) - 0.5;
        // Slope ½/w, rounding 1e-16.
        let near = |theta: f64, root: f64| (theta - root).abs() < 1e-15;
        let rise = first_root(spike, RootStart::Free, 1e-12).expect("finite");
        let rise = rise.unwrap_or_else(|| panic!("no root: {p} {width}"));
        assert!(near(rise, p - width), "{p} {width} {rise}");
        let dip = crossing(watch(|theta| -spike(theta), RootStart::Free, 1e-12)).expect("a crossing");
        assert!(near(dip, p - width), "{p} {width} {dip}");
    }
}

/// tan ω(θ − p) = 100 before every pole, which itself is no root.
#[test]
fn roots_beside_poles() {
    let mut random = Random(2);
    for _ in 0..2000 {
        let (omega, p) = (random.within(0.5, 9.0), random.within(-0.2, 0.9));
        let g = |theta: f64| (omega * (theta - p)).tan() - 100.0;
        let turns = ((-omega * p - 100f64.atan()) / PI).ceil();
        let expected = p + (100f64.atan() + turns * PI) / omega;
        let found = first_root(g, RootStart::Free, 1e-10).expect("finite");
        match found {
            // Slope 1e4 ω, rounding of the argument 1e-15.
            Some(found) => assert!((found - expected).abs() < 1e-14, "{omega} {p} {found} {expected}"),
            None => assert!(expected > 1.0, "{omega} {p} {expected}"),
        }
    }
}

/// Less than 20 turns are followed to the first time above 0.99999; of more it is said that they
/// are not.
#[test]
fn sines_of_many_turns() {
    let first = |omega: f64| watch(|theta| 0.99999 - (omega * theta).sin(), RootStart::Free, 1e-12);
    for omega in [10.0, 60.0, 100.0, 300.0, 400.0] {
        let theta = crossing(first(omega)).expect("a crossing");
        // Slope 4.5e-3 ω, rounding 1e-16.
        assert!((theta - f64::asin(0.99999) / omega).abs() < 1e-13 / omega, "{omega} {theta}");
    }
    for omega in [3e3, 1e4, 1e6] {
        assert!(matches!(first(omega), Err(GuardError::Unresolved { .. })), "{omega}");
    }
    // A bound clears the wave far from zero, but only once its turns are resolved.
    assert_eq!(watch(|theta| 3.0 + (100.0 * theta).sin(), RootStart::Free, 1e-12), Ok(Crossing::Clear));
}
