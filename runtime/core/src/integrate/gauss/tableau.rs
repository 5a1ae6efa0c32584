//! The coefficients μᵢⱼ = aᵢⱼ/bⱼ, in which the method is Lⱼ = h bⱼ f(y + Σ μⱼₖ Lₖ), y₁ = y + Σ Lⱼ,
//! and symplectic where μᵢⱼ + μⱼᵢ = 1 exactly (Antoñana, Makazaga, Murua, *Numer. Algorithms* 76
//! (2017) 861).
//!
//! With xᵢ the zeros of P_s, the Lagrange polynomials on [0, 1] are ℓⱼ = bⱼ Σ (2k+1) Pₖ(xⱼ) Pₖ, k <
//! s, and ∫ (2k+1) Pₖ dθ = ½ (Pₖ₊₁ − Pₖ₋₁), P₋₁ = −1, so that μᵢⱼ = ½ + ½ Σ (Pₖ(xⱼ) Pₖ₊₁(xᵢ) −
//! Pₖ₊₁(xⱼ) Pₖ(xᵢ)), k < s − 1, and h y′ = Σ (2k+1) mₖ Pₖ with the modes mₖ = Σ Pₖ(xⱼ) Lⱼ.

use super::legendre::{nodes, round, values};
/// L₁ … L_s.
pub(super) type Stages<const N: usize, const S: usize> = [[f64; N]; S];

#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::{DoubleDouble, Real};

/// A multiple of this is less than 8 with all its bits, and so is what it lacks to 1.
const GRAIN: f64 = 8.0 * f64::EPSILON;

/// The method with `S` stages.
pub(super) struct Tableau<const S: usize> {
    pub(super) nodes: [f64; S],
    pub(super) weights: [f64; S],
    pub(super) mu: [[f64; S]; S],
    /// Pₖ(xⱼ), row k.
    values: [[f64; S]; S],
    /// For a step as long as the last: what its Lⱼ, continued, are now.
    continued: [[f64; S]; S],
}

impl<const S: usize> Tableau<S> {
    pub(super) fn new() -> Self {
        let nodes = nodes::<S>();
        let at = nodes.map(|(x, _)| values(x));
        let mut mu = [[0.5; S]; S];
        for i in 0..S {
            for j in 0..i {
                let term = |k: usize| at[j][k] * at[i][k + 1] - at[j][k + 1] * at[i][k];
                let half = DoubleDouble::ratio(1, 2);
                let sum = (0..S - 1).fold(half, |sum, k| sum + half * term(k));
                mu[i][j] = GRAIN * (round(sum) / GRAIN).round();
                mu[j][i] = 1.0 - mu[i][j];
            }
        }
        let values = core::array::from_fn(|k| at.map(|p| round(p[k])));
        let (nodes, weights) = (nodes.map(|(x, _)| round(x)), nodes.map(|(_, b)| round(b)));
        let mut tableau = Self { nodes, weights, mu, values, continued: [[0.0; S]; S] };
        tableau.continued = tableau.continued(1.0);
        tableau
    }

    /// Lⱼ for a slope that does not change over the step.
    pub(super) fn constant<const N: usize>(&self, h: f64, slope: &[f64; N]) -> Stages<N, S> {
        self.weights.map(|b| slope.map(|f| h * b * f))
    }

    /// Lⱼ for a slope with these modes.
    pub(super) fn of_modes<const N: usize>(&self, modes: &[[f64; N]]) -> Stages<N, S> {
        core::array::from_fn(|j| {
            core::array::from_fn(|i| {
                let term = |(k, m): (usize, &[f64; N])| (2 * k + 1) as f64 * self.values[k][j] * m[i];
                self.weights[j] * modes.iter().enumerate().map(term).sum::<f64>()
            })
        })
    }

    /// m₀, m₁, ….
    pub(super) fn modes<const N: usize>(&self, l: &Stages<N, S>) -> Stages<N, S> {
        self.values.map(|p| core::array::from_fn(|i| (0..S).map(|j| p[j] * l[j][i]).sum()))
    }

    /// The coefficient of the k-th polynomial in h y′.
    pub(super) fn coefficient<const N: usize>(&self, k: usize, l: &Stages<N, S>) -> [f64; N] {
        let (order, p) = ((2 * k + 1) as f64, &self.values[k]);
        core::array::from_fn(|i| order * (0..S).map(|j| p[j] * l[j][i]).sum::<f64>())
    }

    /// The Lⱼ of the last step continued over one that is longer by `ratio`.
    pub(super) fn continuation<const N: usize>(&self, l: &Stages<N, S>, ratio: f64) -> Stages<N, S> {
        // Steps are equal up to the rounding of times.
        let rows = if (ratio - 1.0).abs() < 1e-6 { self.continued } else { self.continued(ratio) };
        rows.map(|row| core::array::from_fn(|i| (0..S).map(|j| row[j] * l[j][i]).sum()))
    }

    /// Row i: ratio · bᵢ Σ (2k+1) Pₖ(xⱼ) Pₖ(1 + ratio (1 + xᵢ)).
    fn continued(&self, ratio: f64) -> [[f64; S]; S] {
        core::array::from_fn(|i| {
            let ahead = values(DoubleDouble::from_f64(1.0 + ratio * (1.0 + self.nodes[i]))).map(round);
            core::array::from_fn(|j| {
                let term = |k: usize| (2 * k + 1) as f64 * self.values[k][j] * ahead[k];
                ratio * self.weights[i] * (0..S).map(term).sum::<f64>()
            })
        })
    }
}
