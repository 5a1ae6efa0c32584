//! Eight doubles side by side: eight states, or eight systems, in one evaluation.

#[cfg(feature = "std")]
mod rough;
#[cfg(test)]
mod tests;

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Real;
use super::dispatch::{LANES, Lanes, Vector};

impl<const V: usize, X: Vector> Lanes<V, X> {
    /// How many.
    pub const COUNT: usize = LANES * V;

    /// The value of each lane.
    #[inline(always)]
    pub fn from_fn(value: impl Fn(usize) -> f64) -> Self {
        // One by one: an array that is copied whole is read before it has left the processor's
        // store buffer.
        let vector = |v: usize| X::new(core::array::from_fn(|i| value(LANES * v + i)));
        Self(core::array::from_fn(vector))
    }

    /// One value in all lanes.
    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self([X::splat(value); V])
    }

    /// The value in one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> f64 {
        self.0[lane / LANES].as_array()[lane % LANES]
    }

    /// Replaces the value in one lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, value: f64) {
        self.0[lane / LANES].as_mut_array()[lane % LANES] = value;
    }

    /// Magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(X::abs)
    }

    /// The larger of two; of a number and what is none, either.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.zip(other, X::max)
    }

    /// The smaller of two; of a number and what is none, either.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.zip(other, X::min)
    }

    #[inline(always)]
    fn map(mut self, operation: impl Fn(X) -> X) -> Self {
        for v in 0..V {
            self.0[v] = operation(self.0[v]);
        }
        self
    }

    #[inline(always)]
    fn zip(mut self, other: Self, operation: impl Fn(X, X) -> X) -> Self {
        for v in 0..V {
            self.0[v] = operation(self.0[v], other.0[v]);
        }
        self
    }
}

impl<X: Vector> Lanes<1, X> {
    /// These values.
    #[inline(always)]
    pub fn new(values: [f64; LANES]) -> Self {
        Self::from_fn(|lane| values[lane])
    }

    /// The values.
    #[inline(always)]
    pub fn to_array(self) -> [f64; LANES] {
        *self.0[0].as_array()
    }
}

impl<const V: usize, X: Vector> Add for Lanes<V, X> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<const V: usize, X: Vector> Sub for Lanes<V, X> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<const V: usize, X: Vector> Mul for Lanes<V, X> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl<const V: usize, X: Vector> Div for Lanes<V, X> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |a, b| a / b)
    }
}

impl<const V: usize, X: Vector> Neg for Lanes<V, X> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const V: usize, X: Vector> Real for Lanes<V, X> {
    const MANY: bool = true;

    #[inline(always)]
    fn ratio(p: i64, q: i64) -> Self {
        Self::splat(f64::ratio(p, q))
    }

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self::splat(x)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(X::sqrt)
    }

    #[inline(always)]
    fn sign(self) -> Self {
        Self::from_fn(|lane| self.lane(lane).sign())
    }

    #[inline(always)]
    fn exp(self) -> Self {
        Self::from_fn(|lane| Real::exp(self.lane(lane)))
    }

    #[inline(always)]
    fn ln(self) -> Self {
        Self::from_fn(|lane| Real::ln(self.lane(lane)))
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        Self::from_fn(|lane| Real::tanh(self.lane(lane)))
    }

    #[inline(always)]
    fn atan(self) -> Self {
        Self::from_fn(|lane| Real::atan(self.lane(lane)))
    }

    fn piece(self, knots: &[f64], pieces: &[[f64; 4]]) -> [Self; 5] {
        core::array::from_fn(|k| Self::from_fn(|lane| self.lane(lane).piece(knots, pieces)[k]))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let ([sin], [cos]) = Self::sin_cos_each([self]);
        (sin, cos)
    }

    #[inline(always)]
    fn sin_cos_each<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let vectors = angles.map(|angle| angle.0);
        let (sin, cos) = X::sin_cos_all(vectors);
        (sin.map(Self), cos.map(Self))
    }

    #[inline(always)]
    fn mul_add(mut self, a: Self, b: Self) -> Self {
        for v in 0..V {
            self.0[v] = self.0[v].multiply_add(a.0[v], b.0[v]);
        }
        self
    }
}
