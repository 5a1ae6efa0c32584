//! The sums Σ aₖ bₙ₋ₖ over 0 < k < n of all columns, side by side.
//!
//! An even order n sums for itself and, as far as coefficients are known, for the next: one that
//! has been read serves both. The newest are added last: what has just been written number by
//! number cannot be read as a vector before it has left the processor's store buffer.

use super::{LANES, ORDERS};
use crate::scalar::Real;
use crate::scalar::dispatch::Vectorised;

/// [`LANES`] columns of one order.
pub(super) type Block<S> = [S; LANES];

/// Operands, order by order, and sums, as many blocks of each as there are sums.
pub(super) struct Convolution<'a, S> {
    pub left: &'a [Block<S>],
    pub right: &'a [Block<S>],
    pub sums: &'a mut [Block<S>],
    /// Of an even order n, Σ aₖ bₙ₊₁₋ₖ over 2 < k < n − 1.
    pub ahead: &'a mut [Block<S>],
}

/// All sums of an order, of operands that are arrays, so that loops over blocks have no counters.
pub(super) struct Sums<'a, S, const BLOCKS: usize> {
    pub left: &'a [[Block<S>; BLOCKS]; ORDERS],
    pub right: &'a [[Block<S>; BLOCKS]; ORDERS],
    pub sums: &'a mut [Block<S>; BLOCKS],
    pub ahead: &'a mut [Block<S>; BLOCKS],
    pub n: usize,
}

impl<S: Real, const BLOCKS: usize> Vectorised for Sums<'_, S, BLOCKS> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { left, right, sums, ahead, n } = self;
        let [left, right] = [left, right].map(|operands| operands.as_flattened());
        Convolution { left, right, sums, ahead }.sum::<FUSED>(n);
    }
}

impl<S: Real> Convolution<'_, S> {
    /// Those of an order.
    #[inline(always)]
    pub fn sum<const FUSED: bool>(mut self, n: usize) {
        let blocks = self.sums.len();
        for block in (0..blocks).step_by(2) {
            // As many sums at once as hide the latency of an addition.
            if block + 1 < blocks {
                self.sum_blocks::<_, FUSED>(n, [block, block + 1]);
            } else {
                self.sum_blocks::<_, FUSED>(n, [block]);
            }
        }
    }

    #[inline(always)]
    fn left(&self, order: usize, block: usize) -> &Block<S> {
        &self.left[order * self.sums.len() + block]
    }

    #[inline(always)]
    fn right(&self, order: usize, block: usize) -> &Block<S> {
        &self.right[order * self.sums.len() + block]
    }

    #[inline(always)]
    fn sum_blocks<const B: usize, const FUSED: bool>(&mut self, n: usize, blocks: [usize; B]) {
        // Loops, as closures are functions of their own.
        match n {
            0 | 1 => {
                for i in blocks {
                    self.sums[i] = zero();
                }
            }
            2 => {
                for i in blocks {
                    self.sums[i] = products::<_, FUSED>(self.left(1, i), self.right(1, i), zero());
                }
            }
            3 => {
                for i in blocks {
                    self.sums[i] = self.newest::<FUSED>(n, i, zero());
                }
            }
            _ if n.is_multiple_of(2) => self.sum_two::<_, FUSED>(n, blocks),
            _ => self.sum_rest::<_, FUSED>(n, blocks),
        }
    }

    /// An even order, and the next without its newest.
    #[inline(always)]
    fn sum_two<const B: usize, const FUSED: bool>(&mut self, n: usize, blocks: [usize; B]) {
        let [mut sums, mut ahead] = [[zero(); B]; 2];
        let row = self.sums.len();
        // aₖ and aₖ₊₁ by bₙ₋ₖ₋₁, bₙ₋ₖ and bₙ₋ₖ₊₁, k = 3, 5, …
        for (k, a) in (3..).step_by(2).zip(self.left[3 * row..(n - 1) * row].chunks_exact(2 * row)) {
            let b = &self.right[(n - k - 1) * row..][..3 * row];
            for odd in 0..2 {
                for (i, &block) in blocks.iter().enumerate() {
                    let a = &a[odd * row + block];
                    sums[i] = products::<_, FUSED>(a, &b[(1 - odd) * row + block], sums[i]);
                    ahead[i] = products::<_, FUSED>(a, &b[(2 - odd) * row + block], ahead[i]);
                }
            }
        }
        for (i, &block) in blocks.iter().enumerate() {
            let sum = products::<_, FUSED>(self.left(2, block), self.right(n - 2, block), sums[i]);
            (self.sums[block], self.ahead[block]) = (self.newest::<FUSED>(n, block, sum), ahead[i]);
        }
    }

    /// An odd order, of which the one before has summed what it knew.
    #[inline(always)]
    fn sum_rest<const B: usize, const FUSED: bool>(&mut self, n: usize, blocks: [usize; B]) {
        for block in blocks {
            let sum = products::<_, FUSED>(self.left(2, block), self.right(n - 2, block), self.ahead[block]);
            let sum = products::<_, FUSED>(self.left(n - 2, block), self.right(2, block), sum);
            self.sums[block] = self.newest::<FUSED>(n, block, sum);
        }
    }

    #[inline(always)]
    fn newest<const FUSED: bool>(&self, n: usize, block: usize, sum: Block<S>) -> Block<S> {
        let sum = products::<_, FUSED>(self.left(1, block), self.right(n - 1, block), sum);
        products::<_, FUSED>(self.left(n - 1, block), self.right(1, block), sum)
    }
}

#[inline(always)]
fn products<S: Real, const FUSED: bool>(a: &[S; LANES], b: &[S; LANES], sum: [S; LANES]) -> [S; LANES] {
    core::array::from_fn(|lane| match FUSED {
        true => a[lane].fused_mul_add(b[lane], sum[lane]),
        false => a[lane].mul_add(b[lane], sum[lane]),
    })
}

#[inline(always)]
fn zero<S: Real>() -> [S; LANES] {
    [S::ratio(0, 1); LANES]
}
