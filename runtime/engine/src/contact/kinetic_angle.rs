//! Kinetic angles between contacts: cos θᵢⱼ = −Wᵢⱼ / √(Wᵢᵢ Wⱼⱼ) with the Delassus matrix W = J M̂⁻¹
//! Jᵀ, M̂⁻¹ with the two-sided rows taken in. The outcome of two impacts one after the other does
//! not depend on their order where θ = 90° (Ivanov, *On multiple impact*, J. Appl. Math. Mech. 59,
//! 1995).

use nalgebra::DVector;

use super::equilibrated_kkt::EquilibratedKkt;
use super::impulse::{Collision, Row};
use super::least_constraint::LeastConstraint;
use crate::numerics::zero::SOLVED;

impl Collision {
    /// The kinetic angle (rad) of two contacts where it is not a right one. `None` also where it is
    /// not determined: a contact that cannot move, or a motion without mass.
    pub fn kinetic_angle(&self, a: usize, b: usize) -> Option<f64> {
        self.kinetic_angles(&[a, b]).first().map(|(_, angle)| *angle)
    }

    /// The pairs among some contacts whose kinetic angle is not a right one, with that angle (rad).
    /// Of redundant contacts those that depend on earlier ones are left out.
    pub fn kinetic_angles(&self, contacts: &[usize]) -> Vec<([usize; 2], f64)> {
        if contacts.len() < 2 {
            return Vec::new();
        }
        let Some(least) = self.at_rest() else { return Vec::new() };
        let fixed = self.two_sided();
        let mut directions = least.free_directions(&fixed, contacts);
        let movable = directions.iter().map(|(row, _)| *row);
        let independent = least.independent(&fixed.iter().copied().chain(movable).collect::<Vec<_>>());
        directions.retain(|(row, _)| independent.contains(row));
        let mut pairs = Vec::new();
        for (k, (a, one)) in directions.iter().enumerate() {
            for (b, other) in &directions[k + 1..] {
                let cosine = -one.dot(other);
                if cosine.abs() > SOLVED {
                    pairs.push(([*a, *b], cosine.clamp(-1.0, 1.0).acos()));
                }
            }
        }
        pairs
    }

    /// Whether the mass matrix couples two of the directions that
    /// [`free_directions`](LeastConstraint::free_directions) gives.
    pub(super) fn are_coupled(one: &DVector<f64>, other: &DVector<f64>) -> bool {
        one.dot(other).abs() > SOLVED
    }

    /// Rows that hold both ways whatever the contacts do.
    pub(super) fn two_sided(&self) -> Vec<usize> {
        let holds = |row: &Row| match *row {
            Row::TwoSided => true,
            Row::Tangent { of } => self.rows[of] == Row::TwoSided,
            _ => false,
        };
        (0..self.rows.len()).filter(|&i| holds(&self.rows[i])).collect()
    }

    /// The problem without rates and impulses; `None` where it is not finite.
    pub(super) fn at_rest(&self) -> Option<LeastConstraint> {
        let rest = DVector::zeros(self.rows.len());
        let still = DVector::zeros(self.rates.len());
        let problem = EquilibratedKkt::new(&self.mass, &self.jacobian, (&still, &rest), (&still, &rest));
        problem.least_constraint().ok()
    }
}
