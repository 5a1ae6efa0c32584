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
    /// The pivots of the elimination, relative to their natural sizes.
    fn pivots<S: Scalar>(_: &M::Constants<S>, _: &[S; N]) -> Pivots<S> {
        Pivots::collect([])
    }
    /// T and V with the eliminated coordinates substituted, so that no digits cancel.
    fn energy<S: Real>(constants: &M::Constants<S>, state: &[S; N]) -> Energy<S>;
    /// Puts the constants of one model, one by one, into those of another scalar: of many models,
    /// say, each in its place.
    fn fill<S: Real, T: Real>(constants: &mut M::Constants<S>, of: &M::Constants<T>, put: impl Fn(&mut S, T));
}

/// Pivots of an elimination, relative to their natural sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pivots<S> {
    /// The least magnitude; 1 without pivots.
    pub least: S,
    /// Which of them are negative, a bit for each: the elimination is singular between two states
    /// where one of them has not the same sign.
    pub negative: u64,
}

impl<S: Scalar> Pivots<S> {
    /// From all of them, in the order in which their bits are.
    pub fn collect(values: impl IntoIterator<Item = S>) -> Self {
        let (mut least, mut negative) = (S::ratio(1, 1), 0);
        for (i, value) in values.into_iter().enumerate() {
            let size = value.abs();
            negative ^= u64::from(value < S::ratio(0, 1)) << (i % 64);
            least = if size < least { size } else { least };
        }
        Self { least, negative }
    }
}
