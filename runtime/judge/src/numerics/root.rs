//! The first point at which a polynomial falls below zero, from its Bernstein coefficients: between
//! the least and the greatest of them it lies.

use crate::tape::whole;
use liftoff_core::scalar::{Real, Scalar};

/// Below this of the largest coefficient a polynomial is zero.
const ROUNDING: f64 = 1e-26;
const DEPTH: usize = 90;

/// Σ cₖ sᵏ.
pub(crate) fn value<S: Scalar>(coefficients: &[S], s: S) -> S {
    coefficients.iter().rev().fold(S::ZERO, |sum, &c| sum * s + c)
}

/// A dip shallower than this, with the polynomial well above zero behind it, is a touch: a start in
/// doubles says no more.
const SHALLOW: f64 = 1e-14;
/// Well above zero.
const CLEAR: f64 = 1e-9;

/// The first root in [0, h] at which Σ cₖ sᵏ goes below zero; a touch is none.
pub(crate) fn first<S: Scalar>(coefficients: &[S], h: S) -> Option<S> {
    let mut scale = whole::<S>(1);
    let mut scaled = Vec::new();
    for &c in coefficients {
        scaled.push(c * scale);
        scale = scale * h;
    }
    let size = scaled.iter().map(|c| c.abs().to_f64()).fold(0.0, f64::max);
    let rest: f64 = scaled.iter().skip(1).map(|c| c.abs().to_f64()).sum();
    if scaled.is_empty() || scaled[0].to_f64() > rest || size == 0.0 {
        return None;
    }
    let rounding = ROUNDING.max(64.0 * S::EPSILON.to_f64()) * size;
    let b = bernstein(&scaled);
    let found = below(&b, S::ZERO, whole(1), rounding, DEPTH)?;
    let clear = b.last().is_some_and(|end| end.to_f64() > CLEAR * size);
    let touches = clear && below(&b, S::ZERO, whole(1), rounding.max(SHALLOW * size), DEPTH).is_none();
    (!touches).then(|| refined(&scaled, found) * h)
}

/// bⱼ = Σ C(j, k)/C(n, k) cₖ.
fn bernstein<S: Scalar>(c: &[S]) -> Vec<S> {
    let n = c.len() - 1;
    let weight = |j: usize, k: usize| {
        (0..k).fold(whole::<S>(1), |w, i| w * whole((j - i) as i64) / whole((n - i) as i64))
    };
    (0..=n).map(|j| (0..=j).fold(S::ZERO, |sum, k| sum + weight(j, k) * c[k])).collect()
}

fn below<S: Scalar>(b: &[S], from: S, width: S, rounding: f64, depth: usize) -> Option<S> {
    if b.iter().all(|x| x.to_f64() >= -rounding) {
        return None;
    }
    if depth == 0 || b[0].to_f64() < -rounding {
        return Some(from);
    }
    let (left, right) = halves(b);
    let half = width * S::ratio(1, 2);
    below(&left, from, half, rounding, depth - 1)
        .or_else(|| below(&right, from + half, half, rounding, depth - 1))
}

fn halves<S: Scalar>(b: &[S]) -> (Vec<S>, Vec<S>) {
    let half = <S as Real>::ratio(1, 2);
    let mut row = b.to_vec();
    let (mut left, mut right) = (Vec::new(), Vec::new());
    while let (Some(&first), Some(&last)) = (row.first(), row.last()) {
        left.push(first);
        right.push(last);
        row = row.windows(2).map(|pair| (pair[0] + pair[1]) * half).collect();
    }
    right.reverse();
    (left, right)
}

/// A few steps of Newton's method, as long as they are small.
fn refined<S: Scalar>(c: &[S], mut x: S) -> S {
    let slope: Vec<S> = c.iter().enumerate().skip(1).map(|(k, &c)| whole::<S>(k as i64) * c).collect();
    for _ in 0..4 {
        let change = value(c, x) / value(&slope, x);
        if change.to_f64().is_nan() || change.abs().to_f64() > 1e-6 {
            break;
        }
        x = x - change;
    }
    if x < S::ZERO { S::ZERO } else { x }
}
