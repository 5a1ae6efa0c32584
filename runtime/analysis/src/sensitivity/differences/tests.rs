use super::{Differences, NO_SLOPE};

/// The slope at `x` of a function of one variable, if it has one.
fn slope(x: f64, f: impl Fn(f64) -> Option<f64>) -> Result<f64, String> {
    let at = |x: f64| f(x).map(|y| vec![y, 1.0]).ok_or_else(|| "nothing there".to_owned());
    let state = at(x)?;
    let of = |by: f64| at(x + by);
    Ok(Differences { of, state: &state, units: vec![1.0; 2], unit: 1.0 }.slopes()?[0])
}

#[track_caller]
fn assert_slope(x: f64, f: impl Fn(f64) -> Option<f64>, exact: f64, within: f64) {
    let found = slope(x, f).unwrap();
    assert!((found - exact).abs() <= within * exact.abs(), "{found} for {exact}");
}

/// x² + y² = 1 beside y = 0, where the slope is infinite.
#[test]
fn beside_a_dead_centre_steps_are_shorter() {
    for x in [0.3, 0.99, 0.9999, 0.99999, 0.999_999] {
        let y = |x: f64| (x <= 1.0).then(|| (1.0 - x * x).sqrt());
        assert_slope(x, y, -x / (1.0 - x * x).sqrt(), 1e-7);
    }
}

/// x¹⁰ and a maximum in between: |x − 1| at distances down to 1e-6 of its kink.
#[test]
fn beside_a_kink_steps_are_shorter() {
    for beside in [1e-2, 1e-4, 1e-6, -1e-4] {
        let x = 1.0 + beside;
        assert_slope(x, |x| Some((x - 1.0).abs() + x.powi(10)), beside.signum() + 10.0 * x.powi(9), 1e-7);
    }
}

#[test]
fn at_a_kink_there_is_none() {
    assert_eq!(slope(1.0, |x| Some((x - 1.0).abs())), Err(NO_SLOPE.to_owned()));
    assert_eq!(slope(1.0, |x| Some((x - 1.0).max(0.0) + x)), Err(NO_SLOPE.to_owned()));
}

/// Where there is nothing on one side there is a slope to the other.
#[test]
fn at_an_end_the_slope_is_that_of_one_side() {
    assert_slope(0.0, |x| (x >= 0.0).then(|| x.exp()), 1.0, 1e-9);
    assert_slope(0.0, |x| (x <= 0.0).then(|| (2.0 * x).exp()), 2.0, 1e-9);
    assert_eq!(slope(0.0, |x| (x >= 0.0).then(|| x.sqrt())), Err(NO_SLOPE.to_owned()));
}

#[test]
fn what_does_not_depend_has_none_and_a_minimum_has_the_slope_zero() {
    assert_eq!(slope(1.0, |_| Some(3.0)), Ok(0.0));
    assert!(slope(0.0, |x| Some(x * x)).unwrap().abs() < 1e-9);
    assert_eq!(slope(0.0, |x| (x == 0.0).then_some(1.0)), Err("nothing there".to_owned()));
}
