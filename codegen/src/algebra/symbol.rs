//! The indeterminates of a series.

use std::cmp::Ordering;

/// One indeterminate. Parameters come before coordinates, coordinates before reactions, these
/// before opaque terms.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// A parameter, or a named constant derived from parameters.
    Parameter(u16),
    /// A coordinate (order 0) or its time derivative of that order.
    Coordinate {
        /// Which coordinate.
        index: u16,
        /// 0 for q, 1 for q̇, 2 for q̈, ….
        order: u8,
    },
    /// A reaction or multiplier.
    Reaction(u16),
    /// What is no series of the others, a spring's length say, or its time derivative of that
    /// order.
    Opaque {
        /// Which.
        index: u16,
        /// 0 for its value, 1 for its rate, ….
        order: u8,
    },
    /// Time; only in opaque terms.
    Time,
    /// The sense σ in which a contact slides, 0 where it does not; only in programs.
    Sense(u16),
    /// 1 while what is switched acts, else 0.
    Switch(u16),
}

impl Symbol {
    /// q of coordinate `i`.
    pub const fn coordinate(i: usize) -> Self {
        Self::derivative_of(i, 0)
    }

    /// q̇ of coordinate `i`.
    pub const fn rate(i: usize) -> Self {
        Self::derivative_of(i, 1)
    }

    /// q̈ of coordinate `i`.
    pub const fn acceleration(i: usize) -> Self {
        Self::derivative_of(i, 2)
    }

    /// Parameter `i`.
    pub const fn parameter(i: usize) -> Self {
        Self::Parameter(i as u16)
    }

    /// The multiplier of row `i`.
    pub const fn reaction(i: usize) -> Self {
        Self::Reaction(i as u16)
    }

    /// Opaque `i`.
    pub const fn opaque(i: usize) -> Self {
        Self::Opaque { index: i as u16, order: 0 }
    }

    /// Its time derivative; `None` for what is neither coordinate nor opaque term (or at order
    /// 255).
    pub fn derivative(self) -> Option<Self> {
        match self {
            Self::Coordinate { index, order } => {
                Some(Self::Coordinate { index, order: order.checked_add(1)? })
            }
            Self::Opaque { index, order } => Some(Self::Opaque { index, order: order.checked_add(1)? }),
            Self::Parameter(_) | Self::Reaction(_) | Self::Time | Self::Sense(_) | Self::Switch(_) => None,
        }
    }

    /// Whether it is a parameter: a unit of the ring, so that it may have negative exponents.
    pub const fn is_parameter(self) -> bool {
        matches!(self, Self::Parameter(_))
    }

    const fn derivative_of(i: usize, order: u8) -> Self {
        Self::Coordinate { index: i as u16, order }
    }

    /// A number in the order of symbols: one comparison where the derived order takes several.
    pub(super) const fn code(self) -> u32 {
        match self {
            Self::Parameter(i) => i as u32,
            Self::Coordinate { index, order } => 1 << 24 | (index as u32) << 8 | order as u32,
            Self::Reaction(i) => 2 << 24 | i as u32,
            Self::Opaque { index, order } => 3 << 24 | (index as u32) << 8 | order as u32,
            Self::Time => 4 << 24,
            Self::Sense(i) => 5 << 24 | i as u32,
            Self::Switch(i) => 6 << 24 | i as u32,
        }
    }
}

impl PartialOrd for Symbol {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Symbol {
    fn cmp(&self, other: &Self) -> Ordering {
        self.code().cmp(&other.code())
    }
}
