//! The equations of motion in the generalised coordinates, as Poisson series:
//!
//! `M a + h = Q + Jᵀ λ`, with `T = ½ uᵀ M u`, `M = Σ m J_cᵀ J_c + I ωᵀ ω`, `h = Σ m J_cᵀ J̇_c u`
//! (the velocity terms), Q the generalised forces of gravity, springs and loads, and one row `g̈ = J a + b` for each
//! contact, each joint, and each slip of a rough contact.

mod action;
mod contacts;
mod expression;
mod forces;
mod gap;
mod loads;
mod parts;
mod quantities;
mod row;
mod thread;

use crate::algebra::{Rational, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::system::System;
use expression::Atoms;

pub use action::{Action, Holder, Scene};
pub use contacts::{Contact, Tangent};
pub use expression::{Atom, Expression};
pub use gap::Foot;
pub use loads::Loads;
pub use row::Row;
pub(crate) use row::bias;

/// `Σ a b`, the products not multiplied out: series of the motion, its accelerations and the multipliers of the rows.
pub type Products = Vec<[Series; 2]>;

/// A mass at a position, and its energy's parts.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// What it moves with.
    pub on: Option<Holder>,
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
    /// What acts beside gravity.
    pub loads: Loads,
    /// One-sided contacts.
    pub contacts: Vec<Contact>,
    /// Rows of the contacts, then of the joints, then of the slips of rough contacts.
    pub rows: Vec<Row>,
    /// The contact of each slip.
    pub tangents: Vec<usize>,
    /// What series contain that is no series itself.
    pub atoms: Vec<Atom>,
    /// Joint forces, tensions, internal forces and momenta, by name.
    pub quantities: Vec<(String, Products)>,
}

impl Motion {
    /// Derives the equations of `system` in the coordinates of `kinematics`.
    ///
    /// # Errors
    /// A support whose point cannot move; rationals that overflow.
    pub fn of(system: &System, kinematics: &Kinematics) -> syn::Result<Self> {
        let n = kinematics.coordinates.len();
        let scene = Scene { system, kinematics };
        let inertias = inertias(system, kinematics);
        let mut atoms = Atoms::of_drives(system, kinematics);
        let contacts = contacts::merge(&scene, &mut atoms)?;
        let loads = Loads::of(&scene, &mut atoms);
        let joints = kinematics.joints.iter().map(|joint| Row::of(&joint.equation, n));
        let slips = contacts.iter().flat_map(|c| c.tangents.iter().map(|tangent| tangent.row.clone()));
        let tangents = contacts.iter().enumerate().flat_map(|(i, c)| c.tangents.iter().map(move |_| i));
        let mut motion = Self {
            n,
            mass: vec![vec![Series::zero(); n]; n],
            velocity_terms: vec![Series::zero(); n],
            forces: vec![Series::zero(); n],
            potential: &potential(system, &inertias) + &loads.potential,
            inertias,
            rows: contacts.iter().map(|c| c.row.clone()).chain(joints).chain(slips).collect(),
            tangents: tangents.collect(),
            loads,
            contacts,
            atoms: Vec::new(),
            quantities: Vec::new(),
        };
        motion.load(&scene);
        motion.quantities = quantities::of(&scene, &motion, &mut atoms);
        motion.atoms = atoms.0;
        for body in motion.inertias.clone() {
            motion.add(&body, system.gravity.as_ref());
        }
        motion.check(&scene)
    }

    /// Whether a row is closed in a contact set.
    pub fn is_closed(&self, row: usize, set: u64) -> bool {
        let tangents = self.rows.len() - self.tangents.len();
        match row {
            _ if row < self.contacts.len() => set >> row & 1 == 1,
            _ if row < tangents => true,
            _ => set >> self.tangents[row - tangents] & 1 == 1,
        }
    }

    /// Whether the equations depend on time.
    pub fn is_timed(&self) -> bool {
        self.atoms.iter().flat_map(|atom| &atom.orders).any(Expression::has_time)
    }

    /// `Qᵢ = Σ F · ∂r/∂qᵢ + C ∂δ/∂qᵢ`.
    fn load(&mut self, scene: &Scene) {
        for action in &self.loads.actions {
            for (i, force) in self.forces.iter_mut().enumerate() {
                *force += action.work(scene, i);
            }
        }
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
        let bias = body.centre.each_ref().map(|x| bias(x, n));
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

    fn check(self, scene: &Scene) -> syn::Result<Self> {
        let overflow = self.mass.iter().flatten().any(Series::is_overflow)
            || self.velocity_terms.iter().chain(&self.forces).any(Series::is_overflow)
            || self.rows.iter().any(Row::is_overflow);
        if overflow {
            let text = "the exact coefficients overflow 128 bits; write long decimals as parameters";
            return Err(syn::Error::new(scene.system.ident.span(), text));
        }
        let held = |i: usize| self.rows.iter().any(|row| !row.jacobian[i].is_zero());
        let errors = (0..self.n).filter(|&i| self.mass[i].iter().all(Series::is_zero) && !held(i));
        let errors = errors.map(|i| scene.massless(i)).reduce(|mut all, error| {
            all.combine(error);
            all
        });
        errors.map_or(Ok(self), Err)
    }
}

fn dot(a: &[Series; 2], b: &[Series; 2]) -> Series {
    &(&a[0] * &b[0]) + &(&a[1] * &b[1])
}

fn inertias(system: &System, kinematics: &Kinematics) -> Vec<Inertia> {
    let scene = Scene { system, kinematics };
    let bodies = system.bodies.iter().enumerate().map(|(i, body)| Inertia {
        on: Some(Holder::Body(i)),
        mass: body.mass.clone(),
        inertia: body.inertia.clone(),
        centre: kinematics.centres[i].clone(),
        spin: kinematics.directions[i].rate(),
    });
    let particles = system.particles.iter().map(|particle| Inertia {
        on: scene.holder(particle.point),
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
