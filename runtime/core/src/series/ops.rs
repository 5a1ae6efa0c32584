//! The recurrences, one order at a time.
//!
//! They are Moore's (*Methods and Applications of Interval Analysis*, 1979, ch. 3; À. Jorba and M.
//! Zou, *A software package for the numerical integration of ODEs by means of high-order Taylor
//! methods*, Experimental Mathematics 14, 2005, Proposition 2.1), m = Σ aₖ bₙ₋ₖ over 0 < k < n for
//! the two series a, b of the column:
//!
//! ```text
//! c = a b      cₙ = a₀ bₙ + aₙ b₀ + m
//! q = a / b    qₙ = (aₙ − bₙ q₀ − m) / b₀      column b, q
//! r = √a       rₙ = (aₙ − m) / 2 r₀            column r, r
//! r = |a|      rₙ = σ aₙ, σ the sign of the first aₖ ≠ 0: one-sided, for t ≥ 0
//! s = sin φ    sₙ = φₙ c₀ + m / n              column k φₖ, c
//! c = cos φ    cₙ = −φₙ s₀ − m / n             column k φₖ, s
//! e = eᵃ       eₙ = aₙ e₀ + m / n              column k aₖ, e
//! l = log a    lₙ = (aₙ − m / n) / a₀          column a, k lₖ
//! h = tanh a   hₙ = aₙ g₀ + m / n              column k aₖ, g = 1 − h², and h, h
//! y = atan a   yₙ = (aₙ − m / n) / g₀          column g = 1 + a², k yₖ, and a, a
//! s of a table: Horner's products             columns of 0, of c₃ u + c₂ and u, of the next and u
//! ```
//!
//! What an order adds last is a product with a value, so that little stands between a coefficient
//! and the next.

use crate::scalar::Real;

/// One order of each operation from the same order of its operands; `column` is the operation's
/// place on the tape.
pub trait SeriesOps<S: Real> {
    /// What does not vary.
    fn constant(&self, value: S) -> S;
    /// a + `constant`.
    fn offset(&self, a: S, constant: S) -> S;
    /// a b; of the two, `a` is best the one that is known later.
    fn product(&mut self, column: usize, a: S, b: S) -> S;
    /// a².
    fn square(&mut self, column: usize, a: S) -> S;
    /// a / b.
    fn quotient(&mut self, column: usize, a: S, b: S) -> S;
    /// `constant` / b.
    fn inverse(&mut self, column: usize, constant: S, b: S) -> S;
    /// √a.
    fn sqrt(&mut self, column: usize, a: S) -> S;
    /// |a| = √a², for t ≥ 0.
    fn magnitude(&mut self, column: usize, a: S) -> S;
    /// eᵃ.
    fn exp(&mut self, column: usize, a: S) -> S;
    /// log a.
    fn ln(&mut self, column: usize, a: S) -> S;
    /// tanh a; takes two columns.
    fn tanh(&mut self, column: usize, a: S) -> S;
    /// atan a; takes two columns.
    fn atan(&mut self, column: usize, a: S) -> S;
    /// The value of a spline at a, all of which is in one piece; takes three columns.
    fn spline(&mut self, column: usize, a: S, knots: &[f64], pieces: &[[f64; 4]]) -> S;
    /// sin φ and cos φ, whose values are `values`; takes two columns.
    fn sin_cos(&mut self, column: usize, angle: S, values: impl FnOnce() -> (S, S)) -> (S, S);
    /// 1 − cos φ, whose value is `value`.
    fn versed(&self, value: impl FnOnce() -> S, cos: S) -> S;
}

/// Where operations leave what later orders need, column by column.
pub(super) trait Storage<S> {
    /// What an operation keeps of the values.
    fn keep(&mut self, column: usize, a: S, b: S);
    /// What it has kept.
    fn kept(&self, column: usize) -> (S, S);
    /// m.
    fn sum(&self, column: usize) -> S;
    /// Writes aₙ, bₙ of the column, whose sum has been read.
    fn write(&mut self, n: usize, column: usize, a: S, b: S);
}

/// Order 0: the values.
#[derive(Debug)]
pub(super) struct Values<'a, P>(pub &'a mut P);

