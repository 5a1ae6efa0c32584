//! Tsitouras's explicit Runge–Kutta pair of order 5(4) with dense output of order 4, for loose tolerances
//! (*Computers & Mathematics with Applications* 62 (2011) 770).

mod coefficients;
mod stages;
#[cfg(test)]
mod tests;

use super::explicit::{Explicit, Pair, Trial};
use super::{Rates, Tolerance};
use crate::scalar::Scalar;

/// k₁ … k₇, of which the last is f(y₁).
const SLOPES: usize = 7;

/// An integration by Tsitouras's pair: 6 evaluations of f for each trial, none for the dense output.
pub type Tsit5<'a, S, const N: usize> = Explicit<'a, Tsitouras, S, N, SLOPES>;

/// The tableau of Tsitouras's pair.
pub enum Tsitouras {}

impl Pair<SLOPES> for Tsitouras {
    const ORDER: f64 = 5.0;
    const ERROR_HAS_END: bool = true;
    const TERMS: usize = 5;
    const DENSE_EVALUATIONS: u64 = 0;

    fn trial<S: Scalar, const N: usize>(
        f: Rates<S, N>,
        y: &[S; N],
        slope: [S; N],
        h: S,
    ) -> Trial<S, N, SLOPES> {
        stages::trial(f, y, slope, h)
    }

    fn error<S: Scalar, const N: usize>(
        trial: &Trial<S, N, SLOPES>,
        tolerance: &Tolerance<N>,
        y0: &[S; N],
        h: S,
    ) -> f64 {
        stages::error(trial, tolerance, y0, h)
    }

    fn dense<S: Scalar, const N: usize>(
        _: Rates<S, N>,
        h: S,
        y0: &[S; N],
        step: &Trial<S, N, SLOPES>,
    ) -> impl IntoIterator<Item = [S; N]> {
        stages::dense(h, y0, step)
    }
}
