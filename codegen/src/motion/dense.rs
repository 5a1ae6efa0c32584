//! M, h and Q, every entry written out.

use super::action::Scene;
use super::alike::{self, BodySums, Class};
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
    pub fn derive(scene: &Scene, motion: &Motion) -> syn::Result<Self> {
        let n = motion.n;
        let mut dense = Self {
            mass: vec![vec![Series::zero(); n]; n],
            velocity_terms: vec![Series::zero(); n],
            forces: vec![Series::zero(); n],
        };
        dense.load(scene, motion);
        dense.inertias(&motion.inertias, scene.system.gravity.as_ref());
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

    /// `M = Σ m J_cᵀ J_c + I ωᵀ ω`, `h = Σ m J_cᵀ J̇_c u` and the weights, class by class of what
    /// moves alike: no sum over all bodies for each pair of coordinates.
    fn inertias(&mut self, inertias: &[Inertia], gravity: Option<&[Series; 2]>) {
        let n = self.forces.len();
        let mut masses =
            BodySums::from_values(inertias.iter().map(|body| [body.mass.clone(), body.inertia.clone()]));
        let mut biases = BodySums::from_values(inertias.iter().map(|body| {
            let bias = body.centre.each_ref().map(|x| bias(x, n));
            bias.map(|x| &body.mass * &x)
        }));
        let classes: Vec<Vec<Class>> = (0..n).map(|i| alike::classes(inertias, i)).collect();
        // From the last, so that what moves of a chain grows.
        for i in (0..n).rev() {
            for class in &classes[i] {
                let momenta = Momenta::new(class, masses.over(&class.bodies));
                for j in 0..=i {
                    let entry = momenta.along(&classes[j], &mut masses);
                    self.mass[i][j] += entry;
                }
                self.velocity_terms[i] += dot(&class.slope, &biases.over(&class.bodies));
                if let Some(gravity) = gravity {
                    self.forces[i] += dot(&momenta.linear, gravity);
                }
            }
            for j in 0..i {
                self.mass[j][i] = self.mass[i][j].clone();
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

/// The momenta of a class for a unit rate of its coordinate.
struct Momenta<'a> {
    class: &'a Class,
    linear: [Series; 2],
    angular: Series,
}

impl<'a> Momenta<'a> {
    fn new(class: &'a Class, [mass, inertia]: [Series; 2]) -> Self {
        let linear = class.slope.each_ref().map(|slope| &mass * slope);
        Self { class, linear, angular: &inertia * &class.spin }
    }

    /// Along the classes of another coordinate: what the two have in common of M.
    fn along(&self, others: &[Class], masses: &mut BodySums<2>) -> Series {
        let mut sum = Series::zero();
        for other in others {
            let common = self.class.bodies.common(&other.bodies);
            if common.is_empty() {
                continue;
            }
            let part;
            let Self { linear, angular, .. } = if common == self.class.bodies {
                self
            } else {
                part = Self::new(self.class, masses.over(&common));
                &part
            };
            sum += dot(linear, &other.slope) + &(angular * &other.spin);
        }
        sum
    }
}
