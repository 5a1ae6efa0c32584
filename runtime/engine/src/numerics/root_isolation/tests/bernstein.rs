//! Bernstein coefficients in closed form, and turning points up to what is negligible.

use super::super::bernstein::Bernstein;
use super::super::isolate::turning_points;
use super::super::polynomial::{FINE, Polynomial};

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n as f64 - i as f64) / (i + 1) as f64)
}

/// Σ bⱼ C(n, j) xʲ (1 − x)ⁿ⁻ʲ.
fn value(b: &[f64], x: f64) -> f64 {
    let n = b.len() - 1;
    let term = |(j, b): (usize, &f64)| b * binomial(n, j) * x.powi(j as i32) * (1.0 - x).powi((n - j) as i32);
    b.iter().enumerate().map(term).sum()
}

fn chebyshev(known: &[f64]) -> Bernstein {
    let mut coefficients = [0.0; FINE + 1];
    coefficients[..known.len()].copy_from_slice(known);
    let (degree, ends) = (known.len() - 1, [0.0; 2]);
    let (error, margin, scatter, resolved) = (0.0, 0.0, 0.0, true);
    Bernstein::from_chebyshev(&Polynomial { degree, coefficients, error, ends, resolved, margin, scatter })
}

/// xᵏ has the coefficients C(j, k)/C(n, k).
#[test]
fn powers_have_binomial_coefficients() {
    for n in [0, 1, 2, 5, 17, FINE] {
        for k in 0..=n {
            let mut powers = vec![0.0; n + 1];
            powers[k] = -3.0;
            let p = Bernstein::from_powers(&powers);
            assert_eq!((p.degree, p.terms().len()), (n, n + 1));
            for (j, found) in p.terms().iter().enumerate() {
                let expected = -3.0 * binomial(j, k) / binomial(n, k);
                assert!((found - expected).abs() <= 1e-13 * 3.0, "{n} {k} {j}: {found} {expected}");
            }
        }
    }
    assert_eq!(Bernstein::from_powers(&[]).terms(), [0.0]);
}

/// Tₙ(2x − 1) has the coefficients (−1)ⁿ⁻ʲ C(2n, 2j)/C(n, j), and sums their values.
#[test]
fn chebyshev_polynomials_have_their_bernstein_coefficients() {
    for n in [0, 1, 2, 3, 6, 12] {
        let mut known = vec![0.0; n + 1];
        known[n] = 0.5;
        let p = chebyshev(&known);
        for (j, found) in p.terms().iter().enumerate() {
            let sign = if (n - j).is_multiple_of(2) { 0.5 } else { -0.5 };
            let expected = sign * binomial(2 * n, 2 * j) / binomial(n, j);
            // The largest coefficient is less than 2ⁿ.
            assert!(
                (found - expected).abs() <= 1e-14 * f64::powi(2.0, n as i32),
                "{n} {j}: {found} {expected}"
            );
        }
        let known: Vec<f64> = (0..=n).map(|k| 0.3 - 0.2 * k as f64).collect();
        for x in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let phi = f64::acos(2.0 * x - 1.0);
            let expected: f64 = known.iter().enumerate().map(|(k, c)| c * (k as f64 * phi).cos()).sum();
            let found = value(chebyshev(&known).terms(), x);
            assert!(
                (found - expected).abs() < 1e-12 * f64::powi(2.0, n as i32),
                "{n} {x}: {found} {expected}"
            );
        }
    }
}

#[test]
fn halves_have_the_values_of_the_whole() {
    let powers = [0.5, -2.0, 1.0, 3.0, -4.0, 0.25];
    let whole = Bernstein::from_powers(&powers);
    let [left, right] = whole.halves();
    for x in [0.0, 0.3, 0.5, 1.0] {
        for (half, at) in [(left, 0.5 * x), (right, 0.5 + 0.5 * x)] {
            assert!((value(half.terms(), x) - value(whole.terms(), at)).abs() < 1e-14, "{x} {at}");
        }
    }
}

/// From the coefficients of a slope on Bernstein's basis.
fn turns(slope: &[f64], rounding: f64) -> Vec<f64> {
    let n = slope.len() - 1;
    // aₖ = C(n, k) Δᵏb₀.
    let difference = |k: usize| -> f64 {
        (0..=k).map(|i| if (k - i).is_multiple_of(2) { 1.0 } else { -1.0 } * binomial(k, i) * slope[i]).sum()
    };
    let powers: Vec<f64> = (0..=n).map(|k| binomial(n, k) * difference(k)).collect();
    let mut found = Vec::new();
    turning_points(Bernstein::from_powers(&powers), rounding, &|x| value(slope, x), &mut |x| found.push(x));
    found
}

/// What is as small as n ε times the largest coefficient, or as the rounding, has no sign, whatever
/// the unit.
#[test]
fn a_sign_within_the_rounding_does_not_count() {
    let least = 4.0 * f64::EPSILON;
    for unit in [f64::powi(2.0, -40), 1.0, f64::powi(2.0, 40)] {
        let of = |first: f64, rounding: f64| {
            turns(&[-first, 1.0, 1.0, 1.0, 1.0].map(|b| unit * b), unit * rounding).len()
        };
        assert_eq!([least, 1.25 * least, 0.25, 0.251].map(|first| of(first, 0.0)), [0, 1, 1, 1], "{unit}");
        assert_eq!([least, 1.25 * least, 0.25, 0.375].map(|first| of(first, 0.25)), [0, 0, 0, 1], "{unit}");
        // 1 − 3x + 3x² touches 1/4 in the middle.
        for (rounding, expected) in [(0.25, vec![0.5]), (0.249, vec![])] {
            let found = turns(&[1.0, -0.5, 1.0].map(|b| unit * b), unit * rounding);
            assert_eq!(found, expected, "{unit} {rounding}");
        }
    }
}

/// A first coefficient that is negligible is no side of a root, though the next has one.
#[test]
fn a_root_beside_a_negligible_end_is_found() {
    for sign in [1.0, -1.0] {
        let slope = [0.125, -1.0, 1.0, 2.0].map(|b| sign * b);
        let found = turns(&slope, 0.125);
        assert!(found.len() == 1 && found[0] > 0.1 && value(&slope, found[0]).abs() < 1e-15, "{found:?}");
        let back: Vec<f64> = slope.iter().rev().copied().collect();
        let found = turns(&back, 0.125);
        assert!(found.len() == 1 && found[0] < 0.9 && value(&back, found[0]).abs() < 1e-15, "{found:?}");
    }
}

/// (x − p)² + w² keeps its sign, which is told down to pieces of 2⁻²¹ at least: of narrower ones
/// their middles.
#[test]
fn near_double_roots_are_one_point() {
    let narrowest = f64::powi(2.0, -20);
    for part in [0.1, 0.35, 0.6, 0.9] {
        let p = narrowest * (314_159.0 + part);
        let [found] = turns(&[p * p, -p * (1.0 - p), (1.0 - p) * (1.0 - p)], 0.0)[..] else {
            panic!("one place for {p}")
        };
        assert!((found - p).abs() <= 0.25 * narrowest, "{part} {found} {p}");
    }
}
