//! Constraint rows: each constraint g(q) = 0 as its value, its gradient J and J̇q̇ (g̈ = J q̈ + J̇q̇).

use nalgebra::{DMatrix, DVector, Vector2};

use super::state::across;
use super::{Assembly, Contact, Mark, State};

/// One scalar constraint at one state.
#[derive(Clone, Debug)]
pub struct Row {
    /// g.
    pub value: f64,
    /// Non-zero entries of J (an index may occur twice: its entries add).
    pub gradient: Vec<(usize, f64)>,
    /// J̇q̇.
    pub bias: f64,
}

impl Row {
    /// ġ = J q̇, or J q̈ for accelerations.
    pub fn along(&self, rates: &DVector<f64>) -> f64 {
        self.gradient.iter().map(|&(index, entry)| entry * rates[index]).sum()
    }

    fn minus(mut self, other: Row) -> Row {
        self.value -= other.value;
        self.bias -= other.bias;
        self.gradient.extend(other.gradient.into_iter().map(|(index, entry)| (index, -entry)));
        self
    }
}

const AXES: [Vector2<f64>; 2] = [Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0)];

impl Assembly {
    /// g = d·P for a point P and a fixed direction d.
    fn projection(&self, state: &State, mark: Mark, d: Vector2<f64>) -> Row {
        let (at, arm) = (3 * mark.body, self.arm(state, mark));
        Row {
            value: d.dot(&self.position(state, mark)),
            gradient: vec![(at, d.x), (at + 1, d.y), (at + 2, d.dot(&across(arm)))],
            bias: -state.spin(mark.body).powi(2) * d.dot(&arm),
        }
    }

    /// g = ±n·(A − K) = ±(n·(C − K) − c_across), with dn/dθ = −e and de/dθ = n.
    fn corner(&self, state: &State, body: usize, corner: Vector2<f64>, side: f64) -> Row {
        let at = 3 * body;
        let (sin, cos) = state.angle(body).sin_cos();
        let (e, n) = (Vector2::new(cos, sin), Vector2::new(-sin, cos));
        let reach = Vector2::new(state.positions[at], state.positions[at + 1]) - corner;
        let velocity = Vector2::new(state.rates[at], state.rates[at + 1]);
        let spin = state.spin(body);
        Row {
            value: side * (n.dot(&reach) - self.bodies[body].centre.y),
            gradient: vec![(at, side * n.x), (at + 1, side * n.y), (at + 2, -side * e.dot(&reach))],
            bias: -side * (2.0 * spin * e.dot(&velocity) + spin * spin * n.dot(&reach)),
        }
    }

    /// The gap of a support.
    pub fn support_row(&self, state: &State, support: usize) -> Row {
        match self.supports[support].contact {
            Contact::Point { point, through, normal } => {
                let mut row = self.projection(state, point, normal);
                row.value -= normal.dot(&through);
                row
            }
            Contact::Corner { body, corner, side } => self.corner(state, body, corner, side),
        }
    }

    /// The two-sided constraints: two rows a hinge, two a pin, two a particle, one a tie, in this order.
    pub fn joint_rows(&self, state: &State) -> Vec<Row> {
        let hinges = self.hinges.iter().flat_map(|hinge| {
            AXES.map(|d| {
                let second = self.projection(state, hinge.second, d);
                self.projection(state, hinge.first, d).minus(second)
            })
        });
        let pins = self.pins.iter().flat_map(|pin| {
            AXES.map(|d| {
                let mut row = self.projection(state, pin.at, d);
                row.value -= d.dot(&pin.ground);
                row
            })
        });
        let particles = (0..self.particles.len()).flat_map(|index| self.carried(state, index));
        hinges.chain(pins).chain(particles).chain(self.tie_rows(state)).collect()
    }

    fn carried(&self, state: &State, particle: usize) -> [Row; 2] {
        let at = 3 * self.bodies.len() + 2 * particle;
        [0, 1].map(|axis| {
            let place =
                Row { value: state.positions[at + axis], gradient: vec![(at + axis, 1.0)], bias: 0.0 };
            self.projection(state, self.particles[particle].at, AXES[axis]).minus(place)
        })
    }

    fn tie_rows(&self, state: &State) -> impl Iterator<Item = Row> {
        self.ties.iter().map(|tie| {
            let sum: f64 = tie.terms.iter().map(|&(body, c)| c * state.angle(body)).sum();
            Row {
                value: sum - tie.value,
                gradient: tie.terms.iter().map(|&(body, c)| (3 * body + 2, c)).collect(),
                bias: 0.0,
            }
        })
    }

    /// The two-sided rows, then those of the closed supports.
    pub(super) fn rows(&self, state: &State, closed: &[usize]) -> Vec<Row> {
        let mut rows = self.joint_rows(state);
        rows.extend(closed.iter().map(|&support| self.support_row(state, support)));
        rows
    }

    /// Largest error of the two-sided constraints, in position or velocity.
    pub fn residual(&self, state: &State) -> f64 {
        let size = |row: &Row| row.value.abs().max(row.along(&state.rates).abs());
        self.joint_rows(state).iter().map(size).fold(0.0, f64::max)
    }
}

/// J as a dense matrix.
pub(super) fn jacobian(rows: &[Row], dimension: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(rows.len(), dimension);
    for (index, row) in rows.iter().enumerate() {
        for &(column, entry) in &row.gradient {
            matrix[(index, column)] += entry;
        }
    }
    matrix
}
