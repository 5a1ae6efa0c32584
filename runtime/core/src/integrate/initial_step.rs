//! The first step, after Hairer's `hinit` (Hairer, Nørsett, Wanner I, II.4) with one explicit Euler
//! step, but free of the unit of time: the state changes by its own size m s at the rate
//! σ = max(‖f‖/m, √(‖Δf/h₀‖/m)), and h = (0.01/m)^(1/p) / σ.

use super::tolerance::{Tolerance, norm};
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::Scalar;

/// h for a method of order p from y with f(y) = `slope`, one evaluation of f; None where f vanishes
/// and any step will do.
pub(super) fn initial_step<S: Scalar, const N: usize>(
    f: &impl Fn(&[S; N]) -> [S; N],
    y: &[S; N],
    slope: &[S; N],
    tolerance: &Tolerance<N>,
    order: f64,
) -> Option<f64> {
    let scale = tolerance.scale(y, y);
    let size = tolerance.measure(y);
    let first = norm(slope, &scale) / size;
    if first == 0.0 {
        return None;
    }
    let probe = 0.01 / first;
    let h = S::from_f64(probe);
    let beyond = f(&core::array::from_fn(|i| h.mul_add(slope[i], y[i])));
    let change = core::array::from_fn(|i| beyond[i] - slope[i]);
    let second = (norm(&change, &scale) / (probe * size)).sqrt();
    // `max` passes over a probe that left the domain of f.
    Some((0.01 / size).powf(1.0 / order) / first.max(second))
}
