//! The impact of a single contact, on others that it does not press: along Routh's path of
//! [`friction`](super::friction), with
//!
//! ```text
//! W = J M⁻¹ Jᵀ of the normal and the tangent,    u⁺ = u⁻ + M⁻¹ (J_Nᵀ P + J_tᵀ P_t)
//! ```
//!
//! Without friction the three laws agree, ġ⁺ = −e ġ⁻ and P = −(1 + e) ġ⁻ / W. What is not clear by
//! much is left to the search of `impact`.

mod cholesky;
mod response;
mod sum;
#[cfg(test)]
mod tests;

use super::impulse::{Collision, ImpulseMethod, Outcome, Row, is_open};
use crate::model::Law;
use response::Response;
use sum::Sum;

/// A collision whose joints and held supports, if there are any, are in its coordinates; nothing is
/// applied from outside.
pub(crate) struct ReducedCollision<'a, M, J> {
    /// What the rows are.
    pub(crate) rows: &'a [Row],
    /// M, entry by entry.
    pub(crate) mass: M,
    /// J, row and column.
    pub(crate) jacobian: J,
    /// ∂g/∂t.
    pub(crate) prescribed_gap_rate: &'a [f64],
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

impl<M: Fn(usize, usize) -> f64, J: Fn(usize, usize) -> f64> ReducedCollision<'_, M, J> {
    /// The outcome, if it is such an impact and clear.
    pub(crate) fn outcome(&self) -> Option<Outcome> {
        let striking = self.striking()?;
        let Striking { row, law, friction, .. } = striking;
        let response = Response::compute(self, &striking)?;
        let approach = self.speed(row).value;
        let slip = friction.map_or(0.0, |(tangent, _)| self.speed(tangent).known());
        let path = response.striker()?.path(approach, slip)?;
        let end = path.vertices.last()?;
        let (rates, impulses) = response.after(end);
        let opening = response.opening(&path)?;
        let finite = end.impulse.is_finite() && rates.iter().all(|rate| rate.is_finite());
        finite.then(|| Outcome {
            gained: 0.5 * (end.impulse * (end.normal + approach) + end.friction * (end.slip + slip)),
            rates,
            impulses,
            opening,
            acting: vec![row],
            law,
            compression: law.has_phases().then(|| response.after(&path.vertices[path.compressed])),
            factor: 1.0,
            unique: true,
            method: if friction.is_some() { ImpulseMethod::Path } else { ImpulseMethod::AtOnce },
            solutions: 1,
            groups: Vec::new(),
        })
    }

    /// The only contact that approaches, where nothing holds both ways; without friction nothing
    /// may depart either.
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
                    let has_path =
                        restitution == 0.0 && found.as_ref().is_some_and(|it| it.law != Law::Moreau);
                    friction = has_path.then_some((row, mu));
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
        Sum { value: value + self.prescribed_gap_rate[row], size: size + self.prescribed_gap_rate[row].abs() }
    }

    /// J u of a row.
    fn along(&self, row: usize, u: &[f64]) -> Sum {
        let terms = u.iter().enumerate().map(|(j, u)| (self.jacobian)(row, j) * u);
        terms.fold(Sum::ZERO, |sum, term| Sum { value: sum.value + term, size: sum.size + term.abs() })
    }
}

impl Collision {
    /// The outcome, if this is such an impact.
    pub(super) fn of_single(&self) -> Option<Outcome> {
        let Self { mass, jacobian, rates, prescribed_gap_rate: drift, applied, rows } = self;
        let (mass, jacobian) = (|i, j| mass[(i, j)], |i, j| jacobian[(i, j)]);
        let struck = ReducedCollision {
            rows,
            mass,
            jacobian,
            prescribed_gap_rate: drift.as_slice(),
            rates: rates.as_slice(),
        };
        (applied.amax() == 0.0).then(|| struck.outcome())?
    }
}
