//! Numbers that runs are computed with once more.

use liftoff_core::scalar::{DoubleDouble, Dual4, Scalar};

/// A number with parts whose errors count each by itself: its value, then its derivatives, with
/// respect to variables in units in which they vary by some 1.
pub trait Number: Scalar {
    /// How many.
    const PARTS: usize;
    /// A part of the unit below which the error of a component counts as absolute.
    const FLOOR: f64;
    /// One of them.
    fn part(self, k: usize) -> f64;
    /// 0 with the first derivative 1 and no other, where there are derivatives.
    fn infinitesimal() -> Option<Self>;
}

impl Number for DoubleDouble {
    const PARTS: usize = 1;
    const FLOOR: f64 = 1e-3;

    fn part(self, _: usize) -> f64 {
        self.to_f64()
    }

    fn infinitesimal() -> Option<Self> {
        None
    }
}

impl Number for Dual4 {
    const PARTS: usize = 5;
    const FLOOR: f64 = 1.0;

    fn part(self, k: usize) -> f64 {
        k.checked_sub(1).map_or(self.value(), |variable| self.gradient()[variable])
    }

    fn infinitesimal() -> Option<Self> {
        Some(Self::variable(0.0, 0))
    }
}
