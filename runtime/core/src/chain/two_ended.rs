//! Two numbers side by side, for two eliminations that take the same steps: one vector where the
//! processor has such.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::scalar::Real;

#[derive(Clone, Copy, Debug)]
pub(super) struct TwoEnded<S>(pub(super) [S; 2]);

impl<S: Copy> TwoEnded<S> {
    #[inline(always)]
    fn each(self, f: impl Fn(S) -> S) -> Self {
        Self([f(self.0[0]), f(self.0[1])])
    }

    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        Self([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
    }
}

macro_rules! elementwise {
    ($($trait:ident $method:ident),*) => {$(
        impl<S: Real> $trait for TwoEnded<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.with(other, $trait::$method)
            }
        }
    )*};
}

elementwise!(Add add, Sub sub, Mul mul, Div div);

impl<S: Real> Neg for TwoEnded<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(Neg::neg)
    }
}

impl<S: Real> Real for TwoEnded<S> {
    #[inline(always)]
    fn ratio(p: i64, q: i64) -> Self {
        Self([S::ratio(p, q); 2])
    }

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self([S::from_f64(x); 2])
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(S::sqrt)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        self.each(S::exp)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        self.each(S::ln)
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        self.each(S::tanh)
    }

    #[inline(always)]
    fn atan(self) -> Self {
        self.each(S::atan)
    }

    fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5] {
        let [a, b] = self.0.map(|x| x.piece(knots, pieces));
        core::array::from_fn(|k| Self([a[k], b[k]]))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let ([a, c], [b, d]) =
            (self.0.map(S::sin_cos).map(|(s, _)| s), self.0.map(S::sin_cos).map(|(_, c)| c));
        (Self([a, c]), Self([b, d]))
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self([self.0[0].mul_add(a.0[0], b.0[0]), self.0[1].mul_add(a.0[1], b.0[1])])
    }
}
