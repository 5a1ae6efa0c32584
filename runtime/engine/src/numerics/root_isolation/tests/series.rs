//! Guards given by their series, each for one rule.

use super::super::{Crossing, GuardError, RootStart, TERMS, rest, tail, watch, watch_series};
use super::{ULPS, crossing};
use super::{all_extrema, first_root, first_root_series};

/// sin(ωθ + φ): ωᵏ/k! sin(φ + kπ/2).
fn sine(omega: f64, phase: f64) -> [f64; TERMS] {
    let turn = [phase.sin(), phase.cos(), -phase.sin(), -phase.cos()];
    let mut power = 1.0;
    core::array::from_fn(|k| {
        power *= if k == 0 { 1.0 } else { omega / k as f64 };
        power * turn[k % 4]
    })
}

fn raised(mut c: [f64; TERMS], by: f64) -> [f64; TERMS] {
    c[0] += by;
    c
}

/// A minimum at ±0.1 δ touches, at 10 δ is nothing, at −10 δ crosses.
#[test]
fn grazing() {
    for exponent in 6..13 {
        let delta = 10f64.powi(-exponent);
        for i in 1..100 {
            let a = f64::from(i) / 100.7;
            // 1 − cos(2(θ − a)) = 1 − sin(2θ + π/2 − 2a)
            let series = raised(sine(2.0, 0.5 * core::f64::consts::PI - 2.0 * a).map(|c| -c), 1.0);
            let verdict = |shift: f64| watch_series(&raised(series, shift * delta), RootStart::Free, delta);
            for shift in [-0.1, 0.1] {
                // g″ = 4, rounding of g′ 33 ε · Σ 2ᵏ/k!, less than 1e-13.
                let touch = matches!(verdict(shift), Ok(Crossing::Touch { theta, value })
                    if (theta - a).abs() < 1e-13 && (value - shift * delta).abs() < 1e-14);
                assert!(touch, "{a} {shift} {delta}: {:?}", verdict(shift));
            }
            assert_eq!(verdict(10.0), Ok(Crossing::Clear));
            let depth = (10.0 * delta / 2.0).sqrt();
            if a > 2.0 * depth {
                let theta = crossing(verdict(-10.0)).expect("a crossing");
                // cos 2x = 1 − 10 δ at x = depth (1 + 10 δ/12 + …); rounding of g over its slope 4
                // depth.
                assert!((theta - (a - depth)).abs() < delta * depth + 1e-15 / depth, "{a} {delta} {theta}");
            }
        }
    }
}

/// Four guards that share nothing but their root.
#[test]
fn one_root_of_several_guards() {
    for i in 1..1000 {
        let a = f64::from(i) / 1000.0;
        let guards: [&[f64]; 4] =
            [&[a, -1.0], &[a * a, 0.0, -1.0], &[a * a * a, 0.0, 0.0, -1.0], &[2.0 * a, -2.0]];
        for c in guards {
            let theta = crossing(watch_series(c, RootStart::Free, 1e-18)).expect("a crossing");
            // a² and a³ are rounded.
            assert!((theta - a).abs() <= f64::EPSILON * a.max(0.25), "{a} {c:?} {theta}");
            assert_eq!(first_root_series(c, RootStart::Free, 1e-18), Ok(Some(theta)));
        }
    }
}

#[test]
fn the_step_is_half_open() {
    assert_eq!(first_root_series(&[1.0, -1.0], RootStart::Free, 0.0), Ok(Some(1.0)));
    assert_eq!(first_root_series(&[0.0, 1.0], RootStart::Free, 0.0), Ok(None));
    assert_eq!(first_root_series(&[0.0, -1.0, 1.0], RootStart::Free, 0.0), Ok(Some(1.0)));
    assert_eq!(watch_series(&[0.0, -1.0], RootStart::Free, 1e-9), Ok(Crossing::LeavesAtStart));
    assert_eq!(watch_series(&[1.0, -1.0], RootStart::Free, 1e-9), Ok(Crossing::Clear));
    assert_eq!(
        watch_series(&[1.0, -2.0, 1.0], RootStart::Free, 1e-9),
        Ok(Crossing::Touch { theta: 1.0, value: 0.0 })
    );
    assert_eq!(watch_series(&[0.0, 0.0, 1.0], RootStart::Free, 1e-9), Ok(Crossing::Clear));
    assert_eq!(watch_series(&[], RootStart::Free, 0.0), Ok(Crossing::Clear));
}

