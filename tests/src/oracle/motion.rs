//! Newton–Euler: accelerations, forces of joints and reactions of supports at one state.

use nalgebra::{DMatrix, DVector, Vector2};

use super::kkt;
use super::rows::{Row, jacobian};
use super::state::across;
use super::{Assembly, Mark, State, Unsolvable};

/// What acts and how it moves, for one set of closed supports.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Accelerations in the order of [`State::positions`].
    pub accelerations: DVector<f64>,
    /// Force of each hinge on the body of its first point.
    pub hinges: Vec<Vector2<f64>>,
    /// Force of each pin on its body.
    pub pins: Vec<Vector2<f64>>,
    /// Reaction of each support along its free normal; 0 where open.
    pub reactions: Vec<f64>,
    /// Second derivative of each gap; 0 (to rounding) where closed.
    pub gap_accelerations: Vec<f64>,
    /// Whether the forces are unique; if not, a least-norm set stands for them.
    pub unique: bool,
    /// Smallest over largest pivot of the balanced system: near 0 the answer has few digits.
    pub pivots: f64,
}

impl Motion {
    /// Angular acceleration of a body.
    pub fn angular(&self, body: usize) -> f64 {
        self.accelerations[3 * body + 2]
    }

    /// Acceleration of a body's centre of mass.
    pub fn linear(&self, body: usize) -> Vector2<f64> {
        Vector2::new(self.accelerations[3 * body], self.accelerations[3 * body + 1])
    }
}

impl Assembly {
    /// Diagonal of M: m, m, I of each body, m, m of each particle.
    pub fn masses(&self) -> DVector<f64> {
        let bodies = self.bodies.iter().flat_map(|b| [b.mass, b.mass, b.inertia]);
        let particles = self.particles.iter().flat_map(|p| [p.mass, p.mass]);
        DVector::from_iterator(self.dimension(), bodies.chain(particles))
    }

    /// Gravity and loads as forces on the maximal coordinates.
    pub fn forces(&self, state: &State) -> DVector<f64> {
        let mut forces = DVector::zeros(self.dimension());
        for (index, body) in self.bodies.iter().enumerate() {
            forces.fixed_rows_mut::<2>(3 * index).copy_from(&(self.gravity * body.mass));
        }
        for (index, particle) in self.particles.iter().enumerate() {
            let at = 3 * self.bodies.len() + 2 * index;
            forces.fixed_rows_mut::<2>(at).copy_from(&(self.gravity * particle.mass));
        }
        for load in &self.loads {
            let at = 3 * load.at.body;
            forces[at] += load.force.x;
            forces[at + 1] += load.force.y;
            forces[at + 2] += load.force.dot(&across(self.arm(state, load.at)));
        }
        forces
    }

    /// Accelerations and forces with the supports in `closed` held two-sidedly at g̈ = 0 and all others open.
    pub fn solve(&self, state: &State, closed: &[usize]) -> Result<Motion, Unsolvable> {
        let rows = self.rows(state, closed);
        let (matrix, right) = self.system(state, &rows);
        let solution = kkt::solve(&matrix, &right, self.dimension())?;
        let accelerations = solution.values.rows(0, self.dimension()).into_owned();
        let multipliers = -solution.values.rows(self.dimension(), rows.len());
        let pair = |at: usize| Vector2::new(multipliers[at], multipliers[at + 1]);
        let pins = 2 * self.hinges.len();
        let mut reactions = vec![0.0; self.supports.len()];
        let first = rows.len() - closed.len();
        for (index, &support) in closed.iter().enumerate() {
            reactions[support] = multipliers[first + index];
        }
        let gap_acceleration = |support| {
            let row = self.support_row(state, support);
            row.along(&accelerations) + row.bias
        };
        Ok(Motion {
            hinges: (0..self.hinges.len()).map(|index| pair(2 * index)).collect(),
            pins: (0..self.pins.len()).map(|index| pair(pins + 2 * index)).collect(),
            gap_accelerations: (0..self.supports.len()).map(gap_acceleration).collect(),
            reactions,
            accelerations,
            unique: solution.unique,
            pivots: solution.pivots,
        })
    }

    fn system(&self, state: &State, rows: &[Row]) -> (DMatrix<f64>, DVector<f64>) {
        let (free, size) = (self.dimension(), self.dimension() + rows.len());
        let jacobian = jacobian(rows, free);
        let mut matrix = DMatrix::zeros(size, size);
        matrix.view_mut((0, 0), (free, free)).set_diagonal(&self.masses());
        matrix.view_mut((free, 0), (rows.len(), free)).copy_from(&jacobian);
        matrix.view_mut((0, free), (free, rows.len())).copy_from(&jacobian.transpose());
        let bias = rows.iter().map(|row| -row.bias);
        let right = DVector::from_iterator(size, self.forces(state).iter().copied().chain(bias));
        (matrix, right)
    }

    /// Acceleration of a point of a body.
    pub fn acceleration(&self, state: &State, motion: &Motion, mark: Mark) -> Vector2<f64> {
        let arm = self.arm(state, mark);
        motion.linear(mark.body) + across(arm) * motion.angular(mark.body)
            - arm * state.spin(mark.body).powi(2)
    }

    /// Gap and gap rate of a support.
    pub fn gap(&self, state: &State, support: usize) -> [f64; 2] {
        let row = self.support_row(state, support);
        [row.value, row.along(&state.rates)]
    }
}
