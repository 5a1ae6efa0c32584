//! Order conditions and observed orders.

use super::super::coefficients::*;
use super::super::{DormandPrince, SLOPES, dense};
use crate::integrate::Dense;
use crate::integrate::combination::Weight;
use crate::integrate::explicit::Pair;
use crate::integrate::tests::fields::{distance, kepler, orbit};
use crate::integrate::tests::orders::{largest, order, step_orders};

fn row_sum(row: &[Weight], weight: impl Fn(usize) -> f64) -> f64 {
    row.iter().map(|&(j, a)| a * weight(j)).sum()
}

fn abscissae() -> [f64; 16] {
    let one = |_| 1.0;
    let mut c = [0.0; 16];
    let rows = A.into_iter().chain([B]).chain(A_DENSE);
    for (c, row) in c[1..].iter_mut().zip(rows) {
        *c = row_sum(row, one);
    }
    c
}

/// Rounding of coefficients up to 50 in sums of up to ten: 1e-13.
#[test]
fn coefficients_satisfy_the_order_conditions() {
    let c = abscissae();
    let root = 6f64.sqrt();
    let published = [
        0.0,
        (12.0 - 2.0 * root) / 135.0,
        (6.0 - root) / 45.0,
        (6.0 - root) / 30.0,
        (6.0 + root) / 30.0,
        1.0 / 3.0,
        0.25,
        4.0 / 13.0,
        127.0 / 195.0,
        0.6,
        6.0 / 7.0,
        1.0,
        1.0,
        0.1,
        0.2,
        7.0 / 9.0,
    ];
    assert!(distance(c, published) < 1e-13);
    for k in 0..8 {
        let moment = row_sum(B, |j| c[j].powi(k));
        assert!((moment * f64::from(k + 1) - 1.0).abs() < 1e-13, "b, k = {k}");
    }
    for k in 0..5 {
        assert!(row_sum(ERROR5, |j| c[j].powi(k)).abs() < 1e-13, "e5, k = {k}");
    }
    for k in 0..3 {
        let moment = row_sum(THIRD, |j| c[j].powi(k));
        assert!((moment * f64::from(k + 1) - 1.0).abs() < 1e-13, "e3, k = {k}");
    }
}

/// One step of length `h` from the orbit at time `t`.
fn single(t: f64, h: f64) -> Dense<f64, 4> {
    let y0 = orbit(t);
    let mut made = DormandPrince::trial(&kepler, &y0, kepler(&y0), h);
    made.slopes[SLOPES - 1] = kepler(&made.y1);
    let mut step = Dense::with_room(8);
    step.set_alternating([t, t + h], made.y1, dense::coefficients(&kepler, h, &y0, &made));
    step
}

/// A global error of order p shows as p + 1 in one step; 0.2 for the next term of the expansion.
#[test]
fn observed_orders() {
    let rate = |h: f64| {
        let step = single(3.0, h);
        largest(|theta| distance(step.rate(theta), kepler(&orbit(3.0 + theta * h))))
    };
    let ([p, q], r) = (step_orders(|h| single(3.0, h), 0.2), order(rate, 0.2));
    assert!(p > 8.8, "step: {p}");
    assert!(q > 7.8, "dense output: {q}");
    assert!(r > 6.8, "its derivative: {r}");
}
