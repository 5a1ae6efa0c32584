//! The impact of a single smooth contact, where the three laws agree:
//!
//! ```text
//! ġ⁺ = −e ġ⁻,    P = −(1 + e) ġ⁻ / W,    u⁺ = u⁻ + M⁻¹ Jᵀ P,    W = J M⁻¹ Jᵀ
//! ```
//!
//! What is not clear by much is left to the search of `impact`.

use nalgebra::{Cholesky, DVector};

use super::impulse::{Collision, Method, Outcome, Row};
use crate::model::Law;

/// Speeds, pivots of M and W count as nonzero above this part of the terms that they are summed from.
const CLEAR: f64 = 1e-9;

impl Collision {
    /// The outcome, if this is such an impact.
    pub(super) fn of_single(&self) -> Option<Outcome> {
        let (row, restitution, law) = self.single()?;
        let jacobian = self.jacobian.row(row).transpose();
        let terms = || jacobian.iter().zip(&self.rates).map(|(entry, rate)| entry * rate);
        let approach = terms().sum::<f64>() + self.drift[row];
        let size = terms().map(f64::abs).sum::<f64>() + self.drift[row].abs();
        let factor = Cholesky::new(self.mass.clone())?;
        let pivots = factor.l_dirty().diagonal().map(|pivot| pivot * pivot);
        let is_regular = pivots.iter().zip(self.mass.diagonal().iter()).all(|(pivot, m)| *pivot > CLEAR * m);
        if !(is_regular && approach < -CLEAR * size) {
            return None;
        }
        let change = factor.solve(&jacobian);
        let delassus = jacobian.dot(&change);
        let compression = -approach / delassus;
        let after = |impulse: f64| -> (DVector<f64>, DVector<f64>) {
            let mut impulses = DVector::zeros(self.rows.len());
            impulses[row] = impulse;
            (&self.rates + &change * impulse, impulses)
        };
        let (rates, impulses) = after((1.0 + restitution) * compression);
        let finite = impulses[row].is_finite() && rates.iter().all(|rate| rate.is_finite());
        let mut openings = DVector::zeros(self.rows.len());
        openings[row] = -restitution * approach;
        finite.then(|| Outcome {
            gained: 0.5 * impulses[row] * (openings[row] + approach),
            rates,
            impulses,
            opening: openings,
            acting: vec![row],
            law,
            compression: (law != Law::Newton).then(|| after(compression)),
            factor: 1.0,
            unique: true,
            method: Method::AtOnce,
            solutions: 1,
        })
    }

    /// The only row that takes part, without what is applied from outside, its restitution and law.
    fn single(&self) -> Option<(usize, f64, Law)> {
        let mut acting = self.rows.iter().enumerate().filter(|(_, row)| !self.is_open(row));
        let (row, restitution, law) = match acting.next()? {
            (row, Row::Contact { restitution, law }) => (row, *restitution, *law),
            _ => return None,
        };
        (acting.next().is_none() && self.applied.amax() == 0.0).then_some((row, restitution, law))
    }
}

#[cfg(test)]
mod tests;
