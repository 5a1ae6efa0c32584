//! M, h and Q, every entry written out.

use super::action::Scene;
use super::{Inertia, Motion, bias, dot, overflow};
use crate::algebra::{Rational, Series, Symbol};

/// `M a + h = Q + Jᵀ λ`, entry by entry.
#[derive(Clone, Debug)]
pub struct Dense {
    /// M, full and symmetric.
    pub mass: Vec<Vec<Series>>,
    /// h, the velocity terms.
    pub velocity_terms: Vec<Series>,
    /// Q, the generalised forces.
    pub forces: Vec<Series>,
}

impl Dense {
    /// The entries for `motion`.
    ///
    /// # Errors
    /// A coordinate that neither mass nor constraint determines; rationals that overflow.
    pub fn of(scene: &Scene, motion: &Motion) -> syn::Result<Self> {
        let n = motion.n;
        let mut dense = Self {
            mass: vec![vec![Series::zero(); n]; n],
            velocity_terms: vec![Series::zero(); n],
            forces: vec![Series::zero(); n],
        };
        dense.load(scene, motion);
        for body in &motion.inertias {
            dense.add(body, scene.system.gravity.as_ref());
        }
        dense.check(scene, motion)
    }

    /// f = Q − h.
    pub fn force(&self, i: usize) -> Series {
        &self.forces[i] - &self.velocity_terms[i]
    }

    /// T = ½ uᵀ M u.
    pub fn kinetic(&self) -> Series {
        let rate = |i| Series::symbol(Symbol::rate(i));
        let pairs = (0..self.mass.len()).flat_map(|i| (0..=i).map(move |j| (i, j)));
        let weight = |i, j| if i == j { Rational::new(1, 2) } else { Rational::ONE };
        pairs.map(|(i, j)| (&self.mass[i][j] * &(&rate(i) * &rate(j))).scale(weight(i, j))).sum()
    }

    /// `Qᵢ = Σ F · ∂r/∂qᵢ + C ∂δ/∂qᵢ`.
    fn load(&mut self, scene: &Scene, motion: &Motion) {
        for action in &motion.loads.actions {
            for (i, force) in self.forces.iter_mut().enumerate() {
                *force += action.work(scene, i);
            }
        }
    }

    fn add(&mut self, body: &Inertia, gravity: Option<&[Series; 2]>) {
        let n = self.forces.len();
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

    fn check(self, scene: &Scene, motion: &Motion) -> syn::Result<Self> {
        let all = self.mass.iter().flatten().chain(&self.velocity_terms).chain(&self.forces);
        if all.into_iter().any(Series::is_overflow) {
            return Err(overflow(scene.system));
        }
        let held = |i: usize| motion.rows.iter().any(|row| !row.jacobian[i].is_zero());
        let errors = (0..motion.n).filter(|&i| self.mass[i].iter().all(Series::is_zero) && !held(i));
        let errors = errors.map(|i| scene.massless(i)).reduce(|mut all, error| {
            all.combine(error);
            all
        });
        errors.map_or(Ok(self), Err)
    }
}
