//! Quadrature, roots and the complete elliptic integral for the closed forms.

use std::f64::consts::PI;

const NODES: usize = 24;
const PANELS: usize = 8;

/// ∫ f over [from, to] by Gauss–Legendre, 8 panels of 24 nodes: exact to rounding where f is
/// analytic with no singularity nearer than a panel's half width.
pub fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let half = (to - from) / (2 * PANELS) as f64;
    let rule = gauss_legendre();
    let panel = |index: usize| {
        let centre = from + half * (2 * index + 1) as f64;
        rule.iter().map(|&(x, weight)| weight * f(centre + half * x)).sum::<f64>()
    };
    half * (0..PANELS).map(panel).sum::<f64>()
}

/// Nodes and weights on [−1, 1]: zeros of the Legendre polynomial by Newton from cos(π(i − ¼)/(n +
/// ½)).
fn gauss_legendre() -> Vec<(f64, f64)> {
    let node = |index: usize| {
        let mut x = (PI * (index as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
        for _ in 0..8 {
            let (value, slope) = legendre(x);
            x -= value / slope;
        }
        let slope = legendre(x).1;
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..NODES).map(node).collect()
}

/// P_n and P_n′ by the three-term recurrence.
fn legendre(x: f64) -> (f64, f64) {
    let (mut last, mut value) = (1.0, x);
    for k in 2..=NODES {
        let k = k as f64;
        (last, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * last) / k);
    }
    (value, NODES as f64 * (x * value - last) / (x * x - 1.0))
}

/// Root of f between two points of opposite sign, by bisection to the last bit. `None` without a
/// change of sign.
pub fn root(f: impl Fn(f64) -> f64, from: f64, to: f64) -> Option<f64> {
    let (mut low, mut high) = (from, to);
    let sign = f(low).signum();
    if sign == f(high).signum() {
        return None;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle == low || middle == high {
            return Some(middle);
        }
        if f(middle).signum() == sign { low = middle } else { high = middle }
    }
}

/// K(m), m = k²: π / (2 agm(1, √(1 − m))).
pub fn elliptic_k(m: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    while (a - b).abs() > 1e-15 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (a + b)
}

/// One step of the classical Runge–Kutta method for y′ = f(y).
pub fn runge_kutta<const N: usize>(f: impl Fn(&[f64; N]) -> [f64; N], y: &[f64; N], step: f64) -> [f64; N] {
    let plus = |k: &[f64; N], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
    let k1 = f(y);
    let k2 = f(&plus(&k1, 0.5 * step));
    let k3 = f(&plus(&k2, 0.5 * step));
    let k4 = f(&plus(&k3, step));
    std::array::from_fn(|i| y[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
}

/// One step of the Gragg–Bulirsch–Stoer method for y′ = f(y): the modified midpoint rule with 2, 4,
/// … 12 parts, extrapolated in the square of a part (Hairer, Nørsett & Wanner, Solving Ordinary
/// Differential Equations I, II.9).
pub fn extrapolated<const N: usize>(f: impl Fn(&[f64; N]) -> [f64; N], y: &[f64; N], step: f64) -> [f64; N] {
    let mut last: Vec<[f64; N]> = Vec::new();
    for j in 1..=6 {
        let mut row = vec![midpoint(&f, y, step, 2 * j)];
        for k in 1..j {
            let factor = (j as f64 / (j - k) as f64).powi(2) - 1.0;
            let (finer, coarser) = (row[k - 1], last[k - 1]);
            row.push(std::array::from_fn(|i| finer[i] + (finer[i] - coarser[i]) / factor));
        }
        last = row;
    }
    last[5]
}

/// The modified midpoint rule with its smoothing step.
fn midpoint<const N: usize>(
    f: &impl Fn(&[f64; N]) -> [f64; N],
    y: &[f64; N],
    step: f64,
    parts: usize,
) -> [f64; N] {
    let h = step / parts as f64;
    let plus = |y: &[f64; N], h: f64, k: [f64; N]| -> [f64; N] { std::array::from_fn(|i| y[i] + h * k[i]) };
    let (mut last, mut next) = (*y, plus(y, h, f(y)));
    for _ in 1..parts {
        (last, next) = (next, plus(&last, 2.0 * h, f(&next)));
    }
    let end = plus(&next, h, f(&next));
    std::array::from_fn(|i| 0.5 * (last[i] + end[i]))
}
