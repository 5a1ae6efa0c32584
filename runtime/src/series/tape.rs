//! The operands of a phase's convolutions, one column each, and the sums that every order begins with.

use super::{LANES, ORDERS};
use crate::scalar::Real;

/// Columns side by side, so that a row of one order is summed by vector instructions.
type Row<S, const BLOCKS: usize> = [[S; LANES]; BLOCKS];

/// Two series for each convolution Σ aₖ bₙ₋ₖ, in `BLOCKS` blocks of [`LANES`] columns. Row 0 is not summed: there an
/// operation keeps what it needs of the values.
#[derive(Clone, Debug)]
pub struct Tape<S, const BLOCKS: usize> {
    pub(super) left: [Row<S, BLOCKS>; ORDERS],
    pub(super) right: [Row<S, BLOCKS>; ORDERS],
}

impl<S: Real, const BLOCKS: usize> Tape<S, BLOCKS> {
    /// A tape of zeros.
    pub fn new() -> Self {
        let zeros = [[[S::ratio(0, 1); LANES]; BLOCKS]; ORDERS];
        Self { left: zeros, right: zeros }
    }

    /// Σ aₖ bₙ₋ₖ over 0 < k < n, of every column: what orders below n contribute. The newest coefficients come last, as
    /// the older ones need not wait for them.
    #[inline(always)]
    pub(super) fn sums(&self, n: usize) -> Row<S, BLOCKS> {
        let zero = [[S::ratio(0, 1); LANES]; BLOCKS];
        let (mut first, mut second) = (zero, zero);
        let last = n.saturating_sub(1);
        if n > 3 {
            let (left, right) = (&self.left[2..last], &self.right[2..last]);
            let mut pairs = left.chunks_exact(2).zip(right.rchunks_exact(2));
            for (a, b) in &mut pairs {
                add(&mut first, &a[0], &b[1]);
                add(&mut second, &a[1], &b[0]);
            }
            if n % 2 == 0 {
                add(&mut first, &self.left[n - 2], &self.right[2]);
            }
        }
        if n > 2 {
            add(&mut first, &self.left[1], &self.right[last]);
        }
        if n > 1 {
            add(&mut second, &self.left[last], &self.right[1]);
        }
        let mut sums = first;
        for (sum, more) in sums.iter_mut().flatten().zip(second.iter().flatten()) {
            *sum = *sum + *more;
        }
        sums
    }
}

#[inline(always)]
fn add<S: Real, const BLOCKS: usize>(sums: &mut Row<S, BLOCKS>, a: &Row<S, BLOCKS>, b: &Row<S, BLOCKS>) {
    for block in 0..BLOCKS {
        for lane in 0..LANES {
            sums[block][lane] = a[block][lane].mul_add(b[block][lane], sums[block][lane]);
        }
    }
}

impl<S: Real, const BLOCKS: usize> Default for Tape<S, BLOCKS> {
    fn default() -> Self {
        Self::new()
    }
}
