//! Tsitouras's explicit Runge–Kutta pair of order 5(4) with dense output of order 4, for loose
//! tolerances (*Computers & Mathematics with Applications* 62 (2011) 770).

mod coefficients;
mod pair;
#[cfg(test)]
mod tests;

use super::explicit::Explicit;

/// k₁ … k₇, of which the last is f(y₁).
const SLOPES: usize = 7;

/// An integration by Tsitouras's pair: 6 evaluations of f for each trial, none for the dense
/// output.
pub type Tsit5<F, S, const N: usize> = Explicit<F, Tsitouras, S, N, SLOPES>;

/// The tableau of Tsitouras's pair.
pub enum Tsitouras {}
