//! The operands of a phase's convolutions, one column each, and the sums that every order begins with.

use super::{Coefficients, LANES, ORDERS, Order, Values};
use crate::scalar::Real;

/// One order of all columns: side by side, so that vector instructions sum them.
type Row<S, const BLOCKS: usize> = [[S; LANES]; BLOCKS];

/// What the orders of a series computation leave for those above them.
pub trait Record<S: Real> {
    /// An empty one.
    fn new() -> Self;
    /// Order 0.
    fn values(&mut self) -> impl Order<S>;
    /// Order n > 0, one above the last; n < [`ORDERS`].
    fn coefficients(&mut self, n: usize) -> impl Order<S>;
}

/// Two series a, b for each convolution Σ aₖ bₙ₋ₖ, in `BLOCKS` blocks of [`LANES`] columns.
///
/// Of 0 < k < n an order sums all but the newest coefficients; what these contribute, aₙ b₁ + a₁ bₙ to order n + 1, is kept
/// apart. A row that has just been written number by number cannot be read as a vector before it has left the processor's
/// store buffer, and each order would wait for that.
///
/// Rows begin with lines of the cache: half of their reads would touch two.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct Tape<S, const BLOCKS: usize> {
    pub(super) left: [Row<S, BLOCKS>; ORDERS],
    pub(super) right: [Row<S, BLOCKS>; ORDERS],
    /// What operations keep of the values.
    pub(super) kept: [Row<S, BLOCKS>; 2],
    /// a₁ and b₁, once order 1 is complete.
    pub(super) first: [Row<S, BLOCKS>; 2],
    /// aₙ b₁ + a₁ bₙ of the last order n > 1.
    pub(super) newest: Row<S, BLOCKS>,
}

impl<S: Real, const BLOCKS: usize> Record<S> for Tape<S, BLOCKS> {
    fn new() -> Self {
        let zero = zero();
        let (left, right) = ([zero; ORDERS], [zero; ORDERS]);
        Self { left, right, kept: [zero; 2], first: [zero; 2], newest: zero }
    }

    #[inline(always)]
    fn values(&mut self) -> impl Order<S> {
        (self.first, self.newest) = ([zero(); 2], zero());
        Values::new(self)
    }

    #[inline(always)]
    fn coefficients(&mut self, n: usize) -> impl Order<S> {
        if n == 2 {
            self.first = [self.left[1], self.right[1]];
        }
        let sums = self.sums(n);
        Coefficients::new(self, n, sums)
    }
}

impl<S: Real, const BLOCKS: usize> Tape<S, BLOCKS> {
    /// Σ aₖ bₙ₋ₖ over 1 < k < n − 1, or the only product where n is 2.
    #[inline(always)]
    fn sums(&self, n: usize) -> Row<S, BLOCKS> {
        let orders = if n == 2 { 1..2 } else { 2..(n - 1).max(2) };
        let (left, right) = (&self.left[orders.clone()], &self.right[orders]);
        let (left, right) = (left.chunks_exact(2), right.rchunks_exact(2));
        let mut sums = zero();
        for block in 0..BLOCKS {
            // Two sums hide the latency of an addition.
            let (mut even, mut odd) = ([S::ratio(0, 1); LANES], [S::ratio(0, 1); LANES]);
            for (a, b) in left.remainder().iter().zip(right.remainder()) {
                even = products(&a[block], &b[block], even);
            }
            for (a, b) in left.clone().zip(right.clone()) {
                even = products(&a[0][block], &b[1][block], even);
                odd = products(&a[1][block], &b[0][block], odd);
            }
            sums[block] = core::array::from_fn(|lane| even[lane] + odd[lane]);
        }
        sums
    }
}

#[inline(always)]
fn products<S: Real>(a: &[S; LANES], b: &[S; LANES], sum: [S; LANES]) -> [S; LANES] {
    core::array::from_fn(|lane| a[lane].mul_add(b[lane], sum[lane]))
}

#[inline(always)]
fn zero<S: Real, const BLOCKS: usize>() -> Row<S, BLOCKS> {
    [[S::ratio(0, 1); LANES]; BLOCKS]
}
