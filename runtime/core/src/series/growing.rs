//! A tape whose number of columns is known when it is made.

use super::convolution::{Block, Convolution, Sums};
use super::ops::{Coefficients, Storage, Values};
use super::{LANES, ORDERS, SeriesOps};
use crate::scalar::Real;
use crate::scalar::dispatch::{Vectorised, vectorised};

/// A [`Tape`](super::Tape) of any number of columns: the same sums in the same order.
#[derive(Clone, Debug)]
pub struct TapeOf<S> {
    left: Vec<Block<S>>,
    right: Vec<Block<S>>,
    kept: Vec<[S; 2]>,
    sums: Vec<Block<S>>,
    ahead: Vec<Block<S>>,
}

/// The sums of an order of any number of blocks.
struct Long<'a, S> {
    of: Convolution<'a, S>,
    n: usize,
}

impl<S: Real> Vectorised for Long<'_, S> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        self.of.sum::<FUSED>(self.n);
    }
}

/// One order of all columns.
#[derive(Debug)]
pub struct Row<'a, S> {
    /// aₙ of each column.
    pub left: &'a mut [S],
    /// bₙ of each column.
    pub right: &'a mut [S],
    /// What each operation keeps of the values.
    pub kept: &'a [[S; 2]],
    /// Σ aₖ bₙ₋ₖ over 0 < k < n of each column.
    pub sums: &'a [S],
}

impl<S: Real> TapeOf<S> {
    /// An empty one.
    pub fn new(columns: usize) -> Self {
        let (blocks, zero) = (columns.div_ceil(LANES), S::ratio(0, 1));
        let row = vec![[zero; LANES]; blocks];
        let operands = vec![[zero; LANES]; blocks * ORDERS];
        Self {
            left: operands.clone(),
            right: operands,
            kept: vec![[zero; 2]; columns],
            sums: row.clone(),
            ahead: row,
        }
    }

    /// Order 0.
    pub fn values(&mut self) -> impl SeriesOps<S> {
        Values(self)
    }

    /// Order n > 0, one above the last; n < [`ORDERS`].
    pub fn coefficients(&mut self, n: usize) -> impl SeriesOps<S> {
        self.convolve(n);
        Coefficients { tape: self, n }
    }

    /// The same for code that does an order's operations by itself: each writes its aₙ, bₙ.
    pub fn row(&mut self, n: usize) -> Row<'_, S> {
        self.convolve(n);
        let blocks = self.sums.len();
        let Self { left, right, kept, sums, .. } = self;
        let part = n * blocks..(n + 1) * blocks;
        Row {
            left: left[part.clone()].as_flattened_mut(),
            right: right[part].as_flattened_mut(),
            kept,
            sums: sums.as_flattened(),
        }
    }

    /// By code for as many blocks as there are, where they are few: its loops have no counters.
    fn convolve(&mut self, n: usize) {
        match self.sums.len() {
            1 => self.sum::<1>(n),
            2 => self.sum::<2>(n),
            3 => self.sum::<3>(n),
            4 => self.sum::<4>(n),
            5 => self.sum::<5>(n),
            6 => self.sum::<6>(n),
            7 => self.sum::<7>(n),
            8 => self.sum::<8>(n),
            _ => {
                let Self { left, right, sums, ahead, .. } = self;
                vectorised(Long { of: Convolution { left, right, sums, ahead }, n });
            }
        }
    }

    #[inline(never)]
    fn sum<const BLOCKS: usize>(&mut self, n: usize) {
        let Self { left, right, sums, ahead, .. } = self;
        let [left, right] =
            [&*left, &*right].map(|operands| operands.as_chunks::<BLOCKS>().0.first_chunk::<ORDERS>());
        let [sums, ahead] = [sums, ahead].map(|sums| sums.first_chunk_mut::<BLOCKS>());
        if let (Some(left), Some(right), Some(sums), Some(ahead)) = (left, right, sums, ahead) {
            vectorised(Sums { left, right, sums, ahead, n });
        }
    }

    fn block_and_lane(&self, n: usize, column: usize) -> (usize, usize) {
        (n * self.sums.len() + column / LANES, column % LANES)
    }
}

impl<S: Real> Storage<S> for TapeOf<S> {
    fn keep(&mut self, column: usize, a: S, b: S) {
        self.kept[column] = [a, b];
    }

    fn kept(&self, column: usize) -> (S, S) {
        self.kept[column].into()
    }

    fn sum(&self, column: usize) -> S {
        self.sums[column / LANES][column % LANES]
    }

    fn write(&mut self, n: usize, column: usize, a: S, b: S) {
        let (row, lane) = self.block_and_lane(n, column);
        (self.left[row][lane], self.right[row][lane]) = (a, b);
    }
}