impl<P> Values<'_, P> {
    #[inline(always)]
    fn keep<S>(&mut self, column: usize, a: S, b: S)
    where
        P: Storage<S>,
    {
        self.0.keep(column, a, b);
    }
}

impl<S: Real, P: Storage<S>> SeriesOps<S> for Values<'_, P> {
    #[inline(always)]
    fn constant(&self, value: S) -> S {
        value
    }

    #[inline(always)]
    fn offset(&self, a: S, constant: S) -> S {
        a + constant
    }

    #[inline(always)]
    fn product(&mut self, column: usize, a: S, b: S) -> S {
        self.keep(column, a, b);
        a * b
    }

    #[inline(always)]
    fn square(&mut self, column: usize, a: S) -> S {
        self.keep(column, a + a, a);
        a * a
    }

    #[inline(always)]
    fn quotient(&mut self, column: usize, a: S, b: S) -> S {
        let (quotient, inverse) = (a / b, S::ratio(1, 1) / b);
        self.keep(column, inverse, -(quotient * inverse));
        quotient
    }

    #[inline(always)]
    fn inverse(&mut self, column: usize, constant: S, b: S) -> S {
        self.quotient(column, constant, b)
    }

    #[inline(always)]
    fn sqrt(&mut self, column: usize, a: S) -> S {
        let root = a.sqrt();
        self.keep(column, S::ratio(1, 2) / root, root);
        root
    }

    #[inline(always)]
    fn magnitude(&mut self, column: usize, a: S) -> S {
        let sign = a.sign();
        self.keep(column, sign, sign);
        sign * a
    }

    #[inline(always)]
    fn exp(&mut self, column: usize, a: S) -> S {
        let value = a.exp();
        self.keep(column, value, value);
        value
    }

    #[inline(always)]
    fn ln(&mut self, column: usize, a: S) -> S {
        let inverse = S::ratio(1, 1) / a;
        self.keep(column, inverse, inverse);
        a.ln()
    }

    #[inline(always)]
    fn tanh(&mut self, column: usize, a: S) -> S {
        let value = a.tanh();
        self.keep(column, S::ratio(1, 1) - value * value, value);
        self.keep(column + 1, value + value, value);
        value
    }

    #[inline(always)]
    fn atan(&mut self, column: usize, a: S) -> S {
        let inverse = S::ratio(1, 1) / (S::ratio(1, 1) + a * a);
        self.keep(column, inverse, inverse);
        self.keep(column + 1, a + a, a);
        a.atan()
    }

    #[inline]
    fn spline(&mut self, column: usize, a: S, knots: &[f64], pieces: &[[f64; 4]]) -> S {
        let [from, c0, c1, c2, c3] = a.piece(knots, pieces);
        let u = a - from;
        let inner = c3.mul_add(u, c2);
        let outer = inner.mul_add(u, c1);
        self.keep(column, c3, c3);
        self.keep(column + 1, inner, u);
        self.keep(column + 2, outer, u);
        outer.mul_add(u, c0)
    }

    #[inline(always)]
    fn sin_cos(&mut self, column: usize, _: S, values: impl FnOnce() -> (S, S)) -> (S, S) {
        let (sin, cos) = values();
        self.keep(column, sin, cos);
        (sin, cos)
    }

    #[inline(always)]
    fn versed(&self, value: impl FnOnce() -> S, _: S) -> S {
        value()
    }
}

/// Order n > 0.
#[derive(Debug)]
pub(super) struct Coefficients<'a, P> {
    pub tape: &'a mut P,
    pub n: usize,
}

