//! One order of a series computation: the values, and then coefficient after coefficient.
//!
//! The recurrences are Moore's (*Methods and Applications of Interval Analysis*, 1979, ch. 3; À. Jorba and M. Zou,
//! *A software package for the numerical integration of ODEs by means of high-order Taylor methods*, Experimental
//! Mathematics 14, 2005, Prop. 2.1), m = Σ aₖ bₙ₋ₖ over 0 < k < n for the two series of the column:
//!
//! ```text
//! c = a b      cₙ = a₀ bₙ + aₙ b₀ + m
//! q = a / b    qₙ = (aₙ − bₙ q₀ − m) / b₀             m of b, q
//! r = √a       rₙ = (aₙ − m) / 2 r₀                   m of r, r
//! s = sin φ    sₙ = φₙ c₀ + m / n                     m of k φₖ, c
//! c = cos φ    cₙ = −φₙ s₀ − m / n                    m of k φₖ, s
//! ```

use super::{LANES, Tape};
use crate::scalar::Real;

/// Computes coefficient n of each operation from those of its operands; `column` is the operation's place on the tape.
pub trait Order<S: Real> {
    /// Coefficient n of what does not vary.
    fn constant(&self, value: S) -> S;
    /// a b.
    fn product(&mut self, column: usize, a: S, b: S) -> S;
    /// a².
    fn square(&mut self, column: usize, a: S) -> S;
    /// a / b.
    fn quotient(&mut self, column: usize, a: S, b: S) -> S;
    /// a / b for an a that does not vary.
    fn inverse(&mut self, column: usize, a: S, b: S) -> S;
    /// √a.
    fn sqrt(&mut self, column: usize, a: S) -> S;
    /// sin and cos of an angle whose values are found by `values`; takes two columns.
    fn sin_cos(&mut self, column: usize, angle: S, values: impl FnOnce() -> (S, S)) -> (S, S);
}

/// Order 0: the values.
#[derive(Debug)]
pub struct Values<'a, S, const BLOCKS: usize> {
    tape: &'a mut Tape<S, BLOCKS>,
}

impl<'a, S: Real, const BLOCKS: usize> Values<'a, S, BLOCKS> {
    /// Begins a tape.
    #[inline(always)]
    pub fn new(tape: &'a mut Tape<S, BLOCKS>) -> Self {
        Self { tape }
    }

    #[inline(always)]
    fn keep(&mut self, column: usize, a: S, b: S) {
        self.tape.left[0][column / LANES][column % LANES] = a;
        self.tape.right[0][column / LANES][column % LANES] = b;
    }
}

impl<S: Real, const BLOCKS: usize> Order<S> for Values<'_, S, BLOCKS> {
    #[inline(always)]
    fn constant(&self, value: S) -> S {
        value
    }

    #[inline(always)]
    fn product(&mut self, column: usize, a: S, b: S) -> S {
        self.keep(column, a, b);
        a * b
    }

    #[inline(always)]
    fn square(&mut self, column: usize, a: S) -> S {
        self.keep(column, a, a + a);
        a * a
    }

    #[inline(always)]
    fn quotient(&mut self, column: usize, a: S, b: S) -> S {
        let (quotient, inverse) = (a / b, S::ratio(1, 1) / b);
        self.keep(column, inverse, -(quotient * inverse));
        quotient
    }

    #[inline(always)]
    fn inverse(&mut self, column: usize, a: S, b: S) -> S {
        self.quotient(column, a, b)
    }

    #[inline(always)]
    fn sqrt(&mut self, column: usize, a: S) -> S {
        let root = a.sqrt();
        self.keep(column, S::ratio(1, 2) / root, root);
        root
    }

    #[inline(always)]
    fn sin_cos(&mut self, column: usize, _: S, values: impl FnOnce() -> (S, S)) -> (S, S) {
        let (sin, cos) = values();
        self.keep(column, cos, sin);
        (sin, cos)
    }
}

/// Order n > 0, from the orders below it.
#[derive(Debug)]
pub struct Coefficients<'a, S, const BLOCKS: usize> {
    tape: &'a mut Tape<S, BLOCKS>,
    n: usize,
    sums: [[S; LANES]; BLOCKS],
}

impl<'a, S: Real, const BLOCKS: usize> Coefficients<'a, S, BLOCKS> {
    /// Goes on to order `n`, one above the last.
    #[inline(always)]
    pub fn new(tape: &'a mut Tape<S, BLOCKS>, n: usize) -> Self {
        let sums = tape.sums(n);
        Self { tape, n, sums }
    }

    #[inline(always)]
    fn sum(&self, column: usize) -> S {
        self.sums[column / LANES][column % LANES]
    }

    #[inline(always)]
    fn kept(&self, column: usize) -> (S, S) {
        let (block, lane) = (column / LANES, column % LANES);
        (self.tape.left[0][block][lane], self.tape.right[0][block][lane])
    }

    #[inline(always)]
    fn keep(&mut self, column: usize, a: S, b: S) {
        self.tape.left[self.n][column / LANES][column % LANES] = a;
        self.tape.right[self.n][column / LANES][column % LANES] = b;
    }
}

impl<S: Real, const BLOCKS: usize> Order<S> for Coefficients<'_, S, BLOCKS> {
    #[inline(always)]
    fn constant(&self, _: S) -> S {
        S::ratio(0, 1)
    }

    /// `a` is best the later of the two.
    #[inline(always)]
    fn product(&mut self, column: usize, a: S, b: S) -> S {
        self.keep(column, a, b);
        let (a0, b0) = self.kept(column);
        a.mul_add(b0, b.mul_add(a0, self.sum(column)))
    }

    #[inline(always)]
    fn square(&mut self, column: usize, a: S) -> S {
        self.keep(column, a, a);
        let (_, twice) = self.kept(column);
        a.mul_add(twice, self.sum(column))
    }

    #[inline(always)]
    fn quotient(&mut self, column: usize, a: S, b: S) -> S {
        let (inverse, slope) = self.kept(column);
        let rest = b.mul_add(slope, -(self.sum(column) * inverse));
        let quotient = a.mul_add(inverse, rest);
        self.keep(column, b, quotient);
        quotient
    }

    #[inline(always)]
    fn inverse(&mut self, column: usize, _: S, b: S) -> S {
        let (inverse, slope) = self.kept(column);
        let quotient = b.mul_add(slope, -(self.sum(column) * inverse));
        self.keep(column, b, quotient);
        quotient
    }

    #[inline(always)]
    fn sqrt(&mut self, column: usize, a: S) -> S {
        let (half_inverse, _) = self.kept(column);
        let root = a.mul_add(half_inverse, -(self.sum(column) * half_inverse));
        self.keep(column, root, root);
        root
    }

    #[inline(always)]
    fn sin_cos(&mut self, column: usize, angle: S, _: impl FnOnce() -> (S, S)) -> (S, S) {
        let (cos0, sin0) = self.kept(column);
        let over_n = S::ratio(1, self.n as i64);
        let sin = angle.mul_add(cos0, self.sum(column) * over_n);
        let cos = -angle.mul_add(sin0, self.sum(column + 1) * over_n);
        let rate = angle * S::ratio(self.n as i64, 1);
        self.keep(column, rate, cos);
        self.keep(column + 1, rate, sin);
        (sin, cos)
    }
}
