//! Dormand and Prince's explicit Runge–Kutta method of order 8(5,3), after Hairer's `dop853.f`
//! (Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.5, II.10).
//!
//! The coefficients carry the accuracy of `f64`; with a wider scalar the rounding of each step is
//! that of `f64`, h · 1e-16.

mod coefficients;
mod dense;
mod pair;
#[cfg(test)]
mod tests;

use super::explicit::Explicit;

/// k₁ … k₁₂ and f(y₁).
const SLOPES: usize = 13;

/// An integration by DOP853: 12 evaluations of f for each step, 11 for each rejected trial, 3 for
/// the dense output.
pub type Dop853<F, S, const N: usize> = Explicit<F, DormandPrince, S, N, SLOPES>;

/// The tableau of DOP853.
pub enum DormandPrince {}
