//! Slices as arrays.

use crate::model::Array;
use crate::scalar::{Real, Scalar};

/// A reduced state as an array; not a number where it has another length.
pub(super) fn to_array<S: Scalar, const N: usize>(y: &[S]) -> [S; N] {
    y.try_into().unwrap_or([S::from_f64(f64::NAN); N])
}

/// A slice as an array, not a number beyond its end.
pub(super) fn array<S: Real, A: Array<S>>(values: &[S]) -> A {
    A::from_fn(|i| values.get(i).copied().unwrap_or_else(|| S::from_f64(f64::NAN)))
}
