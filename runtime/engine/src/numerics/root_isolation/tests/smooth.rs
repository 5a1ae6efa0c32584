//! Bounds of values and slopes over a piece, against functions that take them.

use super::super::Smooth;

const DEGREE: usize = 8;

fn fitted(g: impl Fn(f64) -> f64, error: f64) -> Smooth {
    Smooth::polynomial(&mut |theta| g(theta), DEGREE, error).expect("finite")
}

/// The error may be ε Tₙ(2θ − 1), whose slope at the end is 2 n² ε (Markov's inequality is sharp
/// there).
#[test]
fn an_error_has_the_slope_of_a_chebyshev_polynomial() {
    for error in [1e-9, 1e-3] {
        let zero = fitted(|_| 0.0, error);
        let [(value, apart), (slope, turns)] = [zero.value([1.0; 2]), zero.slope([1.0; 2])];
        assert_eq!((value, slope), (0.0, 0.0));
        assert!(apart >= error && turns >= 2.0 * (DEGREE * DEGREE) as f64 * error, "{apart} {turns}");
    }
}

/// θ³ − θ with its slope 3θ² − 1 at 21 places of each piece.
#[test]
fn no_value_and_no_slope_is_beyond_its_bounds() {
    let (cubic, slope) = (|x: f64| x * x * x - x, |x: f64| 3.0 * x * x - 1.0);
    let smooth = fitted(cubic, 0.0);
    for (start, end) in [(0.0, 1.0), (0.25, 0.5), (0.5, 1.0), (0.875, 0.9)] {
        let [(value, apart), (rate, turns)] = [smooth.value([start, end]), smooth.slope([start, end])];
        let middle = 0.5 * (start + end);
        // Coefficients of the fit are rounded, their slopes by n² of that.
        assert!((value - cubic(middle)).abs() < 1e-14 && (rate - slope(middle)).abs() < 1e-12);
        for k in 0..=20 {
            let x = start + (end - start) * f64::from(k) / 20.0;
            assert!((cubic(x) - value).abs() <= apart && (slope(x) - rate).abs() <= turns, "{x}");
        }
        // Sums of Chebyshev coefficients: 1/8 + 3/2 + 3/8 = 2 of the slope, 3 + 3 of the curvature.
        assert!(apart <= end - start + 1e-14 && turns <= 3.0 * (end - start) + 1e-12, "{apart} {turns}");
    }
}

/// 3θ + 1 changes by its error to both sides over 2 ε/3; what is zero does so over no part of the
/// step.
#[test]
fn the_resolution_is_where_the_error_is_reached() {
    let line = fitted(|theta| 3.0 * theta + 1.0, 1e-6);
    let (_, error) = line.value([0.5; 2]);
    assert!((line.resolution() / (2.0 * error / 3.0) - 1.0).abs() < 1e-12);
    assert_eq!(fitted(|_| 0.0, 1e-6).resolution(), 1.0);
}
