//! Kinetic angles between contacts: cos θᵢⱼ = −Wᵢⱼ / √(Wᵢᵢ Wⱼⱼ) with the Delassus matrix W = J M̂⁻¹ Jᵀ, M̂⁻¹ with the
//! two-sided rows taken in. The outcome of two impacts one after the other does not depend on their order where
//! θ = 90° (Ivanov, *On multiple impact*, J. Appl. Math. Mech. 59, 1995).

use nalgebra::{DMatrix, DVector};

use super::complementarity::LcpRows;
use super::equilibrated_kkt::EquilibratedKkt;
use super::impulse::{Collision, Row};

/// A cosine below this is zero but for rounding.
const ROUNDING: f64 = 1e-12;

impl Collision {
    /// The kinetic angle (rad) of two contacts where it is not a right one. `None` also where it is not determined: a
    /// contact that cannot move, or a motion without mass.
    pub fn kinetic_angle(&self, a: usize, b: usize) -> Option<f64> {
        let two_sided = |i: &usize| matches!(self.rows[*i], Row::TwoSided);
        let fixed: Vec<usize> = (0..self.rows.len()).filter(two_sided).collect();
        let response = |row: usize| {
            let push: DVector<f64> = self.jacobian.row(row).transpose();
            let rest = DVector::zeros(self.rows.len());
            let problem =
                EquilibratedKkt::new(&self.mass, &self.jacobian, (&push, &rest), (&push.abs(), &rest));
            let choice = LcpRows { fixed: &fixed, ..LcpRows::default() };
            problem.solve(&choice).ok().map(|found| found.accelerations)
        };
        let moved: [DVector<f64>; 2] = [response(a)?, response(b)?];
        let w = DMatrix::from_fn(2, 2, |i, j| self.jacobian.row([a, b][i]).transpose().dot(&moved[j]));
        let size = (w[(0, 0)] * w[(1, 1)]).sqrt();
        let cosine = -w[(0, 1)] / size;
        (size > 0.0 && cosine.abs() > ROUNDING).then(|| cosine.clamp(-1.0, 1.0).acos())
    }
}
