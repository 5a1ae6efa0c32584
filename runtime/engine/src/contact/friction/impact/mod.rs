//! Impacts with Coulomb friction.
//!
//! If one contact strikes, no other contact is pressed on the way and all joints have held before,
//! its impulse grows along Routh's path ([`path`]), by Newton's, Poisson's or Stronge's law.
//! Otherwise all contacts respond at once, by Newton's or Poisson's law ([`at_once`]); Stronge's
//! law is not defined then. Newton's has no solution for contacts that wedge a body between them:
//! with P ≠ 0 in the friction cones and Jᵀ P = 0 their velocities satisfy Pᵀ γ⁺ = 0, but the law
//! requires −e ġ⁻ > 0 of all that approach. Poisson's law has a solution and is used then, and the
//! outcome names it. Neither law excludes a gain of energy: the outcome reports the work of all
//! contacts, and no restitution is reduced.

mod at_once;
pub(in crate::contact) mod path;
mod rest;
mod tangential;
#[cfg(test)]
mod tests;

use nalgebra::DVector;

use super::super::impact::Stages;
use super::super::impulse::{Collision, CollisionError, Outcome, Row};
use super::modes::{Frictional, SlipVelocity};
use crate::model::Law;

/// A contact with friction in the impact: its rows, μ, e_t.
#[derive(Debug, Clone, Copy)]
pub(super) struct ImpactFriction {
    pub(super) is_guide: bool,
    pub(super) normal: usize,
    pub(super) tangent: usize,
    pub(super) mu: f64,
    pub(super) restitution: f64,
}

impl Collision {
    /// The contacts with friction in the impact.
    pub(super) fn rubbing(&self) -> Vec<ImpactFriction> {
        let rows = self.rows.iter().enumerate();
        let with_friction = rows.filter_map(|(tangent, row)| match *row {
            Row::Friction { of, mu, restitution }
                if matches!(self.rows[of], Row::Contact { .. } | Row::Guide) =>
            {
                Some(ImpactFriction {
                    is_guide: self.rows[of] == Row::Guide,
                    normal: of,
                    tangent,
                    mu,
                    restitution,
                })
            }
            _ => None,
        });
        with_friction.collect()
    }

    /// Whether a contact in the impact has friction.
    pub(in crate::contact) fn has_friction(&self) -> bool {
        self.rows.iter().any(|row| matches!(row, Row::Friction { .. })) && !self.rubbing().is_empty()
    }
}

impl ImpactFriction {
    /// The contact in the state of rest.
    fn at_rest(&self) -> Frictional {
        let (rows, mu) = ((self.normal, self.tangent), (self.mu, self.mu));
        match self.is_guide {
            true => Frictional::guide(rows, mu, SlipVelocity::Rest),
            false => Frictional::touching(rows, mu, SlipVelocity::Rest),
        }
    }
}

impl Stages<'_> {
    /// Whether the impact involves guides with friction.
    pub(super) fn has_guides(&self) -> bool {
        self.collision.rows.contains(&Row::Guide)
    }

    /// Whether all two-sided constraints have held before: no clutch takes hold, no hinge comes to
    /// rest.
    fn joints_hold(&self) -> bool {
        let rows = self.collision.rows.iter().zip(self.approach.iter());
        rows.filter(|(row, _)| **row == Row::TwoSided).all(|(_, approach)| *approach == 0.0)
    }

    /// Solves an impact of contacts of which some have friction.
    pub(in crate::contact) fn with_friction(&self) -> Result<Outcome, CollisionError> {
        let applied = self.collision.applied.amax() > 0.0;
        if applied && self.candidates.iter().any(|&row| self.declares(row, Law::Stronge)) {
            return self.applied_before();
        }
        if !applied
            && !self.has_guides()
            && self.joints_hold()
            && let Some(outcome) = self.along_path()?
        {
            return Ok(outcome);
        }
        match self.law_at_once()? {
            Law::Stronge => Err(CollisionError::Several),
            Law::Poisson => self.all_at_once(Law::Poisson, 1.0),
            law @ (Law::Newton | Law::Moreau) => match self.all_at_once(law, 1.0) {
                Err(CollisionError::Jammed) => self.all_at_once(Law::Poisson, 1.0),
                outcome => outcome,
            },
        }
    }

    /// The common restitution law of all contacts; contacts without restitution accept any law.
    fn law_at_once(&self) -> Result<Law, CollisionError> {
        let departs = self.candidates.iter().any(|&row| self.approach[row] > 0.0);
        let all = |law: Law| self.candidates.iter().all(|&row| self.declares(row, law));
        if all(Law::Newton) && !departs {
            return Ok(Law::Newton);
        }
        if let Some(law) = [Law::Poisson, Law::Moreau].into_iter().find(|law| all(*law)) {
            return Ok(law);
        }
        self.law_of(&self.all_at_once(Law::Newton, 0.0)?.acting, departs)
    }

    /// Applies an external impulse first, then the impact that it causes.
    fn applied_before(&self) -> Result<Outcome, CollisionError> {
        let free = Collision {
            rows: self.collision.rows.iter().map(|row| without_contact(*row)).collect(),
            ..self.collision.clone()
        };
        let first = free.solve()?;
        let still = DVector::zeros(self.collision.applied.len());
        let after = Collision { rates: first.rates, applied: still, ..self.collision.clone() };
        let second = after.solve_within(self.trials.left())?;
        Ok(Outcome { impulses: second.impulses + first.impulses, ..second })
    }
}

fn without_contact(row: Row) -> Row {
    if matches!(row, Row::TwoSided | Row::Guide | Row::Friction { .. }) { row } else { Row::Open }
}
