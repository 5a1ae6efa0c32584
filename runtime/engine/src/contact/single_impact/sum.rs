//! Sums with the size of their terms, by which what is zero but for rounding is told from what is
//! not.

use crate::numerics::zero::SOLVED;

/// A sum counts as nonzero above this part of its terms, as do pivots of M.
pub(super) const CLEAR: f64 = 1e-9;
/// It counts as zero up to this part of them.
pub(super) const ROUNDING: f64 = SOLVED;

/// A sum, and that of the sizes of its terms.
#[derive(Clone, Copy)]
pub(super) struct Sum {
    pub(super) value: f64,
    pub(super) size: f64,
}

impl Sum {
    pub(super) const ZERO: Self = Self { value: 0.0, size: 0.0 };

    pub(super) fn from_terms(terms: &[Self]) -> Self {
        let both = |sum: Self, it: &Self| Self { value: sum.value + it.value, size: sum.size + it.size };
        terms.iter().fold(Self::ZERO, both)
    }

    pub(super) fn times(self, factor: f64) -> Self {
        Self { value: self.value * factor, size: self.size * factor.abs() }
    }

    /// Its value, zero where it is so but for rounding.
    pub(super) fn known(self) -> f64 {
        if self.value.abs() <= ROUNDING * self.size { 0.0 } else { self.value }
    }

    /// The same, if it is zero or clearly not.
    pub(super) fn clear(self) -> Option<f64> {
        Some(self.known()).filter(|value| *value == 0.0 || value.abs() > CLEAR * self.size)
    }
}
