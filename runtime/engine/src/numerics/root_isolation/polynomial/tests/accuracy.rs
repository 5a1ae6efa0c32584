//! How well a fit is known, from its coefficients and between its nodes.

use core::cell::Cell;

use super::super::*;
use super::{from_roots, values};

/// One coefficient of a quarter counts as much as another one, and none of any other quarter.
#[test]
fn coefficients_shrink_from_quarter_to_quarter() {
    for n in [COARSE, 2 * COARSE, FINE] {
        let q = n / 4;
        for (first, third, fourth) in (1..=2 * q)
            .flat_map(|i| (1..=q).flat_map(move |j| (1..=q).map(move |k| (i, 2 * q + j, 3 * q + k))))
        {
            let shrinks = |least: f64, last: f64| {
                let mut c = [0.0; FINE + 1];
                (c[0], c[first], c[third], c[fourth]) = (1e9, -1.0, least, -last);
                shrink(&c[..=n])
            };
            assert!(shrinks(SHRINKS, SHRINKS * SHRINKS) && shrinks(0.0, 0.0), "{n} {first} {third}");
            assert!(!shrinks(1.01 * SHRINKS, 0.0) && !shrinks(SHRINKS, 1.01 * SHRINKS * SHRINKS), "{n}");
        }
    }
}

/// The last half at a level: twice that where it has stopped to shrink, and is below the limit.
#[test]
fn a_plateau_is_noise() {
    for n in [2 * COARSE, FINE] {
        for (third, fourth) in [(n / 2 + 1, 3 * n / 4 + 1), (3 * n / 4, n)] {
            let level = |before: f64, last: f64| {
                let mut c = [1.0; FINE + 1];
                c[n / 2 + 1..=n].fill(0.0);
                (c[third], c[fourth]) = (-before, last);
                noise(&c[..=n], 1e-3)
            };
            assert_eq!(level(1e-4, 5e-5), Some(2e-4));
            assert_eq!(level(5e-5, -1e-4), Some(2e-4));
            assert_eq!(level(1e-4, 0.99e-5), None);
            assert_eq!(level(1e-4, 1.01e-5), Some(2e-4));
            assert_eq!(level(1e-3, 1e-3), None);
            assert_eq!((level(1.01e-3, 1e-3), level(0.99e-3, 0.5e-3)), (None, Some(2.0 * 0.99e-3)));
        }
    }
    assert_eq!(noise(&[1e-5; COARSE + 1], 1e-3), None);
}

/// qᵏ up to degree 8: known to a hundredth of δ or to rounding; if not, to ten times the last,
/// where q⁴ and q² are at most a tenth.
#[test]
fn how_well_a_fit_is_known_follows_from_its_coefficients() {
    for q in [0.2_f64, 0.3, 0.4, 0.6] {
        let samples = values(|k| q.powi(k as i32), COARSE);
        let last = q.powi(8);
        for (part, resolved) in [(1.01, true), (0.99, false)] {
            let delta = part * 100.0 * last;
            let fit = Polynomial::interpolate(&samples, COARSE, delta);
            assert_eq!(fit.resolved, resolved, "{q} {part}");
            let error = if resolved { 0.01 * delta } else { 10.0 * last };
            assert!((fit.error / error - 1.0).abs() < 1e-6, "{q} {part} {}", fit.error);
            assert_eq!((fit.margin, fit.scatter), (2.0 * fit.error, 2.0 * fit.error));
        }
        // Less than the last one asked for.
        let fit = Polynomial::interpolate(&samples, COARSE, 0.1 * last);
        match q * q <= SHRINKS {
            true => assert_eq!((fit.margin, fit.scatter), (2.0 * fit.error, 2.0 * fit.error)),
            false => {
                assert_eq!(fit.margin, f64::INFINITY);
                assert!((fit.scatter / (16.0 * q.powi(5)) - 1.0).abs() < 1e-12, "{q}");
            }
        }
        assert_eq!(fit.ends, [samples[0], samples[FINE]]);
    }
    for size in [1e-6, 1.0, 1e6] {
        let fit = Polynomial::interpolate(&[-size; FINE + 1], COARSE, 0.0);
        assert!(fit.resolved && fit.error == 8.0 * f64::EPSILON * size && fit.degree == 0);
    }
}

#[test]
fn a_fit_that_differs_from_the_function_is_not_resolved() {
    let checked = |at: f64, by: f64, places: [f64; 2]| {
        let count = Cell::new(0);
        let mut p = from_roots(&[0.25]);
        let mut sample = |x: f64| {
            count.set(count.get() + 1);
            Ok(0.25 + if x == at { by } else { 0.0 })
        };
        p.check(&mut sample, places).unwrap();
        (p, count.get())
    };
    for at in [0.3, 0.7] {
        for sign in [1.0, -1.0] {
            let (within, count) = checked(at, sign * 3.99e-3, [0.3, 0.7]);
            assert!(within.resolved && within.error == 1e-3 && within.margin == 2e-3 && count == 2);
            let (beyond, _) = checked(at, sign * 0.5, [0.3, 0.7]);
            assert!(!beyond.resolved && beyond.margin == f64::INFINITY, "{at}");
            assert_eq!((beyond.error, beyond.scatter), (4.0 * 0.5, 16.0 * 0.5));
        }
    }
    assert_eq!(checked(0.3, 0.0, [0.3; 2]).1, 1);
    let mut exact = from_roots(&[0.0]);
    exact.check(&mut |_| Ok(CHECKED * 1e-3), [0.3, 0.7]).unwrap();
    assert!(exact.resolved);
}
