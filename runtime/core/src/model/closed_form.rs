//! The equations of a closed form on any number.

use super::{BarSystem, Energy};
use crate::scalar::{Real, Scalar};

/// The equations of a closed form, most of them on numbers that need no order, as those side by
/// side; implemented by the derive macro, one type for each closed form.
pub trait ClosedForm<M: BarSystem, const N: usize>: 'static {
    /// How many entries of the reduced state are coordinates; they come first.
    const COORDINATES: usize;
    /// How many entries are rates; they follow.
    const RATES: usize;
    /// The derivative of a reduced state.
    fn derivative<S: Real>(constants: &M::Constants<S>, state: &[S; N]) -> [S; N];
    /// The reduced state of a full one.
    fn restrict<S: Real>(state: &M::State<S>) -> [S; N];
    /// The least pivot of the elimination, relative to its natural size; 1 where there is none.
    fn pivot<S: Scalar>(_: &M::Constants<S>, _: &[S; N]) -> S {
        S::ratio(1, 1)
    }
    /// T and V with the eliminated coordinates substituted, so that no digits cancel.
    fn energy<S: Real>(constants: &M::Constants<S>, state: &[S; N]) -> Energy<S>;
    /// Puts the constants of one model, one by one, into those of another scalar: of many models,
    /// say, each in its place.
    fn fill<S: Real, T: Real>(constants: &mut M::Constants<S>, of: &M::Constants<T>, put: impl Fn(&mut S, T));
}

/// The least magnitude among pivots relative to their natural sizes; 1 without pivots.
pub fn least<S: Scalar, const P: usize>(pivots: [S; P]) -> S {
    pivots.into_iter().map(S::abs).fold(S::ratio(1, 1), |least, p| if p < least { p } else { least })
}
