//! The operands of a phase's convolutions for many motions side by side: what is summed together is
//! the same sum of all of them, not the columns of one.

use super::ops::{Coefficients, Storage, Values};
use super::{ORDERS, SeriesOps, TaylorTape};
use crate::scalar::Real;

/// Sums that are computed at once: as many as hide the latency of an addition.
const TOGETHER: usize = 4;

/// Two series a, b for each convolution Σ aₖ bₙ₋ₖ, coefficient by coefficient.
///
/// As in a [`Tape`](super::Tape), an even order sums for the next too: what is loaded serves both.
#[derive(Clone, Debug)]
pub struct Columns<S, const C: usize> {
    left: [[S; C]; ORDERS],
    right: [[S; C]; ORDERS],
    kept: [[S; 2]; C],
    /// Σ aₖ bₙ₋ₖ over 0 < k < n.
    sums: [S; C],
    /// Of an even order n, Σ aₖ bₙ₊₁₋ₖ over 1 < k < n.
    ahead: [S; C],
}

impl<S: Real, const C: usize> Default for Columns<S, C> {
    /// Empty ones.
    fn default() -> Self {
        let zero = S::ratio(0, 1);
        let row = [zero; C];
        Self { left: [row; ORDERS], right: [row; ORDERS], kept: [[zero; 2]; C], sums: row, ahead: row }
    }
}

impl<S: Real, const C: usize> TaylorTape<S> for Columns<S, C> {
    const COLUMNS: usize = C;

    #[inline(always)]
    fn values(&mut self) -> impl SeriesOps<S> {
        Values(self)
    }

    #[inline(always)]
    fn coefficients(&mut self, n: usize) -> impl SeriesOps<S> {
        self.convolve(n);
        Coefficients { tape: self, n }
    }
}

impl<S: Real, const C: usize> Storage<S> for Columns<S, C> {
    #[inline(always)]
    fn keep(&mut self, column: usize, a: S, b: S) {
        self.kept[column] = [a, b];
    }

    #[inline(always)]
    fn kept(&self, column: usize) -> (S, S) {
        self.kept[column].into()
    }

    #[inline(always)]
    fn sum(&self, column: usize) -> S {
        self.sums[column]
    }

    #[inline(always)]
    fn write(&mut self, n: usize, column: usize, a: S, b: S) {
        (self.left[n][column], self.right[n][column]) = (a, b);
    }
}

impl<S: Real, const C: usize> Columns<S, C> {
    #[inline(always)]
    fn convolve(&mut self, n: usize) {
        if n == 1 {
            self.sums = [S::ratio(0, 1); C];
            self.ahead = self.sums;
        } else if n.is_multiple_of(2) {
            let whole = C - C % TOGETHER;
            (0..whole).step_by(TOGETHER).for_each(|first| self.sum_two::<TOGETHER>(n, first));
            match C - whole {
                3 => self.sum_two::<3>(n, whole),
                2 => self.sum_two::<2>(n, whole),
                1 => self.sum_two::<1>(n, whole),
                _ => {}
            }
        } else {
            for c in 0..C {
                let sum = self.left[1][c].mul_add(self.right[n - 1][c], self.ahead[c]);
                self.sums[c] = self.left[n - 1][c].mul_add(self.right[1][c], sum);
            }
        }
    }

    /// An even order, and the next without its newest.
    #[inline(always)]
    fn sum_two<const G: usize>(&mut self, n: usize, first: usize) {
        let zero = S::ratio(0, 1);
        let (left, right) = (&self.left[1..n], &self.right[1..n]);
        let mut above: [S; G] = core::array::from_fn(|i| right[n - 2][first + i]);
        let mut sums: [S; G] = core::array::from_fn(|i| left[0][first + i] * above[i]);
        let mut ahead = [zero; G];
        for (a, b) in left[1..].iter().zip(right[..n - 2].iter().rev()) {
            for i in 0..G {
                let (a, b) = (a[first + i], b[first + i]);
                sums[i] = a.mul_add(b, sums[i]);
                ahead[i] = a.mul_add(above[i], ahead[i]);
                above[i] = b;
            }
        }
        self.sums[first..first + G].copy_from_slice(&sums);
        self.ahead[first..first + G].copy_from_slice(&ahead);
    }
}
