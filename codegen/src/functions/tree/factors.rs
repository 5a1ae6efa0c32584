//! What the elimination of a tree from its leaves makes of its masses, whatever acts on them.

use super::geometry::TreeGeometry;
use super::vector::{Vector, dot_add, normal};
use crate::program::{Id, Lowering, Program};

/// A symmetric matrix: xx, xy, yy.
pub type Symmetric = [Id; 3];

/// What the elimination of each branch, and at each base, divides by.
pub(super) struct Factors {
    pub branches: Vec<Factor>,
    /// Σ A of what begins at each base.
    pub bases: Vec<Symmetric>,
}

/// The elimination of a branch.
pub(super) struct Factor {
    /// b/J.
    pub k: Vector,
    /// 1/J.
    pub inverse: Id,
    /// A.
    pub inertia: Symmetric,
}

/// A branch with those eliminated that it carries.
struct ArticulatedInertia {
    inertia: Symmetric,
    moment: Vector,
    turning: Id,
}

impl Factors {
    pub fn lower(lowering: &mut Lowering, geometry: &TreeGeometry) -> Self {
        let tree = geometry.tree;
        let masses: Vec<[Id; 2]> =
            tree.branches.iter().map(|b| [b.mass(), b.inertia()].map(|s| lowering.series(&s))).collect();
        let program = lowering.program();
        let zero = program.integer(0);
        let start = |&[mass, turning]: &[Id; 2]| ArticulatedInertia {
            inertia: [mass, zero, mass],
            moment: [zero; 2],
            turning,
        };
        let mut sums: Vec<ArticulatedInertia> = masses.iter().map(start).collect();
        let mut bases = vec![[zero; 3]; tree.bases.len()];
        let mut factors = Vec::new();
        for (i, branch) in tree.branches.iter().enumerate().rev() {
            let factor = sums[i].eliminate(program, geometry, i);
            if let Some(parent) = branch.parent {
                sums[parent].carry(program, factor.inertia, geometry.reach[i]);
            }
            if let Some(base) = branch.base {
                bases[base] = plus(program, bases[base], factor.inertia);
            }
            factors.push(factor);
        }
        factors.reverse();
        Self { branches: factors, bases }
    }
}

impl ArticulatedInertia {
    /// `B += A`, `b += A e⊥`, `J += e⊥ · A e⊥`.
    fn carry(&mut self, program: &mut Program, inertia: Symmetric, reach: Vector) {
        let (across, zero) = (normal(program, reach), program.integer(0));
        let moment = times_add(program, inertia, across, [zero; 2]);
        self.inertia = plus(program, self.inertia, inertia);
        self.turning = dot_add(program, across, moment, self.turning);
        self.moment = [0, 1].map(|axis| program.add(self.moment[axis], moment[axis]));
    }

    /// `A = B − b bᵀ/J`, once p⊥ is added to b.
    fn eliminate(&self, program: &mut Program, geometry: &TreeGeometry, branch: usize) -> Factor {
        let moment = geometry.first_normal_add(program, branch, self.moment);
        let one = program.integer(1);
        let inverse = program.div(one, self.turning);
        let k = moment.map(|part| program.mul(part, inverse));
        let [[x, y], minus] = [moment, k.map(|part| program.neg(part))];
        let products = [(x, minus[0]), (x, minus[1]), (y, minus[1])];
        let inertia = [0, 1, 2].map(|i| program.mul_add(products[i].0, products[i].1, self.inertia[i]));
        Factor { k, inverse, inertia }
    }
}

/// A v + w.
pub(super) fn times_add(program: &mut Program, [xx, xy, yy]: Symmetric, v: Vector, w: Vector) -> Vector {
    [dot_add(program, [xx, xy], v, w[0]), dot_add(program, [xy, yy], v, w[1])]
}

fn plus(program: &mut Program, a: Symmetric, b: Symmetric) -> Symmetric {
    [0, 1, 2].map(|i| program.add(a[i], b[i]))
}
