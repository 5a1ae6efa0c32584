//! Crossings of polynomials by their series and by their values.

use super::*;

/// (θ − 0.3)(θ − 0.6)(0.9 − θ): above zero up to 0.3 and from 0.6 to 0.9.
const CUBIC: [f64; 4] = [0.162, -0.99, 1.8, -1.0];
/// (θ − 0.5)².
const SQUARE: [f64; 3] = [0.25, -1.0, 1.0];
const BOUND: f64 = 1e-12;

fn evaluate(c: &[f64], theta: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * theta + c)
}

/// A guard known by its series, and by its values.
fn both(c: &[f64], look: impl Fn(GuardSource<'_>)) {
    let value = |theta: f64| evaluate(c, theta);
    look(GuardSource::Series(c));
    look(GuardSource::Values { value: &value, size: 2.0, is_noisy: false });
}

#[test]
fn roots_behind_a_place_are_reported_as_places_of_the_step() {
    both(&CUBIC, |guard| {
        for (from, root) in [(0.0, 0.3), (0.4, 0.6), (0.7, 0.9), (0.95, f64::NAN)] {
            let found = guard.first_root(from, RootStart::Free, (0.0, BOUND)).unwrap();
            // The slope is 0.09 at least: the unit roundoff of terms up to two.
            assert!(found.map_or(root.is_nan(), |theta| (theta - root).abs() < 1e-13), "{from} {found:?}");
        }
        for (from, shift) in [(0.0, 0.01), (0.0, -0.01), (0.4, 0.005), (0.8, -0.002)] {
            let theta = guard.first_root(from, RootStart::Free, (shift, BOUND)).unwrap().unwrap();
            assert!(
                theta > from && (evaluate(&CUBIC, theta) + shift).abs() < 1e-14,
                "{from} {shift} {theta}"
            );
        }
    });
}

#[test]
fn falls_and_touches_are_reported_as_places_of_the_step() {
    both(&CUBIC, |guard| {
        for (from, fall) in [(0.0, 0.3), (0.1, 0.3), (0.65, 0.9)] {
            let Crossing::At { theta } = guard.watch(from, RootStart::Free, BOUND).unwrap() else {
                panic!("it falls behind {from}")
            };
            assert!((theta - fall).abs() < 1e-13, "{from} {theta}");
        }
        assert_eq!(guard.watch(0.4, RootStart::Free, BOUND), Ok(Crossing::LeavesAtStart));
    });
    both(&SQUARE, |guard| {
        for from in [0.0, 0.2] {
            let Crossing::Touch { theta, value } = guard.watch(from, RootStart::Free, BOUND).unwrap() else {
                panic!("it touches behind {from}")
            };
            // The value is flat: known to the unit roundoff ε, the place to √ε.
            assert!((theta - 0.5).abs() < 1e-7 && value.abs() < 1e-14, "{theta} {value}");
        }
        assert_eq!(guard.watch(0.6, RootStart::Free, BOUND), Ok(Crossing::Clear));
        assert_eq!(guard.first(), 0.25);
    });
}

#[test]
fn nonfinite_values_are_reported_in_step_coordinates() {
    let value = |theta: f64| if theta > 0.8 { f64::NAN } else { 1.0 };
    let guard = GuardSource::Values { value: &value, size: 1.0, is_noisy: false };
    for error in [
        guard.watch(0.5, RootStart::Free, BOUND).unwrap_err(),
        guard.first_root(0.5, RootStart::Free, (0.0, BOUND)).unwrap_err(),
    ] {
        assert!(matches!(error, GuardError::NotFinite { theta } if (0.8..=1.0).contains(&theta)), "{error}");
    }
}

#[test]
fn roundoff_and_exact_zero_are_distinguished() {
    let value = |_: f64| 0.0;
    let values = GuardSource::Values { value: &value, size: 3.0, is_noisy: false };
    assert_eq!(GuardSource::Series(&[1.0, -3.0, 2.0]).rounding(), values.rounding());
    assert_eq!(values.rounding(), 48.0 * f64::EPSILON);
    // Pairs of terms that shrink tenfold go on as a geometric series: 2 (0.001 + 0.0001 + …).
    let (series, tail) = ([1.0, 0.1, 0.1, 0.01, 0.01], 0.002 / 0.9);
    // Twice the last where it is rounding of the first.
    let last = f64::powi(2.0, -60);
    let rounded = [1.0, 0.0, 0.0, 0.0, 0.0, last];
    assert!(is_exact(&rounded, 20.0 * last) && !is_exact(&rounded, (20.0 * last).next_down()));
    assert!(is_exact(&series, 1.001 * tail / EXACT) && !is_exact(&series, 0.999 * tail / EXACT));
    // What is ten times as far from the bound as the series may be wrong is clear, though it does
    // not count as the guard.
    let falling = |first: f64| [first, -0.1, -0.1, -0.01, -0.01];
    let least = 0.22 + tail / EXACT;
    for (first, bound, clear) in
        [(least + 1e-12, 0.0, true), (least - 1e-12, 0.0, false), (0.5, 0.279, true), (0.5, 0.281, false)]
    {
        assert_eq!(is_clear(&falling(first), bound), clear, "{first} {bound}");
    }
    // 1 + (1 − 2θ)² less 0.044 at most: proven by its Bernstein coefficients, not by its falling
    // terms alone.
    let bent = [2.0, -4.0, 4.0, -0.02, -0.02, -0.002, -0.002];
    assert!(is_clear(&bent, 1e-9) && !is_clear(&bent, 1.0));
    assert!(!is_clear(&[1e9, 1.0, 1.0, 1.0, 1.0], 0.0), "the terms do not shrink");
}
