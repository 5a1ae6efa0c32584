//! Single functions, each for one rule.

use core::cell::Cell;

use super::super::bracket::Point;
use super::super::extrema::{LocatedExtremum, Zigzag};
use super::super::{Crossing, ExtremumKind, GuardError, NODES, RootStart, extrema, watch, watch_series};
use super::{ULPS, all_extrema, bend, crossing, product};
use super::{first_root, first_root_series};

#[test]
fn the_step_is_half_open() {
    assert_eq!(first_root(|t| 1.0 - t, RootStart::Free, 0.0), Ok(Some(1.0)));
    assert_eq!(first_root(|t| t, RootStart::Free, 0.0), Ok(None));
    assert_eq!(first_root(|t| t * (t - 1.0), RootStart::Free, 0.0), Ok(Some(1.0)));
    assert_eq!(watch(|t| -t, RootStart::Free, 1e-9), Ok(Crossing::LeavesAtStart));
    // Zero at the end is above −δ; the next step starts there and goes down.
    assert_eq!(watch(|t| 1.0 - t, RootStart::Free, 1e-9), Ok(Crossing::Clear));
    assert_eq!(watch(|t| -t - t * t, RootStart::Free, 1e-9), Ok(Crossing::LeavesAtStart));
    assert_eq!(
        watch(|t| (t - 1.0) * (t - 1.0), RootStart::Free, 1e-9),
        Ok(Crossing::Touch { theta: 1.0, value: 0.0 })
    );
    assert_eq!(watch(|t| t * t, RootStart::Free, 1e-9), Ok(Crossing::Clear));
}

/// A turning point at the seam of two steps belongs to one of them at least.
#[test]
fn a_touch_at_a_seam_is_seen() {
    for i in -2000..=2000 {
        let delta = 1e-10;
        let a = 1.0 + f64::from(i) * 1e-8;
        let g = |t: f64| 3.0 * (t - a) * (t - a) * bend(0.3, t);
        let before = watch(g, RootStart::Free, delta).expect("finite");
        let after = watch(|t| g(1.0 + t), RootStart::Free, delta).expect("finite");
        let touches = [before, after].map(|v| matches!(v, Crossing::Touch { .. }));
        assert!(touches[0] || touches[1], "{a}: {before:?} {after:?}");
    }
}

#[test]
fn a_touch_before_a_crossing_comes_first() {
    let g = |t: f64| (t - 0.3) * (t - 0.3) * (0.8 - t);
    let Ok(Crossing::Touch { theta, .. }) = watch(g, RootStart::Free, 1e-9) else {
        panic!("a touch at 0.3");
    };
    assert!((theta - 0.3).abs() < 1e-8);
    // From there on, the touch is a known root.
    let rest = |s: f64| g(theta + s * (1.0 - theta));
    let s = crossing(watch(rest, RootStart::Root, 1e-9)).expect("a crossing");
    assert!((theta + s * (1.0 - theta) - 0.8).abs() < ULPS);
}

/// From a known root down by less than δ and up again: still that root.
#[test]
fn a_dip_within_the_band_of_a_known_root() {
    let g = |t: f64| 1e-6 * t * (t - 0.04);
    assert_eq!(watch(g, RootStart::Root, 1e-9), Ok(Crossing::Clear));
    assert!(matches!(watch(g, RootStart::Free, 1e-9), Ok(Crossing::Touch { .. })));
    assert_eq!(watch(g, RootStart::Root, 1e-10), Ok(Crossing::LeavesAtStart));
}

/// Three roots 1e-4 apart with 4e-13 between: within δ the last counts, above it the first.
#[test]
fn the_last_change_of_sign_before_leaving_the_band() {
    let g = |t: f64| -product(&[0.4999, 0.5, 0.5001], t);
    let last = crossing(watch(g, RootStart::Free, 1e-11)).expect("a crossing");
    let first = crossing(watch(g, RootStart::Free, 1e-13)).expect("a crossing");
    assert!((last - 0.5001).abs() < ULPS && (first - 0.4999).abs() < ULPS);
    assert_eq!(first_root(g, RootStart::Free, 1e-11).map(|root| root == Some(first)), Ok(true));
}

/// p′ = x (x² − 1/16) has a root where the interval is halved.
#[test]
fn a_turning_point_in_the_middle() {
    let g = |t: f64| (t - 0.5).powi(4) / 4.0 - (t - 0.5).powi(2) / 32.0;
    let found = all_extrema(g, 0.0);
    let expected = [0.25, 0.5, 0.75];
    assert_eq!(found.len(), 3, "{found:?}");
    for (extremum, expected) in found.iter().zip(expected) {
        assert!((extremum.theta - expected).abs() < 1e-14, "{found:?}");
    }
}

