//! The operands of a phase's convolutions, one column each, and the sums that every order begins
//! with.

use super::convolution::Sums;
use super::ops::{Coefficients, Storage, Values};
use super::{LANES, ORDERS, SeriesOps};
use crate::scalar::Real;
use crate::scalar::dispatch::vectorised;

/// One order of all columns: side by side, so that vector instructions sum them.
type Row<S, const BLOCKS: usize> = [[S; LANES]; BLOCKS];

/// What an operation keeps of the values, away from those of others: compilers would gather them
/// into vectors, which costs more than the arithmetic.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Kept<S>([S; 2]);

/// What a Taylor expansion keeps: the operands of its convolutions up to the last order computed.
pub trait TaylorTape<S: Real>: Default {
    /// How many convolutions it has room for.
    const COLUMNS: usize;
    /// Order 0.
    fn values(&mut self) -> impl SeriesOps<S>;
    /// Order n > 0, one above the last; n < [`ORDERS`].
    fn coefficients(&mut self, n: usize) -> impl SeriesOps<S>;
}

/// Two series a, b for each convolution Σ aₖ bₙ₋ₖ, in `BLOCKS` blocks of [`LANES`] columns.
///
/// Rows begin with lines of the cache: half of their reads would touch two.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct Tape<S, const BLOCKS: usize> {
    left: [Row<S, BLOCKS>; ORDERS],
    right: [Row<S, BLOCKS>; ORDERS],
    kept: [[Kept<S>; LANES]; BLOCKS],
    /// Σ aₖ bₙ₋ₖ over 0 < k < n.
    sums: Row<S, BLOCKS>,
    /// Of an even order n, Σ aₖ bₙ₊₁₋ₖ over 2 < k < n − 1.
    ahead: Row<S, BLOCKS>,
}

impl<S: Real, const BLOCKS: usize> Default for Tape<S, BLOCKS> {
    /// An empty one.
    fn default() -> Self {
        let row = [zero(); BLOCKS];
        let kept = [[Kept([S::ratio(0, 1); 2]); LANES]; BLOCKS];
        Self { left: [row; ORDERS], right: [row; ORDERS], kept, sums: row, ahead: row }
    }
}

impl<S: Real, const BLOCKS: usize> TaylorTape<S> for Tape<S, BLOCKS> {
    const COLUMNS: usize = LANES * BLOCKS;

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

impl<S: Real, const BLOCKS: usize> Storage<S> for Tape<S, BLOCKS> {
    #[inline(always)]
    fn keep(&mut self, column: usize, a: S, b: S) {
        self.kept[column / LANES][column % LANES] = Kept([a, b]);
    }

    #[inline(always)]
    fn kept(&self, column: usize) -> (S, S) {
        self.kept[column / LANES][column % LANES].0.into()
    }

    #[inline(always)]
    fn sum(&self, column: usize) -> S {
        self.sums[column / LANES][column % LANES]
    }

    #[inline(always)]
    fn write(&mut self, n: usize, column: usize, a: S, b: S) {
        let (block, lane) = (column / LANES, column % LANES);
        (self.left[n][block][lane], self.right[n][block][lane]) = (a, b);
    }
}

impl<S: Real, const BLOCKS: usize> Tape<S, BLOCKS> {
    /// Not part of an order's code, which reads the sums one by one: in it they would not be summed
    /// side by side.
    #[inline(never)]
    fn convolve(&mut self, n: usize) {
        let Self { left, right, sums, ahead, .. } = self;
        vectorised(Sums { left, right, sums, ahead, n });
    }
}

#[inline(always)]
fn zero<S: Real>() -> [S; LANES] {
    [S::ratio(0, 1); LANES]
}
