//! Accelerations and multipliers, or rates and impulses, from one dense factorisation.

use crate::numerics::linear::{Factors, negligible};
use crate::scene::{Row, Scene};
use crate::tape::Series;
use liftoff_core::scalar::Scalar;

/// Maximal coordinates and their rates at a time.
#[derive(Clone, Debug)]
pub(crate) struct State<S> {
    pub t: S,
    pub q: Vec<S>,
    pub v: Vec<S>,
}

/// A constraint by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slot {
    Joint(usize),
    Contact(usize),
    Slip(usize),
}

impl<S: Scalar> Scene<S> {
    pub(crate) fn slot(&self, slot: Slot) -> &Row {
        match slot {
            Slot::Joint(i) => &self.joints[i],
            Slot::Contact(i) => &self.contacts[i].row,
            Slot::Slip(i) => self.contacts[i].slip.as_ref().unwrap_or(&self.contacts[i].row),
        }
    }

    /// The joints, and these contacts closed: rough ones without slip.
    pub(crate) fn slots(&self, closed: &[usize]) -> Vec<Slot> {
        let joints = (0..self.joints.len()).map(Slot::Joint);
        let contacts = closed.iter().map(|&i| Slot::Contact(i));
        let slips = closed.iter().filter(|&&i| self.contacts[i].slip.is_some()).map(|&i| Slot::Slip(i));
        joints.chain(contacts).chain(slips).collect()
    }
}

/// The matrix of accelerations and multipliers for closed rows.
pub(crate) struct Kkt<S> {
    pub slots: Vec<Slot>,
    n: usize,
    pub factors: Factors<S>,
}

/// Accelerations and multipliers, or rates and impulses.
pub(crate) struct Response<S> {
    pub a: Vec<S>,
    pub multipliers: Vec<S>,
    /// How far the rows contradict one another.
    pub contradiction: f64,
    /// The size of what was asked.
    pub size: f64,
}

impl<S: Scalar> Response<S> {
    /// Whether the rows contradict one another, beside the largest right-hand side of a motion.
    pub fn contradicts(&self, largest: f64) -> bool {
        self.contradiction > negligible::<S>().sqrt() * largest.max(self.size)
    }
}

impl<S: Scalar> Kkt<S> {
    pub fn assemble(scene: &Scene<S>, series: &Series<S>, slots: Vec<Slot>) -> Self {
        let n = scene.n();
        let size = n + slots.len();
        let mut matrix = vec![vec![S::ZERO; size]; size];
        for i in 0..n {
            matrix[i][i] = scene.masses[i];
        }
        for (r, &slot) in slots.iter().enumerate() {
            for &(i, node) in &scene.slot(slot).gradient {
                let entry = series.get(node, 0);
                matrix[n + r][i] = entry;
                matrix[i][n + r] = -entry;
            }
        }
        Self { slots, n, factors: Factors::factorise(matrix, n) }
    }

    /// M a − Jᵀ λ = force, J a = targets.
    pub fn solve(&self, force: &[S], targets: &[S]) -> Response<S> {
        let right: Vec<S> = force.iter().chain(targets).copied().collect();
        let (mut a, contradiction, size) = self.factors.solve(&right);
        let multipliers = a.split_off(self.n);
        Response { a, multipliers, contradiction, size }
    }
}
