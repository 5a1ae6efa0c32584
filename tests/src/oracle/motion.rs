//! Newton–Euler: accelerations, forces of joints and reactions of supports at one state.

use nalgebra::{DMatrix, DVector, Vector2};

use super::kkt;
use super::rows::{Row, jacobian};
use super::state::{across, pair};
use super::{Assembly, Place, State, Unsolvable};

/// What acts and how it moves, for one set of closed supports.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Accelerations in the order of [`State::positions`].
    pub accelerations: DVector<f64>,
    /// Force of each hinge on the body of its first point.
    pub hinges: Vec<Vector2<f64>>,
    /// Force of each pin on its body.
    pub pins: Vec<Vector2<f64>>,
    /// Force or torque of each drive in the direction in which its reading grows.
    pub drives: Vec<f64>,
    /// Reaction of each support along its free normal, tension of a thread; 0 where open.
    pub reactions: Vec<f64>,
    /// Tangential reaction of each support on the body along [`Assembly::tangent_row`]; 0 where
    /// open or smooth.
    pub tangential: Vec<f64>,
    /// Second derivative of each gap; 0 (to rounding) where closed.
    pub gap_accelerations: Vec<f64>,
    /// Every force of a joint, support, spring or load at its place; weights and couples are not
    /// among these.
    pub actions: Vec<(Place, Vector2<f64>)>,
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
        pair(&self.accelerations, 3 * body)
    }
}

impl Assembly {
    /// Diagonal of M: m, m, I of each body, m, m of each particle.
    pub fn masses(&self) -> DVector<f64> {
        let bodies = self.bodies.iter().flat_map(|b| [b.mass, b.mass, b.inertia]);
        let particles = self.particles.iter().flat_map(|p| [p.mass, p.mass]);
        DVector::from_iterator(self.dimension(), bodies.chain(particles))
    }

    /// Accelerations and forces with the supports in `closed` held two-sidedly at g̈ = 0 (and
    /// without slip where rough) and all others open.
    pub fn solve(&self, state: &State, closed: &[usize]) -> Result<Motion, Unsolvable> {
        let (free, rows) = (self.dimension(), self.rows(state, closed));
        let right = rows.iter().map(|row| -row.bias);
        let right =
            DVector::from_iterator(free + rows.len(), self.forces(state).iter().copied().chain(right));
        let solution = kkt::solve(&self.matrix(&rows), &right, free)?;
        let accelerations = solution.values.rows(0, free).into_owned();
        let multipliers = -solution.values.rows(free, rows.len());
        let shares = self.shares(&multipliers, closed);
        let gap_acceleration = |support| {
            let row = self.support_row(state, support);
            row.along(&accelerations) + row.bias
        };
        let exerted = rows.iter().zip(multipliers.iter());
        let exerted = exerted.flat_map(|(row, &by)| row.forces.iter().map(move |&(at, f)| (at, f * by)));
        let pins = 2 * self.hinges.len();
        Ok(Motion {
            hinges: (0..self.hinges.len()).map(|index| pair(&multipliers, 2 * index)).collect(),
            pins: (0..self.pins.len()).map(|index| pair(&multipliers, pins + 2 * index)).collect(),
            drives: shares.drives,
            reactions: shares.normal,
            tangential: shares.tangential,
            gap_accelerations: (0..self.supports.len()).map(gap_acceleration).collect(),
            actions: self.applied(state).into_iter().chain(exerted).collect(),
            accelerations,
            unique: solution.unique,
            pivots: solution.pivots,
        })
    }

    /// Multipliers of [`Assembly::rows`] by drive and support.
    pub(super) fn shares(&self, multipliers: &DVector<f64>, closed: &[usize]) -> Shares {
        let rough: Vec<_> = closed.iter().filter(|&&support| self.slips(support)).collect();
        let tangents = multipliers.len() - rough.len();
        let normals = tangents - closed.len();
        let drives = normals - self.drives.len();
        let mut normal = vec![0.0; self.supports.len()];
        let mut tangential = normal.clone();
        for (index, &support) in closed.iter().enumerate() {
            normal[support] = multipliers[normals + index];
        }
        for (index, &&support) in rough.iter().enumerate() {
            tangential[support] = multipliers[tangents + index];
        }
        Shares { drives: (drives..normals).map(|row| multipliers[row]).collect(), normal, tangential }
    }

    /// [M Jᵀ; J 0].
    pub(super) fn matrix(&self, rows: &[Row]) -> DMatrix<f64> {
        let (free, size) = (self.dimension(), self.dimension() + rows.len());
        let jacobian = jacobian(rows, free);
        let mut matrix = DMatrix::zeros(size, size);
        matrix.view_mut((0, 0), (free, free)).set_diagonal(&self.masses());
        matrix.view_mut((free, 0), (rows.len(), free)).copy_from(&jacobian);
        matrix.view_mut((0, free), (free, rows.len())).copy_from(&jacobian.transpose());
        matrix
    }

    /// Acceleration of a point.
    pub fn acceleration(&self, state: &State, motion: &Motion, place: impl Into<Place>) -> Vector2<f64> {
        match place.into() {
            Place::Body(mark) => {
                let arm = self.arm(state, mark);
                motion.linear(mark.body) + across(arm) * motion.angular(mark.body)
                    - arm * state.spin(mark.body).powi(2)
            }
            Place::Particle(index) => pair(&motion.accelerations, self.particle_at(index)),
            Place::Ground(_) => Vector2::zeros(),
        }
    }

    /// Gap and gap rate of a support.
    pub fn gap(&self, state: &State, support: usize) -> [f64; 2] {
        let row = self.support_row(state, support);
        [row.value, row.rate(&state.rates)]
    }
}

/// Multipliers, sorted.
pub(super) struct Shares {
    /// Of each drive.
    pub(super) drives: Vec<f64>,
    /// Of each support's gap.
    pub(super) normal: Vec<f64>,
    /// Of each support's slip.
    pub(super) tangential: Vec<f64>,
}
