//! The coefficients μᵢⱼ = aᵢⱼ/bⱼ, in which the method is Lⱼ = h bⱼ f(y + Σ μⱼₖ Lₖ), y₁ = y + Σ Lⱼ, and symplectic where
//! μᵢⱼ + μⱼᵢ = 1 exactly (Antoñana, Makazaga, Murua, *Numer. Algorithms* 76 (2017) 861):
//! μᵢⱼ = ½ + ½ Σ (Pₖ(xⱼ) Pₖ₊₁(xᵢ) − Pₖ₊₁(xⱼ) Pₖ(xᵢ)), k < s − 1.

use super::legendre::{STAGES, Values, nodes, round, values};
use crate::scalar::{DoubleDouble, Real};

pub(super) type Matrix = [[f64; STAGES]; STAGES];

/// A multiple of this is less than 8 with all its bits, and so is what it lacks to 1.
const GRAIN: f64 = 8.0 * f64::EPSILON;

/// The method.
pub(super) struct Tableau {
    pub(super) nodes: [f64; STAGES],
    pub(super) weights: [f64; STAGES],
    pub(super) mu: Matrix,
    /// Pₖ(xⱼ), row k.
    pub(super) modes: Matrix,
    /// For a step as long as the last: what its Lⱼ, continued, are now.
    continued: Matrix,
}

impl Tableau {
    pub(super) fn new() -> Self {
        let nodes = nodes();
        let at: [Values; STAGES] = nodes.map(|(x, _)| values(x));
        let mut mu = [[0.5; STAGES]; STAGES];
        for i in 0..STAGES {
            for j in 0..i {
                let term = |k: usize| at[j][k] * at[i][k + 1] - at[j][k + 1] * at[i][k];
                let half = DoubleDouble::ratio(1, 2);
                let sum = (0..STAGES - 1).fold(half, |sum, k| sum + half * term(k));
                mu[i][j] = GRAIN * (round(sum) / GRAIN).round();
                mu[j][i] = 1.0 - mu[i][j];
            }
        }
        let modes = core::array::from_fn(|k| at.map(|p| round(p[k])));
        let (nodes, weights) = (nodes.map(|(x, _)| round(x)), nodes.map(|(_, b)| round(b)));
        let mut tableau = Self { nodes, weights, mu, modes, continued: [[0.0; STAGES]; STAGES] };
        tableau.continued = tableau.continued(1.0);
        tableau
    }

    /// Row i: what the Lⱼ of the last step, continued, are at the nodes of one that is longer by `ratio`:
    /// bᵢ Σ (2k+1) Pₖ(xⱼ) Pₖ(1 + ratio (1 + xᵢ)), divided by the step.
    fn continued(&self, ratio: f64) -> Matrix {
        core::array::from_fn(|i| {
            let ahead = values(DoubleDouble::from_f64(1.0 + ratio * (1.0 + self.nodes[i]))).map(round);
            core::array::from_fn(|j| {
                let term = |k: usize| (2 * k + 1) as f64 * self.modes[k][j] * ahead[k];
                ratio * self.weights[i] * (0..STAGES).map(term).sum::<f64>()
            })
        })
    }

    /// Lⱼ for a slope that does not change over the step.
    pub(super) fn constant<const N: usize>(&self, h: f64, slope: &[f64; N]) -> [[f64; N]; STAGES] {
        self.weights.map(|b| slope.map(|f| h * b * f))
    }

    /// The coefficient of the highest Legendre polynomial in h y′.
    pub(super) fn highest_mode<const N: usize>(&self, l: &[[f64; N]; STAGES]) -> [f64; N] {
        let (order, values) = ((2 * STAGES - 1) as f64, &self.modes[STAGES - 1]);
        core::array::from_fn(|i| order * (0..STAGES).map(|j| values[j] * l[j][i]).sum::<f64>())
    }

    /// [`Self::continued`], from the table where the ratio is 1 up to the rounding of times.
    pub(super) fn continuation(&self, ratio: f64) -> Matrix {
        if (ratio - 1.0).abs() < 1e-6 { self.continued } else { self.continued(ratio) }
    }
}
