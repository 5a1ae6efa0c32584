//! Eight doubles as the instructions of the target, or of the processor, take them.

use core::ops::{BitOr, Div, Shr};

use wide::f64x8;

use super::Inside;
use super::{LANES, Lanes};
use crate::scalar::sin_cos::{Doubles, sin_cos_all};

/// [`LANES`] doubles side by side; every operation acts on each by itself, with the bits that it
/// has on an `f64`.
pub trait Vector:
    Doubles<Bits: BitOr<Output = Self::Bits> + Shr<u32, Output = Self::Bits>>
    + Div<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// These values.
    fn new(values: [f64; LANES]) -> Self;
    /// The values.
    fn as_array(&self) -> &[f64; LANES];
    /// The values, to replace some.
    fn as_mut_array(&mut self) -> &mut [f64; LANES];
    /// Square roots.
    fn sqrt(self) -> Self;
    /// The larger of two; of a number and what is none, either.
    fn max(self, other: Self) -> Self;
    /// The smaller of two; of a number and what is none, either.
    fn min(self, other: Self) -> Self;
    /// The largest integers that are not larger.
    fn floor(self) -> Self;
    /// `self · a + b`, fused where there is an instruction for it.
    fn multiply_add(self, a: Self, b: Self) -> Self;
    /// Sines and cosines, with the bits that each angle has by itself.
    fn sin_cos_all<const V: usize, const K: usize>(
        angles: [[Self; V]; K],
    ) -> ([[Self; V]; K], [[Self; V]; K]);
    /// What is in vectors of the target, seen in these.
    fn view<const V: usize>(lanes: &[Lanes<V>]) -> &[Lanes<V, Self>];
    /// The same, to be written.
    fn view_mut<const V: usize>(lanes: &mut [Lanes<V>]) -> &mut [Lanes<V, Self>];
    /// Runs what is made of these vectors, compiled for the instructions that they have.
    fn inside<W: Inside>(work: W) -> W::Output;
}

/// What the compiler makes of the target.
impl Vector for f64x8 {
    #[inline(always)]
    fn new(values: [f64; LANES]) -> Self {
        Self::new(values)
    }

    #[inline(always)]
    fn as_array(&self) -> &[f64; LANES] {
        self.as_array()
    }

    #[inline(always)]
    fn as_mut_array(&mut self) -> &mut [f64; LANES] {
        self.as_mut_array()
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.fast_max(other)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.fast_min(other)
    }

    #[inline(always)]
    fn floor(self) -> Self {
        self.floor()
    }

    #[inline(always)]
    fn multiply_add(self, a: Self, b: Self) -> Self {
        if cfg!(target_feature = "fma") { self.mul_add(a, b) } else { self * a + b }
    }

    #[inline(always)]
    fn sin_cos_all<const V: usize, const K: usize>(
        angles: [[Self; V]; K],
    ) -> ([[Self; V]; K], [[Self; V]; K]) {
        sin_cos_all::<{ cfg!(target_feature = "fma") }, Self, V, K>(angles)
    }

    #[inline(always)]
    fn view<const V: usize>(lanes: &[Lanes<V>]) -> &[Lanes<V, Self>] {
        lanes
    }

    #[inline(always)]
    fn view_mut<const V: usize>(lanes: &mut [Lanes<V>]) -> &mut [Lanes<V, Self>] {
        lanes
    }

    #[inline(always)]
    fn inside<W: Inside>(work: W) -> W::Output {
        work.run()
    }
}
