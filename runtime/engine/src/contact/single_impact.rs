//! The impact of a single smooth contact, where the three laws agree:
//!
//! ```text
//! ġ⁺ = −e ġ⁻,    P = −(1 + e) ġ⁻ / W,    u⁺ = u⁻ + M⁻¹ Jᵀ P,    W = J M⁻¹ Jᵀ
//! ```
//!
//! What is not clear by much is left to the search of `impact`.

use nalgebra::DVector;
use smallvec::smallvec;

use super::impulse::{Collision, Method, Outcome, Row, is_open};
use crate::integration::phase_point::Numbers;
use crate::model::Law;

/// Speeds, pivots of M and W count as nonzero above this part of the terms that they are summed from.
const CLEAR: f64 = 1e-9;

/// The only contact that takes part in a collision.
pub(crate) struct SingleContact {
    row: usize,
    restitution: f64,
    law: Law,
    /// How many rows there are.
    rows: usize,
}

impl SingleContact {
    /// If it is all that does.
    pub(crate) fn of(rows: &[Row]) -> Option<Self> {
        let mut acting = rows.iter().enumerate().filter(|(_, row)| !is_open(rows, row));
        let (row, restitution, law) = match acting.next()? {
            (row, Row::Contact { restitution, law }) => (row, *restitution, *law),
            _ => return None,
        };
        acting.next().is_none().then_some(Self { row, restitution, law, rows: rows.len() })
    }

    pub(crate) fn row(&self) -> usize {
        self.row
    }

    /// The outcome for M, the row of J, ∂g/∂t and u⁻, if it is clear; nothing is applied from outside.
    pub(crate) fn outcome(
        &self,
        mass: impl Fn(usize, usize) -> f64,
        (jacobian, drift): (&[f64], f64),
        rates: &[f64],
    ) -> Option<Outcome> {
        let &Self { row, restitution, law, rows } = self;
        let terms = || jacobian.iter().zip(rates).map(|(entry, rate)| entry * rate);
        let approach = terms().sum::<f64>() + drift;
        let size = terms().map(f64::abs).sum::<f64>() + drift.abs();
        let is_clear = approach < -CLEAR * size;
        let change = if is_clear { solution(mass, jacobian)? } else { return None };
        let delassus: f64 = jacobian.iter().zip(&change).map(|(entry, u)| entry * u).sum();
        let compression = -approach / delassus;
        let alone = |value: f64| DVector::from_fn(rows, |i, _| if i == row { value } else { 0.0 });
        let after = |impulse: f64| {
            (DVector::from_fn(rates.len(), |i, _| rates[i] + change[i] * impulse), alone(impulse))
        };
        let impulse = (1.0 + restitution) * compression;
        let (rates, impulses) = after(impulse);
        let finite = impulse.is_finite() && rates.iter().all(|rate| rate.is_finite());
        let opening = -restitution * approach;
        finite.then(|| Outcome {
            gained: 0.5 * impulse * (opening + approach),
            rates,
            impulses,
            opening: alone(opening),
            acting: vec![row],
            law,
            compression: (law != Law::Newton).then(|| after(compression)),
            factor: 1.0,
            unique: true,
            method: Method::AtOnce,
            solutions: 1,
        })
    }
}

impl Collision {
    /// The outcome, if this is such an impact.
    pub(super) fn of_single(&self) -> Option<Outcome> {
        let single = SingleContact::of(&self.rows).filter(|_| self.applied.amax() == 0.0)?;
        let jacobian: Numbers = self.jacobian.row(single.row).iter().copied().collect();
        let drift = self.drift[single.row];
        single.outcome(|i, j| self.mass[(i, j)], (&jacobian, drift), self.rates.as_slice())
    }
}

/// M⁻¹ b with M = L Lᵀ; none where a pivot is not clear.
fn solution(mass: impl Fn(usize, usize) -> f64, b: &[f64]) -> Option<Numbers> {
    let n = b.len();
    let (mut factor, mut x): (Numbers, Numbers) = (smallvec![0.0; n * n], Numbers::from_slice(b));
    let less = |value: f64, one: &[f64], other: &[f64]| {
        one.iter().zip(other).fold(value, |rest, (a, b)| rest - a * b)
    };
    for i in 0..n {
        let (above, own) = factor.split_at_mut(i * n);
        for k in 0..i {
            let row = &above[k * n..][..=k];
            own[k] = less(mass(i, k), &own[..k], &row[..k]) / row[k];
        }
        let pivot = less(mass(i, i), &own[..i], &own[..i]);
        if pivot.is_nan() || pivot <= CLEAR * mass(i, i) {
            return None;
        }
        own[i] = pivot.sqrt();
        x[i] = less(x[i], &own[..i], &x[..i]) / own[i];
    }
    for i in (0..n).rev() {
        let row = &factor[i * n..][..=i];
        x[i] /= row[i];
        for k in 0..i {
            x[k] -= row[k] * x[i];
        }
    }
    Some(x)
}

#[cfg(test)]
mod tests;
