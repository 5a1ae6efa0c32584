//! A collision in plain numbers, and its outcome.
//!
//! ```text
//! M (u⁺ − u⁻) = I + Jᵀ P,    ġ = J u + ∂g/∂t
//! ```

use nalgebra::{DMatrix, DVector};
use thiserror::Error;

use crate::model::Law;
use crate::numerics::zero::SOLVED;

/// What a row of the Jacobian is during the collision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Row {
    /// It takes no part: an open contact.
    Open,
    /// It holds both ways: a joint, a loop, a drive, a held support.
    TwoSided,
    /// A one-sided contact with g = 0, at rest or not.
    Contact {
        /// e, between 0 and 1.
        restitution: f64,
        /// What e relates.
        law: Law,
    },
    /// It holds both ways while a contact acts: no slip.
    Tangent {
        /// The row of the contact.
        of: usize,
    },
    /// A guide with Coulomb friction: it holds both ways, and its tangent has a [`Row::Friction`].
    Guide,
    /// The tangent of a contact or guide with Coulomb friction; without effect while the contact
    /// takes no part or is held.
    Friction {
        /// The row of the contact.
        of: usize,
        /// μ.
        mu: f64,
        /// The part e_t of the slip velocity that a contact which would stick gives back, between 0
        /// and 1.
        restitution: f64,
    },
}

/// How the impulses were found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ImpulseMethod {
    /// By complementarity of all contacts at the end of each stage.
    AtOnce,
    /// Along Routh's path of a single contact with friction.
    Path,
}

/// A collision of `n` coordinates under `r` rows.
#[derive(Debug, Clone)]
pub struct Collision {
    /// M, n × n, symmetric, positive definite where the rows leave freedom.
    pub mass: DMatrix<f64>,
    /// J, r × n.
    pub jacobian: DMatrix<f64>,
    /// u⁻, n.
    pub rates: DVector<f64>,
    /// ∂g/∂t, r.
    pub prescribed_gap_rate: DVector<f64>,
    /// I, the generalised impulse applied from outside, n.
    pub applied: DVector<f64>,
    /// The rows' parts, r.
    pub rows: Vec<Row>,
}

/// The motion after a collision.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// u⁺.
    pub rates: DVector<f64>,
    /// P of every row.
    pub impulses: DVector<f64>,
    /// ġ⁺ of every row; exactly zero where it is zero but for rounding.
    pub opening: DVector<f64>,
    /// The contacts with P > 0.
    pub acting: Vec<usize>,
    /// The law that was applied to all contacts; of several groups that of the first.
    pub law: Law,
    /// u and P after the compression alone, under Poisson's law; of several groups in their own
    /// outcomes.
    pub compression: Option<(DVector<f64>, DVector<f64>)>,
    /// The factor on every restitution, less than 1 where rough contacts would have gained energy;
    /// of several groups the least.
    pub factor: f64,
    /// Whether P is the only one; u⁺ is the only one where no contact is rough and `solutions` is 1.
    pub unique: bool,
    /// How the impulses were found.
    pub method: ImpulseMethod,
    /// The work of all contacts: what the collision gained where it is positive, lost where it is
    /// negative. What is applied from outside is taken to act before.
    pub gained: f64,
    /// How many outcomes the law allows, of contacts with friction; the stage with the most counts.
    pub solutions: usize,
    /// The outcomes of groups of contacts that the mass matrix does not couple, where there are
    /// several.
    pub groups: Vec<Group>,
}

/// Contacts that the mass matrix couples, struck apart from all others.
#[derive(Debug, Clone)]
pub struct Group {
    /// Their rows.
    pub contacts: Vec<usize>,
    /// What the collision does where all other contacts are open.
    pub outcome: Outcome,
}

impl Outcome {
    /// The factor on the restitution of a contact.
    pub(crate) fn factor_of(&self, contact: usize) -> f64 {
        let group = self.groups.iter().find(|group| group.contacts.contains(&contact));
        group.map_or(self.factor, |group| group.outcome.factor)
    }
}

