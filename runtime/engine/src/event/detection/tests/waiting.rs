//! Conditions on a coordinate z(t) that is a given function, by their values.

use super::given::*;

const STEPS: [&[f64]; 3] = [&[1.0], &[0.41, 1.0], &[0.15, 0.35, 0.55, 0.65, 0.9, 1.0]];

fn is_met(z: fn(f64) -> f64, text: &str, at: Option<f64>) {
    let scene = from_function(z);
    for steps in STEPS {
        for is_state in [false, true] {
            let found = met(&scene, text, is_state, steps);
            let near = match (found, at) {
                (Some(found), Some(at)) => (found - at).abs() < 1e-10,
                (found, at) => found == at,
            };
            assert!(near, "`{text}` {steps:?} {is_state}: {found:?} for {at:?}");
        }
    }
}

/// 2 + sin falls through 2.5 at π/6 from the crest on, and rises through it before.
#[test]
fn a_condition_is_met_where_it_becomes_true() {
    let wave = |t: f64| 2.0 + (6.0 * t).sin();
    let (up, down) = (core::f64::consts::PI / 36.0, 5.0 * core::f64::consts::PI / 36.0);
    is_met(wave, "z > 2.5", Some(up));
    is_met(wave, "2.5 < z", Some(up));
    is_met(wave, "z = 2.5", Some(up));
    is_met(wave, "z < 2.5", Some(down));
    is_met(wave, "z < 1.5", Some(7.0 * core::f64::consts::PI / 36.0));
    is_met(wave, "z > 3.5", None);
    is_met(wave, "z < 0.5", None);
    is_met(wave, "z = 3.5", None);
}

/// What holds at the start is met once it has ceased and comes to hold again.
#[test]
fn a_condition_that_holds_at_the_start_is_met_later() {
    let wave = |t: f64| (9.0 * t).cos() - 0.5;
    let [ceases, again] = [1.0, 5.0].map(|thirds| thirds * core::f64::consts::PI / 27.0);
    is_met(wave, "z > 0", Some(again));
    is_met(wave, "z < 0", Some(ceases));
    is_met(wave, "z = 0", Some(ceases));
}

/// What starts at equality is met at the next one; a comparison by leaving it.
#[test]
fn a_condition_that_starts_at_zero_is_met_at_the_next_zero() {
    let away = |t: f64| (6.0 * t).sin();
    let next = core::f64::consts::PI / 6.0;
    is_met(away, "z = 0", Some(next));
    is_met(away, "z < 0", Some(next));
    is_met(away, "z < -0.5", Some(7.0 * core::f64::consts::PI / 36.0));
}

/// A sign that changes through a pole is no equality; what arms or disarms holds or not on either
/// side of it.
#[test]
fn a_pole_is_passed() {
    let z = |t: f64| t - 0.6;
    let scene = from_function(z);
    for steps in STEPS {
        assert_eq!(met(&scene, "1 / z = 0", false, steps), None, "{steps:?}");
        assert_eq!(met(&scene, "1 / z > 0", false, steps), None, "{steps:?}");
        let armed = met(&scene, "1 / z > 0", true, steps);
        assert!(armed.is_some_and(|at| at > 0.6 && at < 0.6 + 1e-9), "{steps:?} {armed:?}");
        assert_eq!(met(&scene, "1 / z < 0", true, steps), None, "{steps:?}");
    }
}

/// It touches zero before it falls below, and from below before it rises and falls again, in one
/// step or in several.
#[test]
fn a_comparison_is_met_behind_a_touch() {
    let near = |found: Option<f64>, at: f64| found.is_some_and(|found| (found - at).abs() < 1e-10);
    let (above, below) = (
        from_function(|t| (t - 0.3).powi(2) * (0.8 - t)),
        from_function(|t| -(t - 0.3).powi(2) * (t - 0.58) * (t - 0.8) * (2.0 + t.sin())),
    );
    for steps in STEPS {
        assert!(near(met(&above, "z < 0", false, steps), 0.8), "{steps:?}");
        assert!(near(met(&above, "0 > z", false, steps), 0.8), "{steps:?}");
        assert!(near(met(&below, "z < 0", false, steps), 0.8), "{steps:?}");
    }
}

/// Touches of an equality are met, of a comparison are none.
#[test]
fn a_condition_that_touches() {
    let z = |t: f64| (t - 0.5) * (t - 0.5) * (2.0 + t.sin());
    let scene = from_function(z);
    for steps in STEPS {
        let found = met(&scene, "z = 0", false, steps);
        assert!(found.is_some_and(|at| (at - 0.5).abs() < 1e-5), "{steps:?} {found:?}");
        assert_eq!(met(&scene, "z < 0", false, steps), None);
        assert_eq!(met(&scene, "z > 0", false, steps), None);
    }
}

/// Between two steps it has come to zero from the side where it is false, and is beyond by less
/// than its bound.
#[test]
fn a_comparison_is_met_at_the_seam_of_two_steps() {
    for beyond in [1e-13, 0.0, -1e-13] {
        for (sign, text) in [(1.0, "z > 0"), (-1.0, "z < 0")] {
            let scene = from_function(move |t| sign * (t - 0.41 + beyond));
            let found = met(&scene, text, false, &[0.2, 0.41, 1.0]);
            assert!(found.is_some_and(|at| (at - 0.41).abs() < 1e-9), "{text} {beyond} {found:?}");
        }
    }
}
