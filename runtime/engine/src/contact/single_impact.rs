//! The impact of a single contact, on others that it does not press: along Routh's path of [`friction`](super::friction), with
//!
//! ```text
//! W = J M⁻¹ Jᵀ of the normal and the tangent,    u⁺ = u⁻ + M⁻¹ (J_Nᵀ P + J_tᵀ P_t)
//! ```
//!
//! Without friction the three laws agree, ġ⁺ = −e ġ⁻ and P = −(1 + e) ġ⁻ / W. What is not clear by much is left to the search of
//! `impact`.

use nalgebra::DVector;
use smallvec::smallvec;

use super::impulse::{Collision, Method, Outcome, Path, Row, Striker, Vertex, is_open};
use crate::integration::phase_point::Numbers;
use crate::model::Law;

/// Speeds, pivots of M and W count as nonzero above this part of the terms that they are summed from.
const CLEAR: f64 = 1e-9;
/// Speeds count as zero up to this part of their terms.
const ROUNDING: f64 = 1e-12;

/// A collision whose joints and held supports, if there are any, are in its coordinates; nothing is applied from outside.
pub(crate) struct Struck<'a, M, J> {
    /// What the rows are.
    pub(crate) rows: &'a [Row],
    /// M, entry by entry.
    pub(crate) mass: M,
    /// J, row and column.
    pub(crate) jacobian: J,
    /// ∂g/∂t.
    pub(crate) drift: &'a [f64],
    /// u⁻.
    pub(crate) rates: &'a [f64],
}

/// The contact that strikes.
struct Striking {
    row: usize,
    restitution: f64,
    law: Law,
    /// Its tangent, and μ.
    friction: Option<(usize, f64)>,
}

/// A sum of products, and that of their sizes.
#[derive(Clone, Copy)]
struct Sum {
    value: f64,
    size: f64,
}

impl<M: Fn(usize, usize) -> f64, J: Fn(usize, usize) -> f64> Struck<'_, M, J> {
    /// The outcome, if it is such an impact and clear.
    pub(crate) fn outcome(&self) -> Option<Outcome> {
        let Striking { row, restitution, law, friction } = self.striking()?;
        let factor = Factor::of(&self.mass, self.rates.len())?;
        let along = |row: usize| factor.solution((0..self.rates.len()).map(|j| (self.jacobian)(row, j)));
        let by_normal = along(row);
        let by_tangent = friction.map_or_else(|| smallvec![0.0; self.rates.len()], |(row, _)| along(row));
        let of_tangent = |u: &[f64]| friction.map_or(Sum::ZERO, |(row, _)| self.along(row, u));
        let (w_nn, w_nt, w_tt) =
            (self.along(row, &by_normal).value, of_tangent(&by_normal).value, of_tangent(&by_tangent));
        let slip = friction.map_or(0.0, |(row, _)| self.speed(row).known());
        let approach = self.speed(row).value;
        if friction.is_some() && w_tt.clear()? == 0.0 {
            return None;
        }
        let mu = friction.map_or(0.0, |(_, mu)| mu);
        let striker = Striker { w_nn, w_nt, w_tt: w_tt.value, mu, e: restitution, law };
        let path = striker.path(approach, slip)?;
        let end = path.vertices.last()?;
        let after = |point: &Vertex<f64>| self.after((row, friction), (&by_normal, &by_tangent), point);
        let (rates, impulses) = after(end);
        let mut opening = self.opening_of_others(row, (&by_normal, &by_tangent), &path)?;
        opening[row] = end.normal;
        friction.inspect(|(tangent, _)| opening[*tangent] = end.slip);
        let finite = end.impulse.is_finite() && rates.iter().all(|rate| rate.is_finite());
        finite.then(|| Outcome {
            gained: 0.5 * (end.impulse * (end.normal + approach) + end.friction * (end.slip + slip)),
            rates,
            impulses,
            opening,
            acting: vec![row],
            law,
            compression: (law != Law::Newton).then(|| after(&path.vertices[path.compressed])),
            factor: 1.0,
            unique: true,
            method: if friction.is_some() { Method::Path } else { Method::AtOnce },
            solutions: 1,
        })
    }

    /// The only contact that approaches, where nothing holds both ways; without friction nothing may depart either.
    fn striking(&self) -> Option<Striking> {
        let mut found = None;
        let (mut departs, mut friction) = (false, None);
        for (row, part) in self.rows.iter().enumerate().filter(|(_, part)| !is_open(self.rows, part)) {
            match *part {
                Row::Contact { restitution, law } => match self.speed(row).clear()? {
                    speed if speed < 0.0 && found.is_some() => return None,
                    speed if speed < 0.0 => found = Some(Striking { row, restitution, law, friction: None }),
                    speed => departs |= speed > 0.0,
                },
                // Contacts come before their tangents.
                Row::Friction { of, mu, restitution } if found.as_ref().is_some_and(|it| it.row == of) => {
                    friction = (restitution == 0.0).then_some((row, mu));
                    friction?;
                }
                Row::Friction { .. } => {}
                Row::Open | Row::TwoSided | Row::Tangent { .. } | Row::Guide => return None,
            }
        }
        let striking = Striking { friction, ..found? };
        (friction.is_some() || !departs).then_some(striking)
    }

    /// ġ⁻ of a row.
    fn speed(&self, row: usize) -> Sum {
        let Sum { value, size } = self.along(row, self.rates);
        Sum { value: value + self.drift[row], size: size + self.drift[row].abs() }
    }

    /// J u of a row.
    fn along(&self, row: usize, u: &[f64]) -> Sum {
        let terms = u.iter().enumerate().map(|(j, u)| (self.jacobian)(row, j) * u);
        terms.fold(Sum::ZERO, |sum, term| Sum { value: sum.value + term, size: sum.size + term.abs() })
    }

    /// Rates and impulses at a point of the path.
    fn after(
        &self,
        (row, friction): (usize, Option<(usize, f64)>),
        (by_normal, by_tangent): (&[f64], &[f64]),
        point: &Vertex<f64>,
    ) -> (DVector<f64>, DVector<f64>) {
        let mut impulses = DVector::zeros(self.rows.len());
        impulses[row] = point.impulse;
        friction.inspect(|(tangent, _)| impulses[*tangent] = point.friction);
        let rate = |i: usize| self.rates[i] + by_normal[i] * point.impulse + by_tangent[i] * point.friction;
        (DVector::from_fn(self.rates.len(), |i, _| rate(i)), impulses)
    }

    /// ġ⁺ of the other contacts and v⁺ at them, none of which may be pressed at any point of the path.
    fn opening_of_others(
        &self,
        striking: usize,
        changes: (&[f64], &[f64]),
        path: &Path<f64>,
    ) -> Option<DVector<f64>> {
        let mut opening = DVector::zeros(self.rows.len());
        let end = path.vertices.last()?;
        let is_other = |row: usize| row != striking && !is_open(self.rows, &self.rows[row]);
        for row in (0..self.rows.len()).filter(|&row| is_other(row)) {
            let before = self.speed(row);
            if !matches!(self.rows[row], Row::Contact { .. }) {
                opening[row] = Sum::of(&self.terms(row, before, changes, end)).known();
                continue;
            }
            let before = Sum { value: before.clear()?, ..before };
            for point in &path.vertices {
                let terms = self.terms(row, before, changes, point);
                let size: f64 = terms.iter().map(|it| it.value.abs()).sum();
                if Sum::of(&terms).value < -ROUNDING * size {
                    return None;
                }
            }
            opening[row] = Sum::of(&self.terms(row, before, changes, end)).clear()?;
        }
        Some(opening)
    }

    /// What ġ of a row is summed from at a point of the path.
    fn terms(
        &self,
        row: usize,
        before: Sum,
        (by_normal, by_tangent): (&[f64], &[f64]),
        point: &Vertex<f64>,
    ) -> [Sum; 3] {
        let [normal, tangent] = [by_normal, by_tangent].map(|change| self.along(row, change));
        [before, normal.times(point.impulse), tangent.times(point.friction)]
    }
}