#[test]
fn a_stop_condition_may_be_tangent() {
    for sign in [-1.0, 1.0] {
        let g = |t: f64| sign * ((t - 0.4) * (t - 0.4) * bend(0.2, t) + 5e-10);
        let theta = first_root(g, RootStart::Free, 1e-9).expect("finite").expect("a root");
        assert!((theta - 0.4).abs() < 1e-9, "{theta}");
        assert_eq!(first_root(g, RootStart::Free, 1e-10), Ok(None));
    }
}

#[test]
fn a_function_that_no_polynomial_fits() {
    for i in 1..100 {
        let a = f64::from(i) / 100.3;
        let kink = |t: f64| (t - a).abs() - 1e-3;
        let theta = crossing(watch(kink, RootStart::Free, 1e-6)).expect("a crossing");
        assert!((theta - (a - 1e-3)).abs() < ULPS, "{a}: {theta}");
        assert_eq!(watch(|t| (t - a).abs() + 1e-3, RootStart::Free, 1e-6), Ok(Crossing::Clear));
    }
}

/// Noise of 1e-12 from a hash of θ, within δ; some 17 more samples, no recursion.
#[test]
fn noise_within_the_error_bound() {
    let noise = |t: f64| {
        let hash = t.to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11;
        1e-12 * (hash as f64 / (1u64 << 52) as f64 - 1.0)
    };
    let count = Cell::new(0);
    let noisy = |t: f64| {
        count.set(count.get() + 1);
        (t - 0.6) * (t - 0.6) + noise(t)
    };
    assert!(matches!(watch(noisy, RootStart::Free, 4e-12), Ok(Crossing::Touch { .. })));
    assert_eq!(watch(|t| noisy(t) + 1e-11, RootStart::Free, 4e-12), Ok(Crossing::Clear));
    assert!(crossing(watch(|t| noisy(t) - 1e-11, RootStart::Free, 4e-12)).is_some());
    assert!(count.get() < 150, "{} evaluations", count.get());
}

#[test]
fn evaluations() {
    let count = Cell::new(0);
    let counted = |g: &dyn Fn(f64) -> f64, t: f64| {
        count.set(count.get() + 1);
        g(t)
    };
    let smooth: &dyn Fn(f64) -> f64 = &|t: f64| 2.0 + (0.3 * t + 0.2).cos();
    assert_eq!(watch(|t| counted(smooth, t), RootStart::Free, 1e-12), Ok(Crossing::Clear));
    assert_eq!(count.take(), NODES.len());
    // A run has its values at these places once for all guards.
    let known = |t: f64| if NODES.contains(&t) { smooth(t) } else { counted(smooth, t) };
    assert_eq!((watch(known, RootStart::Free, 1e-12), count.take()), (Ok(Crossing::Clear), 0));
    let falling: &dyn Fn(f64) -> f64 = &|t: f64| (0.3 * t + 0.2).cos() - 0.95;
    assert!(crossing(watch(|t| counted(falling, t), RootStart::Free, 1e-12)).is_some());
    // 17 for the fit, two to compare with it, the rest for the root.
    assert!(count.get() <= 27, "{} evaluations", count.get());
}

#[test]
fn nonfinite_values_are_reported() {
    let pole = |t: f64| 1.0 / (t - 0.5);
    assert_eq!(watch(pole, RootStart::Free, 0.0), Err(GuardError::NotFinite { theta: 0.5 }));
    assert!(first_root(|_| f64::NAN, RootStart::Free, 0.0).is_err());
    assert!(extrema(|t| (t - 0.9).sqrt(), 0.0, |_| ()).is_err());
}

/// Kinks that touch zero, or dip below it by less than a millionth: no polynomial tells.
#[test]
fn kinks() {
    for i in 1..200 {
        let a = f64::from(i) / 200.7;
        let kink = |shift: f64| move |theta: f64| (theta - a).abs() * bend(0.3, theta) + shift;
        for shift in [0.0, 1e-10, -1e-10] {
            let touch = watch(kink(shift), RootStart::Free, 1e-9);
            assert!(
                matches!(touch, Ok(Crossing::Touch { theta, .. }) if (theta - a).abs() < 1e-9),
                "{a} {shift} {touch:?}"
            );
            let root = first_root(kink(shift), RootStart::Free, 1e-9).expect("finite").expect("a root");
            assert!((root - a).abs() < 1e-9, "{a} {root}");
        }
        assert_eq!(watch(kink(1e-8), RootStart::Free, 1e-9), Ok(Crossing::Clear));
        assert_eq!(first_root(kink(1e-8), RootStart::Free, 1e-9), Ok(None));
        let theta = crossing(watch(kink(-1e-8), RootStart::Free, 1e-9)).expect("a crossing");
        assert!((theta - (a - 1e-8 / bend(0.3, a))).abs() < 1e-14, "{a} {theta}");
    }
}

