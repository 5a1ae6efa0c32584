//! Kinetic angles between contacts: cos θᵢⱼ = −Wᵢⱼ / √(Wᵢᵢ Wⱼⱼ) with the Delassus matrix W = J M̂⁻¹ Jᵀ, M̂⁻¹ with the
//! two-sided rows taken in. The outcome of two impacts one after the other does not depend on their order where
//! θ = 90° (Ivanov, *On multiple impact*, J. Appl. Math. Mech. 59, 1995).

use nalgebra::DVector;

use super::equilibrated_kkt::EquilibratedKkt;
use super::impulse::{Collision, Row};

/// A cosine below this is zero but for rounding.
const ROUNDING: f64 = 1e-12;

impl Collision {
    /// The kinetic angle (rad) of two contacts where it is not a right one. `None` also where it is not determined: a
    /// contact that cannot move, or a motion without mass.
    pub fn kinetic_angle(&self, a: usize, b: usize) -> Option<f64> {
        self.kinetic_angles(&[a, b]).first().map(|(_, angle)| *angle)
    }

    /// The pairs among some contacts whose kinetic angle is not a right one, with that angle (rad). Of redundant contacts
    /// those that depend on earlier ones are left out.
    pub fn kinetic_angles(&self, contacts: &[usize]) -> Vec<([usize; 2], f64)> {
        if contacts.len() < 2 {
            return Vec::new();
        }
        let rest = DVector::zeros(self.rows.len());
        let still = DVector::zeros(self.rates.len());
        let problem = EquilibratedKkt::new(&self.mass, &self.jacobian, (&still, &rest), (&still, &rest));
        let Ok(least) = problem.least_constraint() else { return Vec::new() };
        let two_sided = |i: &usize| matches!(self.rows[*i], Row::TwoSided);
        let fixed: Vec<usize> = (0..self.rows.len()).filter(two_sided).collect();
        let directions = least.free_directions(&fixed, contacts);
        let mut pairs = Vec::new();
        for (k, (a, one)) in directions.iter().enumerate() {
            for (b, other) in &directions[k + 1..] {
                let cosine = -one.dot(other);
                if cosine.abs() > ROUNDING {
                    pairs.push(([*a, *b], cosine.clamp(-1.0, 1.0).acos()));
                }
            }
        }
        pairs
    }
}
