//! One term of a Poisson series without its coefficient: monomial · sin|cos(argument).

use super::{Angle, Powers, Symbol};

/// A product of integer powers of symbols; only parameters may have negative exponents.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Monomial(pub(super) Powers);

/// sin or cos of a non-empty argument whose first multiplier is positive, or the constant 1 = cos 0.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Wave {
    /// Pairs (symbol, non-zero multiplier), sorted; dereferences to a slice.
    pub argument: Powers,
    /// Sine if true, else cosine.
    pub sine: bool,
}

/// A monomial times a wave.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Term {
    /// The powers of symbols outside sines and cosines.
    pub monomial: Monomial,
    /// The sine or cosine, or 1.
    pub wave: Wave,
}

impl Monomial {
    /// The empty product.
    pub const ONE: Self = Self(Powers::ZERO);

    /// Pairs (symbol, non-zero exponent), sorted.
    pub fn factors(&self) -> &[(Symbol, i16)] {
        &self.0
    }

    /// The exponent of a symbol, 0 where absent.
    pub fn exponent(&self, symbol: Symbol) -> i16 {
        self.0.get(symbol)
    }

    /// Whether it is the empty product.
    pub fn is_one(&self) -> bool {
        self.0.is_empty()
    }
}

impl Wave {
    /// cos 0.
    pub const ONE: Self = Self { argument: Powers::ZERO, sine: false };

    /// Whether it is the constant 1.
    pub fn is_one(&self) -> bool {
        self.argument.is_empty()
    }

    /// What it is the sine or cosine of.
    pub fn angle(&self) -> Angle {
        Angle::from_multipliers(self.argument.clone())
    }

    /// The canonical wave equal to ± the given one, true where it is the negative; `None` for sin 0.
    pub(super) fn canonical(sine: bool, argument: Powers) -> Option<(bool, Self)> {
        match argument.first() {
            None => (!sine).then_some((false, Self::ONE)),
            Some(&(_, first)) if first.is_positive() => Some((false, Self { argument, sine })),
            Some(_) => {
                let argument = argument.times(-1)?;
                Some((sine, Self { argument, sine }))
            }
        }
    }
}

impl Term {
    /// 1.
    pub const ONE: Self = Self { monomial: Monomial::ONE, wave: Wave::ONE };
}