/// θᵐ (b − θ) rises by less than 1e-3, and falls to b − 1: with the order known its root is b,
/// whatever δ says of the rise.
#[test]
fn a_known_order_decides_within_the_bound() {
    for m in 1..=4 {
        let b = 1e-3;
        let mut c = [0.0; 6];
        (c[m], c[m + 1]) = (b, -1.0);
        let theta = crossing(watch_series(&c, RootStart::Order(m), 0.5)).expect("a crossing");
        assert!((theta - b).abs() <= f64::EPSILON);
        assert_eq!(watch_series(&c, RootStart::Root, 0.5), Ok(Crossing::LeavesAtStart));
        assert_eq!(watch_series(&c, RootStart::Order(m), 2.0), Ok(Crossing::Clear));
        assert_eq!(first_root_series(&c, RootStart::Order(m), 0.5), Ok(Some(theta)));
        let down = c.map(|c| -c);
        assert_eq!(watch_series(&down, RootStart::Order(m), 0.5), Ok(Crossing::Clear));
        c[m] = -b;
        assert_eq!(watch_series(&c, RootStart::Order(m), 0.5), Ok(Crossing::LeavesAtStart));
        assert_eq!(first_root_series(&c, RootStart::Order(m), 0.5), Ok(None));
        // What rounding has left below the order does not count.
        let (mut noisy, mut rising) = ([1e-16; 6], [1e-16; 6]);
        (noisy[m], noisy[m + 1], rising[m]) = (b, -1.0, b);
        let theta = crossing(watch_series(&noisy, RootStart::Order(m), 1e-14)).expect("a crossing");
        assert!((theta - b).abs() < 1e-12);
        assert_eq!(watch_series(&rising, RootStart::Order(m), 1e-14), Ok(Crossing::Clear));
    }
}

/// A root that falls between two steps, each of which rounds it to the other.
#[test]
fn a_root_in_the_seam() {
    for positive in [true, false] {
        let sign = if positive { 1.0 } else { -1.0 };
        let start = RootStart::Continues { positive };
        let (before, after) = ([sign, -sign * (1.0 - 1e-12)], [-sign * 1e-12, -sign]);
        assert_eq!(first_root_series(&before, RootStart::Free, 1e-9), Ok(None));
        assert_eq!(first_root_series(&after, start, 1e-9), Ok(Some(0.0)));
        assert_eq!(first_root(|t| after[0] + after[1] * t, start, 1e-9), Ok(Some(0.0)));
        assert_eq!(first_root_series(&after, RootStart::Free, 1e-9), Ok(None));
        // Found at the end of the step before, and not again.
        assert_eq!(first_root_series(&[sign, -sign], RootStart::Free, 1e-9), Ok(Some(1.0)));
        assert_eq!(first_root_series(&[0.0, -sign], start, 1e-9), Ok(None));
        assert_eq!(first_root_series(&[sign, -0.5 * sign], start, 1e-9), Ok(None));
    }
}

#[test]
fn extrema_of_a_sine() {
    for i in 0..200 {
        let (omega, phase) = (4.0, f64::from(i) * 0.03);
        let found = all_extrema(|theta| (omega * theta + phase).sin(), 1e-9);
        assert!(!found.is_empty(), "{phase}");
        for extremum in found {
            // The derivative of the fit is good to δ/100 times 2 · 8², over g″ = ω².
            let turn = (omega * extremum.theta + phase) / core::f64::consts::PI - 0.5;
            assert!((turn - turn.round()).abs() < 1e-9 || extremum.theta == 1.0, "{extremum:?}");
        }
    }
}

#[test]
fn what_is_left_of_a_step() {
    let c = sine(3.0, 0.4);
    for from in [0.0, 0.25, 0.7, 1.0] {
        let left = rest(&c, from);
        for s in [0.0, 0.3, 1.0] {
            let value: f64 = left.iter().rev().fold(0.0, |sum, c| sum * s + c);
            let expected = (3.0 * (from + (1.0 - from) * s) + 0.4).sin();
            // Terms up to e³, some roundings.
            assert!((value - expected).abs() < 20.0 * 8.0 * f64::EPSILON, "{from} {s}");
        }
    }
}

