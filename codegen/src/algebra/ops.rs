//! + − · on series, by value and by reference.

use super::collect::{Collector, merge};
use super::{Series, work};
use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

impl Series {
    fn plus(self, other: Self) -> Self {
        if self.is_overflow() || other.is_overflow() || !work::spend(1 + self.len().min(other.len())) {
            return Self::overflow();
        }
        let merged = merge(self.into_entries(), other.into_entries());
        Self::from_sorted(merged).map_coefficients(|c| c)
    }
}

impl Neg for Series {
    type Output = Self;
    fn neg(self) -> Self {
        self.map_coefficients(|c| -c)
    }
}

impl Neg for &Series {
    type Output = Series;
    fn neg(self) -> Series {
        -self.clone()
    }
}

/// The three reference forms of a binary operator that is defined by value.
macro_rules! by_reference {
    ($type:ty, $($operator:ident $method:ident),*) => {$(
        impl $operator<&$type> for $type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type {
                $operator::$method(self, other.clone())
            }
        }
        impl $operator<$type> for &$type {
            type Output = $type;
            fn $method(self, other: $type) -> $type {
                $operator::$method(self.clone(), other)
            }
        }
        impl $operator<&$type> for &$type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type {
                $operator::$method(self.clone(), other.clone())
            }
        }
    )*};
}
pub(super) use by_reference;

by_reference!(Series, Add add, Sub sub);

impl Add for Series {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl Sub for Series {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.plus(-other)
    }
}

/// Multiplication reads both factors, so no form of it clones.
macro_rules! multiplication {
    ($($left:ty, $right:ty);*) => {$(
        impl Mul<$right> for $left {
            type Output = Series;
            fn mul(self, other: $right) -> Series {
                self.product(&other)
            }
        }
    )*};
}

multiplication!(Series, Series; Series, &Series; &Series, Series; &Series, &Series);

impl AddAssign for Series {
    fn add_assign(&mut self, other: Self) {
        *self = std::mem::replace(self, Self::zero()).plus(other);
    }
}

impl AddAssign<&Self> for Series {
    fn add_assign(&mut self, other: &Self) {
        *self += other.clone();
    }
}

impl SubAssign for Series {
    fn sub_assign(&mut self, other: Self) {
        *self += -other;
    }
}

impl SubAssign<&Self> for Series {
    fn sub_assign(&mut self, other: &Self) {
        *self += -other;
    }
}

impl Sum for Series {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        let mut sum = Collector::default();
        for series in iter {
            if series.is_overflow() {
                sum.poison();
            }
            for (term, c) in series.into_entries() {
                sum.push(term, c);
            }
        }
        sum.finish()
    }
}

impl<'a> Sum<&'a Self> for Series {
    fn sum<I: Iterator<Item = &'a Self>>(iter: I) -> Self {
        iter.cloned().sum()
    }
}
