//! Sums of Chebyshev polynomials, Tₖ(2x − 1) = cos kφ with 2x − 1 = cos φ.

mod accuracy;

use super::*;

/// Coefficients of either sign.
fn coefficient(k: usize) -> f64 {
    ((7 * k + 3) % 11) as f64 / 8.0 - 0.7
}

fn sum(c: impl Fn(usize) -> f64, n: usize, x: f64) -> f64 {
    let phi = (2.0 * x - 1.0).acos();
    (0..=n).map(|k| c(k) * (k as f64 * phi).cos()).sum()
}

/// A sum of degree `n` at the nodes of that degree; what is between is never asked for.
fn values(c: impl Fn(usize) -> f64, n: usize) -> [f64; FINE + 1] {
    let mut values = [f64::NAN; FINE + 1];
    (0..=n).for_each(|j| values[j * (FINE / n)] = sum(&c, n, node(j, n)));
    values
}

fn from_roots(known: &[f64]) -> Polynomial {
    let mut coefficients = [0.0; FINE + 1];
    coefficients[..known.len()].copy_from_slice(known);
    let (ends, resolved) = ([0.0; 2], true);
    let degree = known.len() - 1;
    Polynomial { degree, coefficients, error: 1e-3, ends, resolved, margin: 2e-3, scatter: 2e-3 }
}

#[test]
fn coefficients_of_every_degree_are_found() {
    for n in [COARSE, 2 * COARSE, FINE] {
        let c = coefficients(&values(coefficient, n), n);
        for (k, c) in c.into_iter().enumerate() {
            let expected = if k <= n { coefficient(k) } else { 0.0 };
            assert!((c - expected).abs() < 1e-14, "{n} {k}: {c}");
        }
    }
    let samples = values(coefficient, COARSE);
    let samples: Vec<f64> = samples.into_iter().step_by(FINE / COARSE).collect();
    for (k, c) in last_coefficients(&samples).into_iter().enumerate() {
        assert!((c - coefficient(COARSE - 3 + k)).abs() < 1e-14, "{k}");
    }
}

/// d/dx cos kφ = 2 k sin kφ / sin φ.
#[test]
fn values_slopes_and_bounds_are_those_of_cosines() {
    for n in [0, 1, 2, 5, 8, 16, 32] {
        let known: Vec<f64> = (0..=n).map(coefficient).collect();
        let p = from_roots(&known);
        let (slope, [low, high]) = (p.derivative(), p.range());
        let size: f64 = known[1..].iter().map(|c| c.abs()).sum();
        assert!((high - low - 2.0 * size).abs() < 1e-14 && (low + high - 2.0 * known[0]).abs() < 1e-14);
        assert_eq!(slope.degree, n.saturating_sub(1));
        for x in [0.07, 0.31, 0.5, 0.77, 0.98] {
            assert!((p.evaluate(x) - sum(coefficient, n, x)).abs() < 1e-13, "{n} {x}");
            let phi = (2.0 * x - 1.0_f64).acos();
            let rate: f64 =
                (1..=n).map(|k| coefficient(k) * 2.0 * k as f64 * (k as f64 * phi).sin() / phi.sin()).sum();
            assert!((2.0 * slope.evaluate(x) - rate).abs() < 1e-12 * (1 + n * n) as f64, "{n} {x}");
        }
    }
}

/// Of halves of halves the last two sum to 3/256, the last three to 7/256.
#[test]
fn the_last_coefficients_are_dropped_up_to_a_level() {
    let halves: Vec<f64> = (0..=8).map(|k| 0.5_f64.powi(k)).collect();
    for (level, degree) in [(0.0, 8), (2.9, 7), (3.0, 6), (6.9, 6), (7.0, 5), (1e3, 0)] {
        let mut p = from_roots(&halves);
        p.chop(level / 256.0);
        assert_eq!(p.degree, degree, "{level}");
        assert!((0..=8).all(|k| p.coefficients[k] == if k <= degree { halves[k] } else { 0.0 }), "{level}");
    }
}

/// Of qᵏ the last; where every other one vanishes the one that comes next, if that is more.
#[test]
fn what_is_left_out_follows_from_the_last_four() {
    for q in [0.1, 0.5, 0.9, -0.5] {
        let all: [f64; 9] = core::array::from_fn(|k| f64::powi(q, k as i32));
        assert_eq!(tail(&all), q.powi(8));
        let odd: [f64; 9] = core::array::from_fn(|k| if k % 2 == 1 { all[k] } else { 0.0 });
        let next = q.powi(9).abs();
        assert!((tail(&odd) - next).abs() < 1e-15 * next, "{q}");
    }
    for lasting in [[0.0, 0.0, 0.25, 0.0], [0.25, 0.0, 0.25, 0.0], [0.0, 0.25, -0.25, 0.0]] {
        assert_eq!(tail(&lasting), 0.25);
    }
    assert_eq!(tail(&[0.0; 9]), 0.0);
}

/// The fewest nodes for a degree, and values that are the sum's.
#[test]
fn a_polynomial_is_known_from_as_many_places_as_it_takes() {
    for (degree, places) in [(1, 9), (8, 9), (9, 17), (16, 17), (17, 33), (32, 33)] {
        let mut count = 0;
        let mut g = |x: f64| {
            count += 1;
            sum(coefficient, degree, x)
        };
        let p = Polynomial::exact(&mut g, degree, 1e-6).unwrap();
        assert_eq!(count, places, "{degree}");
        let largest = (0..=FINE).map(|j| sum(coefficient, degree, node(j, FINE)).abs()).fold(0.0, f64::max);
        assert!(p.error > 1e-6 && p.error <= 1e-6 + 8.01 * f64::EPSILON * largest);
        assert_eq!(p.ends, [0.0, 1.0].map(|x| sum(coefficient, degree, x)));
        for x in [0.0, 0.13, 0.5, 0.77, 1.0] {
            assert!((p.evaluate(x) - sum(coefficient, degree, x)).abs() < 1e-13, "{degree} {x}");
        }
    }
}

/// A line, a wave of some turns, and one that no degree resolves: how many places each takes with
/// those that are compared.
#[test]
fn the_degree_rises_until_the_function_is_resolved() {
    for (omega, places, resolved) in [(0.0, 10, true), (5.0, 19, true), (16.0, 35, true), (200.0, 35, false)]
    {
        let mut count = 0;
        let mut g = |theta: f64| {
            count += 1;
            theta + (omega * theta).sin()
        };
        let fit = Polynomial::fit(&mut g, [0.25, 0.75], 1e-8, &|_| false).unwrap();
        assert_eq!((count, fit.resolved), (places, resolved), "{omega}");
        for x in [0.1_f64, 0.4, 0.9].into_iter().filter(|_| resolved) {
            let theta = 0.25 + 0.5 * x;
            assert!((fit.evaluate(x) - theta - (omega * theta).sin()).abs() <= 1e-8, "{omega} {x}");
        }
    }
    let good = Polynomial::fit(&mut |theta| (200.0 * theta).sin(), [0.0, 1.0], 1e-8, &|_| true);
    assert!(good.unwrap().degree <= COARSE);
}
