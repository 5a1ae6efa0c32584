//! Angles Σ kᵢ·symbolᵢ + quarters·π/2: what a sine or cosine is taken of.

use super::{Powers, Symbol};
use std::ops::{Add, Neg, Sub};

/// An integer combination of symbols plus a whole number of quarter turns.
///
/// A multiplier beyond ±32767 makes the angle's sine and cosine overflow.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Angle {
    /// `None` after an overflow.
    terms: Option<Powers>,
    quarters: u8,
}

impl Angle {
    /// 0.
    pub fn zero() -> Self {
        Self::quarters(0)
    }

    /// The angle that a symbol stands for.
    pub fn from_symbol(symbol: Symbol) -> Self {
        Self::from_multipliers(Powers::single(symbol, 1))
    }

    /// n·π/2, modulo a full turn.
    pub fn quarters(n: i64) -> Self {
        Self { terms: Some(Powers::ZERO), quarters: n.rem_euclid(4) as u8 }
    }

    /// Pairs (symbol, non-zero multiplier), sorted.
    pub fn terms(&self) -> &[(Symbol, i16)] {
        self.terms.as_deref().unwrap_or(&[])
    }

    /// Whole quarter turns, 0 to 3.
    pub fn quarter_turns(&self) -> u8 {
        self.quarters
    }

    /// The same, −1 to 2: of numbers that differ by full turns the one that an angle stands for.
    pub fn signed_quarters(&self) -> i64 {
        if self.quarters == 3 { -1 } else { self.quarters.into() }
    }

    /// The multiplier of a symbol, 0 where absent.
    pub fn coefficient(&self, symbol: Symbol) -> i16 {
        self.terms.as_ref().map_or(0, |terms| terms.get(symbol))
    }

    /// k times the angle.
    pub fn scale(&self, k: i32) -> Self {
        Self {
            terms: self.terms.as_ref().and_then(|terms| terms.times(k)),
            quarters: (i64::from(self.quarters) * i64::from(k)).rem_euclid(4) as u8,
        }
    }

    /// The angle and n·π/2.
    pub fn turned(&self, n: i64) -> Self {
        Self { terms: self.terms.clone(), quarters: (i64::from(self.quarters) + n).rem_euclid(4) as u8 }
    }

    /// The angle with `value` in place of `symbol`.
    pub fn substitute(&self, symbol: Symbol, value: &Self) -> Self {
        let rest =
            Self { terms: self.terms.as_ref().map(|terms| terms.without(symbol)), quarters: self.quarters };
        &rest + &value.scale(i32::from(self.coefficient(symbol)))
    }

    pub(super) fn from_multipliers(terms: Powers) -> Self {
        Self { terms: Some(terms), quarters: 0 }
    }

    /// The multipliers as a vector; `None` after an overflow.
    pub(super) fn multipliers(&self) -> Option<&Powers> {
        self.terms.as_ref()
    }
}

impl Add for &Angle {
    type Output = Angle;
    fn add(self, other: &Angle) -> Angle {
        let terms = self.terms.as_ref().zip(other.terms.as_ref());
        Angle { terms: terms.and_then(|(a, b)| a.plus(b)), quarters: (self.quarters + other.quarters) % 4 }
    }
}

impl Neg for &Angle {
    type Output = Angle;
    fn neg(self) -> Angle {
        self.scale(-1)
    }
}

impl Sub for &Angle {
    type Output = Angle;
    fn sub(self, other: &Angle) -> Angle {
        self + &-other
    }
}

impl Neg for Angle {
    type Output = Self;
    fn neg(self) -> Self {
        -&self
    }
}

impl Add for Angle {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        &self + &other
    }
}

impl Sub for Angle {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        &self - &other
    }
}