impl<S: Real, P: Storage<S>> SeriesOps<S> for Coefficients<'_, P> {
    #[inline(always)]
    fn constant(&self, _: S) -> S {
        S::ratio(0, 1)
    }

    #[inline(always)]
    fn offset(&self, a: S, _: S) -> S {
        a
    }

    #[inline(always)]
    fn product(&mut self, column: usize, a: S, b: S) -> S {
        let (a0, b0) = self.tape.kept(column);
        let product = a.mul_add(b0, b.mul_add(a0, self.tape.sum(column)));
        self.tape.write(self.n, column, a, b);
        product
    }

    #[inline(always)]
    fn square(&mut self, column: usize, a: S) -> S {
        let (twice, _) = self.tape.kept(column);
        let square = a.mul_add(twice, self.tape.sum(column));
        self.tape.write(self.n, column, a, a);
        square
    }

    #[inline(always)]
    fn quotient(&mut self, column: usize, a: S, b: S) -> S {
        let (inverse, slope) = self.tape.kept(column);
        let quotient = a.mul_add(inverse, b.mul_add(slope, -(self.tape.sum(column) * inverse)));
        self.tape.write(self.n, column, b, quotient);
        quotient
    }

    #[inline(always)]
    fn inverse(&mut self, column: usize, _: S, b: S) -> S {
        let (inverse, slope) = self.tape.kept(column);
        let quotient = b.mul_add(slope, -(self.tape.sum(column) * inverse));
        self.tape.write(self.n, column, b, quotient);
        quotient
    }

    #[inline(always)]
    fn sqrt(&mut self, column: usize, a: S) -> S {
        let (half_inverse, _) = self.tape.kept(column);
        let root = a.mul_add(half_inverse, -(self.tape.sum(column) * half_inverse));
        self.tape.write(self.n, column, root, root);
        root
    }

    #[inline(always)]
    fn magnitude(&mut self, column: usize, a: S) -> S {
        let (known, _) = self.tape.kept(column);
        // That of a where all coefficients below have been zero.
        let sign = (S::ratio(1, 1) - known * known).mul_add(a.sign(), known);
        self.tape.keep(column, sign, sign);
        sign * a
    }

    #[inline(always)]
    fn exp(&mut self, column: usize, a: S) -> S {
        let n = self.n as i64;
        let (value, _) = self.tape.kept(column);
        let power = a.mul_add(value, self.tape.sum(column) * S::ratio(1, n));
        self.tape.write(self.n, column, a * S::ratio(n, 1), power);
        power
    }

    #[inline(always)]
    fn ln(&mut self, column: usize, a: S) -> S {
        let n = self.n as i64;
        let (inverse, _) = self.tape.kept(column);
        let logarithm = (a - self.tape.sum(column) * S::ratio(1, n)) * inverse;
        self.tape.write(self.n, column, a, logarithm * S::ratio(n, 1));
        logarithm
    }

    #[inline(always)]
    fn tanh(&mut self, column: usize, a: S) -> S {
        let n = self.n as i64;
        let ((slope, _), (twice, _)) = (self.tape.kept(column), self.tape.kept(column + 1));
        let tangent = a.mul_add(slope, self.tape.sum(column) * S::ratio(1, n));
        let square = tangent.mul_add(twice, self.tape.sum(column + 1));
        self.tape.write(self.n, column, a * S::ratio(n, 1), -square);
        self.tape.write(self.n, column + 1, tangent, tangent);
        tangent
    }

    #[inline(always)]
    fn atan(&mut self, column: usize, a: S) -> S {
        let n = self.n as i64;
        let ((inverse, _), (twice, _)) = (self.tape.kept(column), self.tape.kept(column + 1));
        let angle = (a - self.tape.sum(column) * S::ratio(1, n)) * inverse;
        let square = a.mul_add(twice, self.tape.sum(column + 1));
        self.tape.write(self.n, column, square, angle * S::ratio(n, 1));
        self.tape.write(self.n, column + 1, a, a);
        angle
    }

    #[inline]
    fn spline(&mut self, column: usize, a: S, _: &[f64], _: &[[f64; 4]]) -> S {
        let (c3, _) = self.tape.kept(column);
        let inner = c3 * a;
        let outer = self.product(column + 1, inner, a);
        self.product(column + 2, outer, a)
    }

    #[inline(always)]
    fn sin_cos(&mut self, column: usize, angle: S, _: impl FnOnce() -> (S, S)) -> (S, S) {
        let n = self.n as i64;
        let (sin0, cos0) = self.tape.kept(column);
        let sin = angle.mul_add(cos0, self.tape.sum(column) * S::ratio(1, n));
        let cos = -angle.mul_add(sin0, self.tape.sum(column + 1) * S::ratio(1, n));
        let rate = angle * S::ratio(n, 1);
        self.tape.write(self.n, column, rate, cos);
        self.tape.write(self.n, column + 1, rate, sin);
        (sin, cos)
    }

    #[inline(always)]
    fn versed(&self, _: impl FnOnce() -> S, cos: S) -> S {
        -cos
    }
}
