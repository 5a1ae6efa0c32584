//! Dimensions in terms of those that are sought.

use std::collections::BTreeMap;

use super::Dimension;
use crate::algebra::Rational;

/// Σ cᵢ dᵢ + D, the dᵢ being the dimensions of parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct AffineDimension {
    /// cᵢ ≠ 0 by parameter.
    pub sought: BTreeMap<usize, Rational>,
    /// D.
    pub known: Dimension,
}

impl AffineDimension {
    /// What is known.
    pub const fn known(known: Dimension) -> Self {
        Self { sought: BTreeMap::new(), known }
    }

    /// The dimension of a parameter.
    pub fn parameter(index: usize) -> Self {
        Self { sought: BTreeMap::from([(index, Rational::ONE)]), known: [Rational::ZERO; 3] }
    }

    /// self + factor · other: the dimension of a product, quotient or power.
    pub fn plus(mut self, factor: Rational, other: &Self) -> Self {
        for (&index, &coefficient) in &other.sought {
            let sum = *self.sought.get(&index).unwrap_or(&Rational::ZERO) + factor * coefficient;
            match sum.is_zero() {
                true => self.sought.remove(&index),
                false => self.sought.insert(index, sum),
            };
        }
        self.known = core::array::from_fn(|b| self.known[b] + factor * other.known[b]);
        self
    }

    /// factor · self.
    pub fn times(&self, factor: Rational) -> Self {
        Self::known([Rational::ZERO; 3]).plus(factor, self)
    }

    /// The parameters in it.
    pub fn unknowns(&self) -> impl Iterator<Item = usize> + '_ {
        self.sought.keys().copied()
    }

    /// Whether a power does not fit 128-bit fractions.
    pub fn is_overflow(&self) -> bool {
        self.sought.values().chain(&self.known).any(|power| power.is_overflow())
    }
}