/// Why a collision has no outcome.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum CollisionError {
    /// No impulses satisfy the contact conditions.
    #[error("no admissible impulses exist")]
    Jammed,
    /// The rates are not determined: a motion without mass, or entries that are not finite, as of a
    /// thread with a segment of zero length.
    #[error("the mass matrix does not determine the rates")]
    Singular,
    /// More sets of contacts would have to be tried than are allowed.
    #[error("too many sets of contacts to be tried")]
    Exhausted,
    /// Stronge's law relates energies of a single contact along its path, without tangential
    /// restitution.
    #[error("Stronge's law applies to one contact at a time, without tangential restitution")]
    Several,
    /// Matrices and vectors that do not fit each other, or a tangent of what is no contact.
    #[error("the dimensions of the collision do not match")]
    Dimensions,
}

impl Collision {
    /// ġ⁻ of every row; exactly zero where it is zero but for the rounding of its terms.
    pub fn approach(&self) -> DVector<f64> {
        let (value, size) = (self.speed(&self.rates), self.speed_size());
        value.zip_map(&size, |x, size| if x.abs() <= SOLVED * size { 0.0 } else { x })
    }

    /// ġ of every row at the rates `u`.
    pub fn speed(&self, u: &DVector<f64>) -> DVector<f64> {
        &self.jacobian * u + &self.prescribed_gap_rate
    }

    /// The size of the terms that ġ⁻ is summed from.
    pub(super) fn speed_size(&self) -> DVector<f64> {
        self.jacobian.abs() * self.rates.abs() + self.prescribed_gap_rate.abs()
    }

    pub(super) fn check(&self) -> Result<(), CollisionError> {
        let (n, r) = (self.rates.len(), self.rows.len());
        let fits = self.mass.shape() == (n, n)
            && self.jacobian.shape() == (r, n)
            && self.applied.len() == n
            && self.prescribed_gap_rate.len() == r;
        let contact = |row: usize| {
            matches!(self.rows.get(row), Some(Row::Contact { .. } | Row::TwoSided | Row::Guide | Row::Open))
        };
        let tangents = self.rows.iter().all(|row| match row {
            Row::Tangent { of } | Row::Friction { of, .. } => contact(*of),
            Row::Open | Row::TwoSided | Row::Guide | Row::Contact { .. } => true,
        });
        match fits && tangents {
            true if self.is_finite() => Ok(()),
            true => Err(CollisionError::Singular),
            false => Err(CollisionError::Dimensions),
        }
    }

    fn is_finite(&self) -> bool {
        let mut rows = (0..self.rows.len()).filter(|&row| self.rows[row] != Row::Open);
        let mut others = self.mass.iter().chain(self.rates.iter()).chain(self.applied.iter());
        rows.all(|row| self.is_known(row)) && others.all(|x| x.is_finite())
    }

    fn is_known(&self, row: usize) -> bool {
        self.prescribed_gap_rate[row].is_finite()
            && self.jacobian.row(row).iter().all(|entry| entry.is_finite())
    }

    /// The same with zeros for open rows: that of a thread whose points meet has no number, or a
    /// rounding that would be taken for that of the others.
    pub(super) fn without_open_rows(&self) -> Option<Self> {
        let is_zero = |row: usize| {
            self.prescribed_gap_rate[row] == 0.0 && self.jacobian.row(row).iter().all(|x| *x == 0.0)
        };
        let open: Vec<usize> = (0..self.rows.len())
            .filter(|&row| is_open(&self.rows, &self.rows[row]) && !is_zero(row))
            .collect();
        (!open.is_empty()).then(|| {
            let mut acting = self.clone();
            for row in open {
                acting.jacobian.row_mut(row).fill(0.0);
                acting.prescribed_gap_rate[row] = 0.0;
            }
            acting
        })
    }
}

/// Whether one of the rows takes no part: that of an open contact, or of the tangent of one.
pub(super) fn is_open(rows: &[Row], row: &Row) -> bool {
    match *row {
        Row::Open => true,
        Row::Tangent { of } | Row::Friction { of, .. } => rows[of] == Row::Open,
        Row::TwoSided | Row::Contact { .. } | Row::Guide => false,
    }
}

#[cfg(test)]
mod tests;
