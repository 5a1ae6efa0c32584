//! The equations of motion in the generalised coordinates, as Poisson series:
//!
//! `M a + h = Q + Jᵀ λ`, with `T = ½ uᵀ M u`, `M = Σ m J_cᵀ J_c + I ωᵀ ω`, `h = Σ m J_cᵀ J̇_c u`
//! (the velocity terms), `Q = −∂V/∂q`, and one row `g̈ = J a + b`, `b = J̇ u`, for each contact and joint.

mod contacts;

use crate::algebra::{Rational, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::system::System;

pub use contacts::{Contact, Foot};

/// One row of constraints: a gap and its derivatives.
#[derive(Clone, Debug)]
pub struct Row {
    /// g.
    pub gap: Series,
    /// J = ∂g/∂q.
    pub jacobian: Vec<Series>,
    /// b = J̇ u.
    pub bias: Series,
}

impl Row {
    fn of(gap: &Series, n: usize) -> Self {
        let jacobian = (0..n).map(|i| gap.derivative(Symbol::coordinate(i))).collect();
        Self { gap: gap.clone(), jacobian, bias: bias(gap, n) }
    }
}

/// A mass at a position, and its energy's parts.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// Mass.
    pub mass: Series,
    /// Moment of inertia about the centre; zero for a point mass.
    pub inertia: Series,
    /// Position of the centre.
    pub centre: [Series; 2],
    /// Angular velocity.
    pub spin: Series,
}

/// The equations of motion of the system without contacts, and the rows of contacts and joints.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Number of coordinates.
    pub n: usize,
    /// M, full and symmetric.
    pub mass: Vec<Vec<Series>>,
    /// h, the velocity terms.
    pub velocity_terms: Vec<Series>,
    /// Q, the generalised forces.
    pub forces: Vec<Series>,
    /// Everything that has mass.
    pub inertias: Vec<Inertia>,
    /// V.
    pub potential: Series,
    /// One-sided contacts.
    pub contacts: Vec<Contact>,
    /// Rows of the contacts, then of the joints.
    pub rows: Vec<Row>,
}

impl Motion {
    /// Derives the equations of `system` in the coordinates of `kinematics`.
    ///
    /// # Errors
    /// A support whose point cannot move; rationals that overflow.
    pub fn of(system: &System, kinematics: &Kinematics) -> syn::Result<Self> {
        let n = kinematics.coordinates.len();
        let inertias = inertias(system, kinematics);
        let contacts = contacts::merge(system, kinematics)?;
        let joints = kinematics.joints.iter().map(|joint| &joint.equation);
        let rows = contacts.iter().map(|c| &c.gap).chain(joints).map(|gap| Row::of(gap, n)).collect();
        let mut motion = Self {
            n,
            mass: vec![vec![Series::zero(); n]; n],
            velocity_terms: vec![Series::zero(); n],
            forces: vec![Series::zero(); n],
            potential: potential(system, &inertias),
            inertias,
            contacts,
            rows,
        };
        for body in motion.inertias.clone() {
            motion.add(&body, system.gravity.as_ref());
        }
        motion.check(system)
    }

    /// f = Q − h.
    pub fn force(&self, i: usize) -> Series {
        &self.forces[i] - &self.velocity_terms[i]
    }

    /// T = ½ uᵀ M u.
    pub fn kinetic(&self) -> Series {
        let rate = |i| Series::symbol(Symbol::rate(i));
        let mut sum = Series::zero();
        for i in 0..self.n {
            for j in 0..=i {
                let weight = if i == j { Rational::new(1, 2) } else { Rational::ONE };
                sum += (&self.mass[i][j] * &(&rate(i) * &rate(j))).scale(weight);
            }
        }
        sum
    }

    fn add(&mut self, body: &Inertia, gravity: Option<&[Series; 2]>) {
        let n = self.n;
        let derivative = |s: &Series, i| s.derivative(Symbol::coordinate(i));
        let bias: [Series; 2] = core::array::from_fn(|axis| bias(&body.centre[axis], n));
        let columns: Vec<[Series; 2]> =
            (0..n).map(|i| core::array::from_fn(|axis| derivative(&body.centre[axis], i))).collect();
        let spins: Vec<Series> = (0..n).map(|i| body.spin.derivative(Symbol::rate(i))).collect();
        let moving: Vec<usize> =
            (0..n).filter(|&i| !columns[i].iter().all(Series::is_zero) || !spins[i].is_zero()).collect();
        for &i in &moving {
            let momentum: [Series; 2] = core::array::from_fn(|axis| &body.mass * &columns[i][axis]);
            let spin = &body.inertia * &spins[i];
            for &j in moving.iter().filter(|&&j| j <= i) {
                let entry = &dot(&momentum, &columns[j]) + &(&spin * &spins[j]);
                self.mass[i][j] += entry.clone();
                if i != j {
                    self.mass[j][i] += entry;
                }
            }
            self.velocity_terms[i] += dot(&momentum, &bias);
            if let Some(gravity) = gravity {
                self.forces[i] += dot(&momentum, gravity);
            }
        }
    }

    fn check(self, system: &System) -> syn::Result<Self> {
        let overflow = self.mass.iter().flatten().any(Series::is_overflow)
            || self.velocity_terms.iter().chain(&self.forces).any(Series::is_overflow)
            || self.rows.iter().any(|r| r.gap.is_overflow() || r.bias.is_overflow());
        if overflow {
            let text = "the exact coefficients overflow 128 bits; write long decimals as parameters";
            return Err(syn::Error::new(system.ident.span(), text));
        }
        Ok(self)
    }
}

fn dot(a: &[Series; 2], b: &[Series; 2]) -> Series {
    &(&a[0] * &b[0]) + &(&a[1] * &b[1])
}

/// The second time derivative at zero accelerations: `Σ uᵢ ∂ẋ/∂qᵢ`.
pub(crate) fn bias(x: &Series, n: usize) -> Series {
    let rate = x.rate();
    let mut sum = Series::zero();
    for i in 0..n {
        let slope = rate.derivative(Symbol::coordinate(i));
        if !slope.is_zero() {
            sum += &slope * &Series::symbol(Symbol::rate(i));
        }
    }
    sum
}

fn inertias(system: &System, kinematics: &Kinematics) -> Vec<Inertia> {
    let bodies = system.bodies.iter().enumerate().map(|(i, body)| Inertia {
        mass: body.mass.clone(),
        inertia: body.inertia.clone(),
        centre: kinematics.centres[i].clone(),
        spin: kinematics.directions[i].rate(),
    });
    let particles = system.particles.iter().map(|particle| Inertia {
        mass: particle.mass.clone(),
        inertia: Series::zero(),
        centre: kinematics.points[particle.point].clone(),
        spin: Series::zero(),
    });
    bodies.chain(particles).collect()
}

/// `V = −Σ m (g · r)`.
fn potential(system: &System, inertias: &[Inertia]) -> Series {
    let Some(gravity) = &system.gravity else { return Series::zero() };
    inertias.iter().map(|body| -&(&body.mass * &dot(gravity, &body.centre))).sum()
}
