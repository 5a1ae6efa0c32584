//! Order conditions and observed orders.

use super::coefficients::*;
use super::{SLOPES, Tsitouras};
use crate::integrate::Dense;
use crate::integrate::combination::Weight;
use crate::integrate::explicit::{Pair, Trial};
use crate::integrate::tests::fields::{distance, kepler, orbit};
use crate::integrate::tests::orders::step_orders;

type Vector = [f64; SLOPES];

fn dense_row(row: &[Weight]) -> Vector {
    let mut full = [0.0; SLOPES];
    for &(j, a) in row {
        full[j] = a;
    }
    full
}

fn tableau() -> [Vector; SLOPES] {
    let none = [0.0; SLOPES];
    let [a2, a3, a4, a5, a6] = A.map(dense_row);
    [none, a2, a3, a4, a5, a6, dense_row(B)]
}

fn dot(a: &Vector, b: &Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The trees up to order 5, Φ of each with its order ρ and density γ: Σ bᵢ Φᵢ = θ^ρ/γ (Hairer,
/// Nørsett, Wanner I, table II.2.2).
fn trees() -> Vec<(Vector, i32, f64)> {
    let table = tableau();
    let a = |x: &Vector| table.map(|row| dot(&row, x));
    let times = |x: &Vector, y: &Vector| core::array::from_fn(|i| x[i] * y[i]);
    let one = [1.0; SLOPES];
    let c = a(&one);
    let (c2, ac) = (times(&c, &c), a(&c));
    let (c3, cac, ac2, aac) = (times(&c2, &c), times(&c, &ac), a(&c2), a(&ac));
    vec![
        (one, 1, 1.0),
        (c, 2, 2.0),
        (c2, 3, 3.0),
        (ac, 3, 6.0),
        (c3, 4, 4.0),
        (cac, 4, 8.0),
        (ac2, 4, 12.0),
        (aac, 4, 24.0),
        (times(&c2, &c2), 5, 5.0),
        (times(&c2, &ac), 5, 10.0),
        (times(&ac, &ac), 5, 20.0),
        (times(&c, &ac2), 5, 15.0),
        (times(&c, &aac), 5, 30.0),
        (a(&c3), 5, 20.0),
        (a(&cac), 5, 40.0),
        (a(&ac2), 5, 60.0),
        (a(&aac), 5, 120.0),
    ]
}

/// Coefficients up to 50 with 16 published digits, in products of three: 1e-12.
#[test]
fn coefficients_satisfy_the_order_conditions() {
    let c: Vector = tableau().map(|row| row.iter().sum());
    assert!(distance(c, [0.0, 0.161, 0.327, 0.9, 0.980_025_540_904_509_7, 1.0, 1.0]) < 1e-13);
    for (phi, order, density) in trees() {
        let rest = dot(&dense_row(B), &phi) - 1.0 / density;
        assert!(rest.abs() < 1e-12, "order {order}, γ = {density}: {rest:e}");
        let error = dot(&dense_row(ERROR), &phi);
        assert_eq!(error.abs() < 1e-12, order <= 4, "error, order {order}, γ = {density}: {error:e}");
    }
}

/// The same of the dense output at θ, to order 4.
#[test]
fn dense_output_satisfies_the_order_conditions() {
    let unit = |j: usize| core::array::from_fn::<f64, SLOPES, _>(|i| f64::from(u8::from(i == j)));
    // With f = 0 but for the weight of one slope, y(θ) is that weight's bᵢ(θ); a step of length 1
    // from 0.
    let slopes = core::array::from_fn(unit);
    let step = Trial { y1: dense_row(B), slopes };
    let mut weights = Dense::with_room(5);
    weights.set_alternating([0.0, 1.0], step.y1, Tsitouras::dense(&|y| *y, 1.0, &[0.0; SLOPES], &step));
    for theta in [0.1, 0.25, 0.5, 0.8] {
        for (phi, order, density) in trees().iter().filter(|(_, order, _)| *order <= 4) {
            let rest = dot(&weights.interpolate(theta), phi) - theta.powi(*order) / density;
            assert!(rest.abs() < 1e-12, "θ = {theta}, order {order}, γ = {density}: {rest:e}");
        }
    }
}

/// One step of length `h` from the orbit at time 3.
fn single(h: f64) -> Dense<f64, 4> {
    let y0 = orbit(3.0);
    let mut made = Tsitouras::trial(&kepler, &y0, kepler(&y0), h);
    made.slopes[SLOPES - 1] = kepler(&made.y1);
    let mut step = Dense::with_room(5);
    step.set_alternating([3.0, 3.0 + h], made.y1, Tsitouras::dense(&kepler, h, &y0, &made));
    step
}

/// A global error of order p shows as p + 1 in one step; 0.2 for the next term of the expansion.
#[test]
fn observed_orders() {
    let [p, q] = step_orders(single, 0.05);
    assert!(p > 5.8, "step: {p}");
    assert!(q > 4.8, "dense output: {q}");
}
