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

/// Hands out doubles that multiply and add in one instruction, where the processor has it and the target need not.
pub(crate) fn by_doubles<F: ForDouble>(wanted: F) -> F::Output {
    #[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma")))]
    if super::has_fma() {
        return wanted.with::<super::fused::Fused>();
    }
    wanted.plain()
}
