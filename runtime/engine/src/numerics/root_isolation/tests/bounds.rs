//! Cheap bounds of series with whole coefficients, whose sums are exact.

use super::super::series::PowerSeries;
use super::super::{RootStart, stays_above, without_zeros};
use super::known::Random;

/// What rounding may add to a bound, relative to the sum of sizes.
const ROUNDED: f64 = 1e-13;

fn drawn(random: &mut Random) -> Vec<f64> {
    let count = 1 + random.below(12);
    (0..count).map(|_| random.below(9) as f64 - 4.0).collect()
}

fn size(c: &[f64]) -> f64 {
    c.iter().map(|c| c.abs()).sum()
}

/// `bound` is outside of what is bounded, by rounding alone.
fn is_beside([low, high]: [f64; 2], [least, most]: [f64; 2], size: f64) -> bool {
    let beyond = [least - low, high - most];
    beyond.iter().all(|by| *by <= ROUNDED * size && (*by > 0.0 || size == 0.0))
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// Least and greatest.
fn extremes(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

#[test]
fn partial_sums_and_bernstein_coefficients_bound_a_series() {
    let mut random = Random(5);
    for _ in 0..2000 {
        let c = drawn(&mut random);
        let series = PowerSeries::new(&c, RootStart::Free);
        let sums = extremes((0..c.len()).map(|k| c[..=k].iter().sum()));
        assert!(is_beside(series.partial_sums(), sums, size(&c)), "{c:?}");
        let terms = without_zeros(&c);
        let n = terms.len().saturating_sub(1);
        let bernstein = |j: usize| -> f64 {
            terms.iter().take(j + 1).enumerate().map(|(k, c)| binomial(j, k) / binomial(n, k) * c).sum()
        };
        let coefficients = extremes((0..=n).map(bernstein));
        let [low, high] = series.range();
        // These are rounded here too.
        assert!((low - coefficients[0]).abs() <= ROUNDED * size(&c), "{c:?} {low} {coefficients:?}");
        assert!((high - coefficients[1]).abs() <= ROUNDED * size(&c), "{c:?} {high} {coefficients:?}");
        for theta in (0..=20).map(|k| f64::from(k) / 20.0) {
            let value = series.evaluate(theta);
            assert!(low <= value && value <= high, "{c:?} {theta}");
        }
    }
}

/// c₀ + Σ min(cₖ, 0) for c₀ > 0, and what of it is more than rounding and more than a bound.
#[test]
fn what_lets_a_series_fall_bounds_it() {
    let mut random = Random(6);
    let mut above = 0;
    for _ in 0..2000 {
        let c = drawn(&mut random);
        let sign = if c[0] < 0.0 { -1.0 } else { 1.0 };
        let least = sign * c[0] + c[1..].iter().map(|c| (sign * c).min(0.0)).sum::<f64>();
        let [low, high] = PowerSeries::new(&c, RootStart::Free).reach();
        let [bound, other] = if sign > 0.0 { [low, high] } else { [-high, -low] };
        assert!(least - bound <= ROUNDED * c[0].abs() && (bound < least || c[0] == 0.0), "{c:?}");
        assert_eq!(other, f64::INFINITY, "{c:?}");
        if sign > 0.0 && least > 0.0 {
            above += 1;
            assert!(stays_above(&c, least - 1e-9) && !stays_above(&c, least + 1e-9), "{c:?}");
        } else {
            assert!(!stays_above(&c, -1.0), "{c:?}");
        }
    }
    assert!(above > 100, "{above}");
    // One term is rounded once for each of the terms that there is room for.
    let least = 1.0 - 33.0 * f64::EPSILON;
    assert!(!stays_above(&[1.0], least) && stays_above(&[1.0], least.next_down()));
    // What is no number proves nothing, wherever it stands.
    for k in 0..7 {
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut c = [9.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
            c[k] = wrong;
            assert!(!stays_above(&c, 0.0), "{c:?}");
        }
    }
    // Above its bound by less than the rounding of its terms.
    assert!(!stays_above(&[1.0, -1.0 + 1e-14], -1.0) && stays_above(&[1.0, -1.0 + 1e-12], -1.0));
}

#[test]
fn behind_a_known_root_every_sign_counts() {
    for (start, level) in [
        (RootStart::Free, 1e-3),
        (RootStart::Root, 1e-3),
        (RootStart::Continues { positive: true }, 1e-3),
        (RootStart::Order(0), 1e-3),
        (RootStart::Order(1), 0.0),
        (RootStart::Order(2), 0.0),
    ] {
        assert_eq!(PowerSeries::new(&[0.0, 0.0, 1.0], start).level(1e-3), level, "{start:?}");
    }
}