impl Sum {
    const ZERO: Self = Self { value: 0.0, size: 0.0 };

    fn of(terms: &[Self]) -> Self {
        let both = |sum: Self, it: &Self| Self { value: sum.value + it.value, size: sum.size + it.size };
        terms.iter().fold(Self::ZERO, both)
    }

    fn times(self, factor: f64) -> Self {
        Self { value: self.value * factor, size: self.size * factor.abs() }
    }

    /// Its value, zero where it is so but for rounding.
    fn known(self) -> f64 {
        if self.value.abs() <= ROUNDING * self.size { 0.0 } else { self.value }
    }

    /// The same, if it is zero or clearly not.
    fn clear(self) -> Option<f64> {
        Some(self.known()).filter(|value| *value == 0.0 || value.abs() > CLEAR * self.size)
    }
}

impl Collision {
    /// The outcome, if this is such an impact.
    pub(super) fn of_single(&self) -> Option<Outcome> {
        let Self { mass, jacobian, rates, drift, applied, rows } = self;
        let (mass, jacobian) = (|i, j| mass[(i, j)], |i, j| jacobian[(i, j)]);
        let struck = Struck { rows, mass, jacobian, drift: drift.as_slice(), rates: rates.as_slice() };
        (applied.amax() == 0.0).then(|| struck.outcome())?
    }
}

/// L of M = L Lᵀ, row by row.
struct Factor {
    n: usize,
    rows: Numbers,
}

impl Factor {
    /// None where a pivot is not clear.
    fn of(mass: impl Fn(usize, usize) -> f64, n: usize) -> Option<Self> {
        let mut rows: Numbers = smallvec![0.0; n * n];
        for i in 0..n {
            let (above, own) = rows.split_at_mut(i * n);
            for k in 0..i {
                let row = &above[k * n..][..=k];
                own[k] = less(mass(i, k), &own[..k], &row[..k]) / row[k];
            }
            let pivot = less(mass(i, i), &own[..i], &own[..i]);
            if pivot.is_nan() || pivot <= CLEAR * mass(i, i) {
                return None;
            }
            own[i] = pivot.sqrt();
        }
        Some(Self { n, rows })
    }

    /// M⁻¹ b.
    fn solution(&self, b: impl Iterator<Item = f64>) -> Numbers {
        let mut x: Numbers = b.collect();
        for i in 0..self.n {
            let row = &self.rows[i * self.n..][..=i];
            x[i] = less(x[i], &row[..i], &x[..i]) / row[i];
        }
        for i in (0..self.n).rev() {
            let row = &self.rows[i * self.n..][..=i];
            x[i] /= row[i];
            for k in 0..i {
                x[k] -= row[k] * x[i];
            }
        }
        x
    }
}

fn less(value: f64, one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).fold(value, |rest, (a, b)| rest - a * b)
}

#[cfg(test)]
mod tests;
