//! The operands of a phase's convolutions, one column each, and the sums that every order begins with.

use super::ops::{Coefficients, Storage, Values};
use super::{LANES, ORDERS, SeriesOps};
use crate::scalar::Real;

/// One order of all columns: side by side, so that vector instructions sum them.
type Row<S, const BLOCKS: usize> = [[S; LANES]; BLOCKS];

/// What an operation keeps of the values, away from those of others: compilers would gather them into vectors, which costs
/// more than the arithmetic.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Kept<S>([S; 2]);

/// What a Taylor expansion keeps: the operands of its convolutions up to the last order computed.
pub trait TaylorTape<S: Real>: Default {
    /// Order 0.
    fn values(&mut self) -> impl SeriesOps<S>;
    /// Order n > 0, one above the last; n < [`ORDERS`].
    fn coefficients(&mut self, n: usize) -> impl SeriesOps<S>;
}

/// Two series a, b for each convolution Σ aₖ bₙ₋ₖ, in `BLOCKS` blocks of [`LANES`] columns.
///
/// An even order n sums for itself and, as far as coefficients are known, for the next: one that has been read serves both.
/// The newest are added last: what has just been written number by number cannot be read as a vector before it has left the
/// processor's store buffer.
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
    /// Not part of an order's code, which reads the sums one by one: in it they would not be summed side by side.
    #[inline(never)]
    fn convolve(&mut self, n: usize) {
        for block in (0..BLOCKS).step_by(2) {
            // As many sums at once as hide the latency of an addition.
            if block + 1 < BLOCKS {
                self.sum_blocks(n, [block, block + 1]);
            } else {
                self.sum_blocks(n, [block]);
            }
        }
    }

    #[inline(always)]
    fn sum_blocks<const B: usize>(&mut self, n: usize, blocks: [usize; B]) {
        match n {
            0 | 1 => blocks.iter().for_each(|&i| self.sums[i] = zero()),
            2 => blocks
                .iter()
                .for_each(|&i| self.sums[i] = products(&self.left[1][i], &self.right[1][i], zero())),
            3 => blocks.iter().for_each(|&i| self.sums[i] = self.newest(n, i, zero())),
            _ if n.is_multiple_of(2) => self.sum_two(n, blocks),
            _ => self.sum_rest(n, blocks),
        }
    }

    /// An even order, and the next without its newest.
    #[inline(always)]
    fn sum_two<const B: usize>(&mut self, n: usize, blocks: [usize; B]) {
        let [mut sums, mut ahead] = [[zero(); B]; 2];
        let right = self.right[2..n - 1].windows(3).rev().step_by(2);
        for (a, b) in self.left[3..n - 1].chunks_exact(2).zip(right) {
            for k in 0..2 {
                for (i, &block) in blocks.iter().enumerate() {
                    sums[i] = products(&a[k][block], &b[1 - k][block], sums[i]);
                    ahead[i] = products(&a[k][block], &b[2 - k][block], ahead[i]);
                }
            }
        }
        for (i, &block) in blocks.iter().enumerate() {
            let sum = products(&self.left[2][block], &self.right[n - 2][block], sums[i]);
            (self.sums[block], self.ahead[block]) = (self.newest(n, block, sum), ahead[i]);
        }
    }

    /// An odd order, of which the one before has summed what it knew.
    #[inline(always)]
    fn sum_rest<const B: usize>(&mut self, n: usize, blocks: [usize; B]) {
        for block in blocks {
            let sum = products(&self.left[2][block], &self.right[n - 2][block], self.ahead[block]);
            let sum = products(&self.left[n - 2][block], &self.right[2][block], sum);
            self.sums[block] = self.newest(n, block, sum);
        }
    }

    #[inline(always)]
    fn newest(&self, n: usize, block: usize, sum: [S; LANES]) -> [S; LANES] {
        let sum = products(&self.left[1][block], &self.right[n - 1][block], sum);
        products(&self.left[n - 1][block], &self.right[1][block], sum)
    }
}

#[inline(always)]
fn products<S: Real>(a: &[S; LANES], b: &[S; LANES], sum: [S; LANES]) -> [S; LANES] {
    core::array::from_fn(|lane| a[lane].mul_add(b[lane], sum[lane]))
}

#[inline(always)]
fn zero<S: Real>() -> [S; LANES] {
    [S::ratio(0, 1); LANES]
}
