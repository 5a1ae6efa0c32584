//! How rates respond to the impulses of the contact that strikes, M⁻¹ J_Nᵀ and M⁻¹ J_tᵀ per unit,
//! and what the other contacts see of it.

use nalgebra::DVector;
use smallvec::smallvec;

use super::cholesky::Cholesky;
use super::sum::{ROUNDING, Sum};
use super::{ReducedCollision, Striking};
use crate::contact::friction::impact::path::{Path, RouthContact, Vertex};
use crate::contact::impulse::{Row, is_open};
use crate::context::Numbers;

pub(super) struct Response<'a, M, J> {
    struck: &'a ReducedCollision<'a, M, J>,
    striking: &'a Striking,
    by_normal: Numbers,
    by_tangent: Numbers,
}

impl<'a, M: Fn(usize, usize) -> f64, J: Fn(usize, usize) -> f64> Response<'a, M, J> {
    /// None where M is nearly singular.
    pub(super) fn compute(struck: &'a ReducedCollision<'a, M, J>, striking: &'a Striking) -> Option<Self> {
        let n = struck.rates.len();
        let factor = Cholesky::factorise(&struck.mass, n)?;
        let along = |row: usize| factor.solution((0..n).map(|j| (struck.jacobian)(row, j)));
        let by_tangent = striking.friction.map_or_else(|| smallvec![0.0; n], |(row, _)| along(row));
        Some(Self { struck, striking, by_normal: along(striking.row), by_tangent })
    }

    /// The contact with its W; none where its tangent is zero but for rounding.
    pub(super) fn striker(&self) -> Option<RouthContact<f64>> {
        let Striking { row, restitution: e, law, friction } = *self.striking;
        let w_nn = self.struck.along(row, &self.by_normal).value;
        let Some((tangent, mu)) = friction else {
            return Some(RouthContact { w_nn, w_nt: 0.0, w_tt: 0.0, mu: 0.0, e, law });
        };
        let w_nt = self.struck.along(tangent, &self.by_normal).value;
        let w_tt = self.struck.along(tangent, &self.by_tangent).clear().filter(|w_tt| *w_tt != 0.0)?;
        Some(RouthContact { w_nn, w_nt, w_tt, mu, e, law })
    }

    /// Rates and impulses at a point of the path.
    pub(super) fn after(&self, point: &Vertex<f64>) -> (DVector<f64>, DVector<f64>) {
        let Self { struck, striking, by_normal, by_tangent } = self;
        let mut impulses = DVector::zeros(struck.rows.len());
        impulses[striking.row] = point.impulse;
        striking.friction.inspect(|(tangent, _)| impulses[*tangent] = point.friction);
        let change = |i: usize| by_normal[i] * point.impulse + by_tangent[i] * point.friction;
        (DVector::from_fn(struck.rates.len(), |i, _| struck.rates[i] + change(i)), impulses)
    }

    /// ġ⁺ of all contacts and v⁺ at them, none of which but the one that strikes may be pressed at
    /// any point of the path.
    pub(super) fn opening(&self, path: &Path<f64>) -> Option<DVector<f64>> {
        let Striking { row: own, friction, .. } = *self.striking;
        let rows = self.struck.rows;
        let mut opening = DVector::zeros(rows.len());
        let end = path.vertices.last()?;
        for row in (0..rows.len()).filter(|&row| row != own && !is_open(rows, &rows[row])) {
            opening[row] = match rows[row] {
                Row::Contact { .. } => self.unpressed(row, path)?,
                _ => Sum::from_terms(&self.terms(row, self.struck.speed(row), end)).known(),
            };
        }
        opening[own] = end.normal;
        friction.inspect(|(tangent, _)| opening[*tangent] = end.slip);
        Some(opening)
    }

    /// ġ⁺ of a contact that is clear and at no point of the path below zero.
    fn unpressed(&self, row: usize, path: &Path<f64>) -> Option<f64> {
        let before = self.struck.speed(row);
        let before = Sum { value: before.clear()?, ..before };
        let mut last = before;
        for point in &path.vertices {
            let terms = self.terms(row, before, point);
            last = Sum::from_terms(&terms);
            let size: f64 = terms.iter().map(|it| it.value.abs()).sum();
            if last.value < -ROUNDING * size {
                return None;
            }
        }
        last.clear()
    }

    /// What ġ of a row is summed from at a point of the path.
    fn terms(&self, row: usize, before: Sum, point: &Vertex<f64>) -> [Sum; 3] {
        let [normal, tangent] =
            [&self.by_normal, &self.by_tangent].map(|change| self.struck.along(row, change));
        [before, normal.times(point.impulse), tangent.times(point.friction)]
    }
}