/// A jump from a function that falls to less than half of its value before, and beyond a steep one.
#[test]
fn jumps_of_functions_that_change() {
    for i in 1..200 {
        let p = f64::from(i) / 200.3;
        let falling = |theta: f64| if theta < p { 1e-3 + p - theta } else { -1e-3 - (theta - p) };
        assert_eq!(first_root(falling, RootStart::Free, 1e-12), Ok(None), "{p}");
        let steep = |theta: f64| (theta - p).cbrt() + 0.5 * (theta - p);
        let root = first_root(steep, RootStart::Free, 1e-12).expect("finite").expect("a root");
        assert!((root - p).abs() < ULPS, "{p} {root}");
    }
}

/// An extremum within √δ of a seam stands out from it in neither step by δ, but is seen.
#[test]
fn an_extremum_at_a_seam_is_seen() {
    let delta = 1e-10;
    for i in -40..=40 {
        let a = 1.0 + f64::from(i) * 1e-6;
        let g = |theta: f64| 3.0 * (theta - a) * (theta - a) * bend(0.3, theta);
        let (before, after) = (all_extrema(g, delta), all_extrema(|theta| g(1.0 + theta), delta));
        let near = |e: &LocatedExtremum, end: f64| (e.theta - end).abs() < 1e-4;
        let seen =
            before.iter().filter(|e| near(e, 1.0)).count() + after.iter().filter(|e| near(e, 0.0)).count();
        assert!((1..=2).contains(&seen), "{a}: {before:?} {after:?}");
    }
}

/// Poles and jumps change the sign without a zero; the root behind them is found.
#[test]
fn poles_and_jumps_are_no_roots() {
    for p in [0.1234, 0.51, 0.77] {
        let pole = |theta: f64| 1.0 / (theta - p);
        assert_eq!(first_root(pole, RootStart::Free, 1e-12), Ok(None), "{p}");
        let jump = |theta: f64| if theta < p { -0.1 } else { 1.0 };
        assert_eq!(first_root(jump, RootStart::Free, 1e-12), Ok(None), "{p}");
        let behind = first_root(|theta| pole(theta) * (0.9 - theta), RootStart::Free, 1e-12);
        assert!(
            behind.is_ok_and(|root| root.is_some_and(|root| (root - 0.9).abs() < ULPS)),
            "{p} {behind:?}"
        );
        // What is behind the end is the next step's.
        let later = |theta: f64| {
            assert!((0.0..=1.0).contains(&theta), "{theta} is outside of the step");
            pole(theta) * (1.3 - theta)
        };
        assert_eq!(first_root(later, RootStart::Free, 1e-12), Ok(None), "{p}");
    }
}

/// A minimum at the bound itself touches; one above does not.
#[test]
fn the_bound_itself_is_touched() {
    let touch = Crossing::Touch { theta: 0.5, value: 1.0 };
    assert_eq!(watch_series(&[1.25, -1.0, 1.0], RootStart::Free, 1.0), Ok(touch));
    assert_eq!(watch_series(&[1.25_f64.next_up(), -1.0, 1.0], RootStart::Free, 1.0), Ok(Crossing::Clear));
    assert_eq!(first_root_series(&[1.25, -1.0, 1.0], RootStart::Free, 1.0), Ok(Some(0.5)));
    assert_eq!(first_root_series(&[-1.25, 1.0, -1.0], RootStart::Free, 1.0), Ok(Some(0.5)));
    assert_eq!(first_root_series(&[1.25_f64.next_up(), -1.0, 1.0], RootStart::Free, 1.0), Ok(None));
}

/// Of equal values the first counts, and what differs by the noise is no turn.
#[test]
fn the_first_of_equal_extrema() {
    for (sign, kind) in [(1.0, ExtremumKind::Maximum), (-1.0, ExtremumKind::Minimum)] {
        let told = |noise: f64| {
            let mut zigzag = Zigzag::default();
            let values = [0.0, 1.0, 1.0, 0.5, 1.0, 1.0, 0.0];
            let points = values.iter().enumerate().map(|(k, x)| Point { theta: k as f64, value: sign * x });
            points.filter_map(|point| zigzag.push(point, noise)).collect::<Vec<_>>()
        };
        let of = |theta: f64, value: f64, kind| LocatedExtremum { theta, value: sign * value, kind };
        let other = if sign > 0.0 { ExtremumKind::Minimum } else { ExtremumKind::Maximum };
        assert_eq!(told(0.25), [of(1.0, 1.0, kind), of(3.0, 0.5, other), of(4.0, 1.0, kind)]);
        assert_eq!(told(0.5), [of(1.0, 1.0, kind)]);
    }
}
