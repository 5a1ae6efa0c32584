//! Conditions that hold from the start but for rounding, that have poles, or that take more
//! evaluations than there is patience for.

use super::given::*;

/// What arms or disarms holds from the start where its sides differ by a millionth of what they
/// differ by at the end, and have their order soon after, too.
#[test]
fn conditions_true_up_to_roundoff_arm_at_the_start() {
    let line = |first: f64| move |t: f64| if t == 1.0 { 1.0 } else { first + t * (1.0 - first) };
    for (sign, holds, other) in [(1.0, "z > 0", "z < 0"), (-1.0, "z < 0", "z > 0")] {
        for (first, arms) in [(1e-9, true), (1e-6, true), (1e-6_f64.next_up(), false), (0.5, false)] {
            let scene = from_function(move |t| sign * line(first)(t));
            assert_eq!(met(&scene, holds, true, &[1.0]), arms.then_some(0.0), "{holds} {first}");
            assert_eq!(met(&scene, holds, false, &[1.0]), None, "{holds} {first}");
            assert_eq!(met(&scene, other, true, &[1.0]), None, "{other} {first}");
            assert_eq!(met(&scene, "z = 0", true, &[1.0]), None, "{first}");
        }
        // It comes to hold a little later, or not before the middle.
        let near = |found: Option<f64>, at: f64| found.is_some_and(|found| (found - at).abs() < 1e-12);
        assert!(near(met(&from_function(move |t| sign * (t - 1e-9)), holds, true, &[1.0]), 1e-9), "{holds}");
        let later = from_function(move |t| sign * (1e-9 + t * (t - 0.5)));
        assert!(near(met(&later, holds, true, &[1.0]), 0.5 - 2e-9), "{holds}");
        // Zero soon after the start is no side.
        let touches = from_function(move |t| sign * if t == 1e-3 { 0.0 } else { 1e-9 + t });
        assert_ne!(met(&touches, holds, true, &[1.0]), Some(0.0), "{holds}");
    }
}

/// What arms by a passage through a pole does so well behind it: by the length of the shortest
/// piece at least.
#[test]
fn a_pole_is_well_passed() {
    for p in [0.1, 1.0 / 3.0, 0.6, 0.987] {
        for steps in [&[1.0][..], &[0.05, 1.0], &[0.05, 0.3, 0.55, 0.9, 1.0]] {
            let end = steps.iter().position(|end| *end > p).expect("a step of the pole");
            let length = steps[end] - if end == 0 { 0.0 } else { steps[end - 1] };
            for (sign, text) in
                [(1.0, "1/z > 0"), (-1.0, "1/z < 0"), (1.0, "3/z^3 > 1e-3"), (-1.0, "z^(-1) < 0")]
            {
                let scene = from_function(move |t| sign * (t - p));
                let at = met(&scene, text, true, steps).expect("it is passed");
                assert!(at - p >= 0.9e-12 * length && at - p < 1e-9 * length, "{p} {text} {steps:?} {at}");
                assert_eq!(met(&scene, text, false, steps), None, "{p} {text}");
            }
        }
    }
}

/// A quantity compared with itself is rounding from end to end.
#[test]
fn identically_zero_conditions_are_undecided() {
    for text in ["abs(z) = z", "abs(t) = t", "abs(z) - z > 0"] {
        let scene = from_function(|t| 0.3 + t);
        let conditions = [scene.condition(text)];
        let mut detector = scene.begun(waits(), (&conditions, false));
        let dense = scene.dense([0.0, 1.0]);
        let found = detector.examine(&scene.view(&dense), false).expect("followed");
        assert!(found.first.is_none() && detector.undecided() == Some(0.0), "{text}");
    }
}

/// The difference of one and one is zero to the rounding of both: 32 ε as one is read, and that of
/// the operations.
#[test]
fn roundoff_of_a_difference_is_zero() {
    for (apart, is_zero) in [(0.0, true), (4e-15, true), (-4e-15, true), (1.5e-14, false), (-1.5e-14, false)]
    {
        let scene = from_function(move |t| 1.0 + apart + t);
        for text in ["z - 1 = 0", "z - 1 > 0", "0 < z - 1"] {
            let conditions = [scene.condition(text)];
            let detector = scene.begun(waits(), (&conditions, false));
            assert_eq!(detector.list[0].tracking.at_root, is_zero, "{text} {apart}");
        }
    }
}

/// Roots of a wave of many turns, the first behind the start by any part of one.
#[test]
fn the_first_of_many_turns_counts() {
    use core::f64::consts::{PI, TAU};
    for k in 0..24 {
        let phase = TAU * (f64::from(k) + 0.37) / 24.0;
        let scene = from_function(move |t| 300.0 * t + phase);
        // sin x = ½ at π/6 and 5π/6: it rises through the former, falls through the latter.
        let next = |angle: f64| (angle - phase).rem_euclid(TAU) / 300.0;
        let [rises, falls] = [PI / 6.0, 5.0 * PI / 6.0].map(next);
        for (text, at) in
            [("sin(z) > 0.5", rises), ("sin(z) < 0.5", falls), ("sin(z) = 0.5", rises.min(falls))]
        {
            for steps in [&[1.0][..], &[0.013, 0.2]] {
                let found = met(&scene, text, false, steps).expect("a turn");
                assert!((found - at).abs() < 1e-13, "{text} {phase} {found} {at}");
            }
        }
    }
}
