//! Affine combinations `Σ kᵢ xᵢ + constant` of angles, kᵢ integers.

use std::collections::BTreeMap;

use crate::algebra::Angle;

/// An angle that relations speak of.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Unknown {
    /// A declared coordinate.
    Declared(usize),
    /// The direction of a body.
    Direction(usize),
}

/// An integer combination of them and a constant.
#[derive(Clone, Debug)]
pub(super) struct AffineAngle {
    pub coefficients: BTreeMap<Unknown, i32>,
    pub constant: Angle,
}

impl AffineAngle {
    pub fn constant(angle: Angle) -> Self {
        Self { coefficients: BTreeMap::new(), constant: angle }
    }

    pub fn from_unknown(unknown: Unknown) -> Self {
        Self { coefficients: BTreeMap::from([(unknown, 1)]), constant: Angle::zero() }
    }

    pub fn plus(mut self, factor: i32, other: &Self) -> Self {
        for (&unknown, &k) in &other.coefficients {
            let entry = self.coefficients.entry(unknown).or_default();
            // What is cut off overflows as an angle, and is told there.
            *entry = entry.saturating_add(factor.saturating_mul(k));
        }
        self.coefficients.retain(|_, k| *k != 0);
        self.constant = &self.constant + &other.constant.scale(factor);
        self
    }

    pub fn substitute(self, unknown: Unknown, value: &Self) -> Self {
        match self.coefficients.get(&unknown).copied() {
            None => self,
            Some(k) => {
                let mut rest = self;
                rest.coefficients.remove(&unknown);
                rest.plus(k, value)
            }
        }
    }
}
