//! Doubles as the target, or the processor, multiplies and adds them.

use super::Inside;
use crate::scalar::Real;

/// A double, by some set of instructions.
pub trait Double: Real {
    /// The double.
    fn value(self) -> f64;
    /// Runs what is made of these numbers, compiled for their instructions.
    fn inside<W: Inside>(work: W) -> W::Output;
}

impl Double for f64 {
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }

    #[inline(always)]
    fn inside<W: Inside>(work: W) -> W::Output {
        work.run()
    }
}

/// What asks for doubles.
pub(crate) trait ForDouble {
    /// What it makes of them.
    type Output;
    /// Makes it of those of the target.
    fn plain(self) -> Self::Output;
    /// Makes it of others; where the target has all, there are none.
    #[allow(dead_code, reason = "of targets that need not have them")]
    fn with<S: Double>(self) -> Self::Output;
}