/// Against the true remainder at θ = 1.
#[test]
fn the_tail_of_a_series() {
    let exponential =
        |x: f64| core::array::from_fn::<f64, 40, _>(|k| (1..=k).fold(1.0, |t, j| t * x / j as f64));
    let geometric = |x: f64| core::array::from_fn::<f64, 40, _>(|k| x.powi(k as i32));
    let even =
        |x: f64| core::array::from_fn::<f64, 40, _>(|k| if k % 2 == 0 { x.powi(k as i32) } else { 0.0 });
    for (series, n) in
        [(exponential(1.0), 12), (exponential(-3.0), 18), (sine_of(2.0), 15), (sine_of(2.0), 16)]
    {
        let true_tail = series[n..].iter().sum::<f64>().abs();
        let estimate = tail(&series[..n]);
        assert!(estimate >= true_tail && estimate < 200.0 * true_tail, "{estimate:e} {true_tail:e}");
    }
    for x in [0.1, 0.5, 0.9] {
        for series in [geometric(x), even(x)] {
            let true_tail = series[20..].iter().sum::<f64>() + x.powi(40) / (1.0 - x);
            let estimate = tail(&series[..20]);
            assert!(
                estimate > 0.9 * true_tail && estimate < 4.0 * (true_tail / (1.0 - x) + f64::EPSILON),
                "{x} {estimate:e}"
            );
        }
    }
    assert_eq!(tail(&geometric(1.0)[..20]), f64::INFINITY);
    assert_eq!(tail(&[1.0, 2.0]), f64::INFINITY);
    assert_eq!(tail(&[1.0, 2.0, 3.0, 0.0, 0.0, 0.0]), 0.0);
    // A parabola with what rounding leaves.
    assert!(tail(&[1.0, 2.0, 3.0, 1e-17, -1e-17, 1e-17]) <= 2e-17);
}

/// Coefficients that are zero at the end of a series change nothing, whatever is before them: a
/// root on the way, at a start of known order, none, or nothing at all.
#[test]
fn zeros_at_the_end_of_a_series_say_nothing() {
    let series: [&[f64]; 5] = [&[0.3, 0.2, -1.0], &[0.0, 0.0, 0.4, -1.0], &[1.0, -0.25], &[-0.3], &[0.0]];
    for c in series {
        for start in
            [RootStart::Free, RootStart::Root, RootStart::Order(2), RootStart::Continues { positive: true }]
        {
            let mut long = [0.0; TERMS];
            long[..c.len()].copy_from_slice(c);
            assert_eq!(watch_series(&long, start, 1e-9), watch_series(c, start, 1e-9), "{c:?} {start:?}");
            let roots = [&long, c].map(|c| first_root_series(c, start, 1e-9));
            assert_eq!(roots[0], roots[1], "{c:?} {start:?}");
        }
    }
    assert_eq!(
        first_root_series(&[0.3, 0.2, -1.0, 0.0], RootStart::Free, 1e-9).map(|root| root.is_some()),
        Ok(true)
    );
}

fn sine_of(omega: f64) -> [f64; 40] {
    let mut long = [0.0; 40];
    long[..TERMS].copy_from_slice(&sine(omega, 0.0));
    long
}

#[test]
fn nonfinite_series_are_reported() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..8 {
            let mut c = [5.0, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1];
            c[place] = bad;
            let theta = if place == 0 { 0.0 } else { 1.0 };
            assert_eq!(
                watch_series(&c, RootStart::Free, 1e-9),
                Err(GuardError::NotFinite { theta }),
                "{bad} {place}"
            );
            assert_eq!(first_root_series(&c, RootStart::Free, 1e-9), Err(GuardError::NotFinite { theta }));
        }
    }
    assert!(watch_series(&[1e308, -1e308, -1e308, 1e308], RootStart::Free, 1.0).is_err());
}

/// The same from a function and from its series.
#[test]
fn roots_are_found_both_ways() {
    for i in 0..2000 {
        let (omega, phase) = (0.5 + f64::from(i % 37) / 12.0, f64::from(i) * 0.003);
        let g = |theta: f64| (omega * theta + phase).sin();
        let by_values = crossing(watch(g, RootStart::Free, 1e-12));
        let by_series = crossing(watch_series(&sine(omega, phase), RootStart::Free, 1e-12));
        assert_eq!(by_values.is_some(), by_series.is_some(), "{omega} {phase}");
        if let (Some(a), Some(b)) = (by_values, by_series) {
            // Terms up to eω, rounded; the argument too.
            assert!((a - b).abs() < (omega.exp() + 10.0) * ULPS / omega, "{omega} {phase} {a} {b}");
        }
    }
}

/// Last terms within the rounding of the first do not shrink, and need not: whatever the unit of
/// the series.
#[test]
fn the_tail_of_rounding_is_twice_its_size() {
    for unit in [1e-6, 1.0, 1e6] {
        let rounded = [1.0, 0.5, 1e-17, 1e-17, 1e-17, 1e-17].map(|c| unit * c);
        assert_eq!(tail(&rounded), 2.0 * rounded[5]);
        let just = [1.0, 0.5, -1.0, 1.0, 1.0, -1.0].map(|c| unit * c);
        let just: Vec<f64> =
            just.iter().enumerate().map(|(k, c)| if k < 2 { *c } else { f64::EPSILON * c }).collect();
        assert_eq!(tail(&just), 2.0 * f64::EPSILON * unit);
        let lasting = [1.0, 0.5, 1e-15, 1e-15, 1e-15, 1e-15].map(|c| unit * c);
        assert_eq!(tail(&lasting), f64::INFINITY);
    }
}
