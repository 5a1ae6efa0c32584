//! Vectors and symmetric matrices of the plane.

use core::ops::{Add, Sub};

use crate::scalar::Real;

#[derive(Clone, Copy, Debug)]
pub(super) struct PlaneVector<S> {
    pub(super) x: S,
    pub(super) y: S,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Symmetric<S> {
    pub(super) xx: S,
    pub(super) xy: S,
    pub(super) yy: S,
}

/// By rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Matrix<S>(pub(super) [S; 4]);

impl<S> From<[S; 2]> for PlaneVector<S> {
    #[inline]
    fn from([x, y]: [S; 2]) -> Self {
        Self { x, y }
    }
}

impl<S: Real> PlaneVector<S> {
    #[inline]
    pub(super) fn zero() -> Self {
        Self::from([S::ratio(0, 1); 2])
    }

    #[inline]
    pub(super) fn scaled(self, factor: S) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }

    #[inline]
    pub(super) fn dot(self, other: Self) -> S {
        self.x.mul_add(other.x, self.y * other.y)
    }
}

impl<S: Real> Symmetric<S> {
    #[inline]
    pub(super) fn determinant(self) -> S {
        self.xx.mul_add(self.yy, -(self.xy * self.xy))
    }

    /// Its inverse times its determinant.
    #[inline]
    pub(super) fn adjugate(self) -> Self {
        Self { xx: self.yy, xy: -self.xy, yy: self.xx }
    }

    #[inline]
    pub(super) fn apply(self, v: PlaneVector<S>) -> PlaneVector<S> {
        PlaneVector { x: self.xx.mul_add(v.x, self.xy * v.y), y: self.xy.mul_add(v.x, self.yy * v.y) }
    }

    #[inline]
    pub(super) fn times(self, other: Self) -> Matrix<S> {
        Matrix([
            self.xx.mul_add(other.xx, self.xy * other.xy),
            self.xx.mul_add(other.xy, self.xy * other.yy),
            self.xy.mul_add(other.xx, self.yy * other.xy),
            self.xy.mul_add(other.xy, self.yy * other.yy),
        ])
    }

    /// `self · right`, known to be symmetric.
    #[inline]
    pub(super) fn times_to_symmetric(self, Matrix([a, b, c, d]): Matrix<S>) -> Self {
        Self {
            xx: self.xx.mul_add(a, self.xy * c),
            xy: self.xx.mul_add(b, self.xy * d),
            yy: self.xy.mul_add(b, self.yy * d),
        }
    }

    /// `self − factor · other`.
    #[inline]
    pub(super) fn less(self, factor: S, other: Self) -> Self {
        let minus = -factor;
        Self {
            xx: minus.mul_add(other.xx, self.xx),
            xy: minus.mul_add(other.xy, self.xy),
            yy: minus.mul_add(other.yy, self.yy),
        }
    }
}

impl<S: Real> Matrix<S> {
    #[inline]
    pub(super) fn scaled(self, factor: S) -> Self {
        Self(self.0.map(|entry| entry * factor))
    }

    /// `self · v + w`.
    #[inline]
    pub(super) fn apply_to(self, v: PlaneVector<S>, w: PlaneVector<S>) -> PlaneVector<S> {
        let Self([a, b, c, d]) = self;
        PlaneVector { x: a.mul_add(v.x, b.mul_add(v.y, w.x)), y: c.mul_add(v.x, d.mul_add(v.y, w.y)) }
    }

    /// `selfᵀ · v + w`.
    #[inline]
    pub(super) fn transpose_to(self, v: PlaneVector<S>, w: PlaneVector<S>) -> PlaneVector<S> {
        let Self([a, b, c, d]) = self;
        Self([a, c, b, d]).apply_to(v, w)
    }
}

impl<S: Real> Add for PlaneVector<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<S: Real> Sub for PlaneVector<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<S: Real> Add for Symmetric<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { xx: self.xx + other.xx, xy: self.xy + other.xy, yy: self.yy + other.yy }
    }
}

impl<S: Real> Sub for Symmetric<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { xx: self.xx - other.xx, xy: self.xy - other.xy, yy: self.yy - other.yy }
    }
}
