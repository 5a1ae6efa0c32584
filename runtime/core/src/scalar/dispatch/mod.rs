//! Code compiled several times where the target is any processor of its kind: for all of them, for
//! those with AVX2 and FMA, and, where whole steps are made of vectors, for those with AVX-512;
//! which it is, is found out at run time.
//!
//! Loops over arrays ([`vectorised`]) the compiler itself turns into vectors. Series and right-hand
//! sides are made of doubles that multiply and add in one instruction ([`by_doubles`]), what is
//! side by side of vectors ([`widest`]). Where the target has the instructions there is one
//! function, and nothing to find out. What is gained stands where it is gained: in `fused`,
//! `found`.
//!
//! The only `unsafe` code of this crate is in this folder: calls of functions that need AVX2 and
//! FMA, behind the standard library's test for both, and what `found` has, behind the same.
//! Compiled for more instructions, a function does what its source says like any other.

mod double;
#[cfg(all(feature = "std", target_arch = "x86_64", any(test, not(target_feature = "avx512f"))))]
mod found;
#[cfg(all(feature = "std", target_arch = "x86_64", any(test, not(target_feature = "fma"))))]
mod fused;
#[cfg(feature = "std")]
mod lanes;
#[cfg(all(test, feature = "std", target_arch = "x86_64"))]
mod tests;
#[cfg(feature = "std")]
mod vector;

pub use double::Double;
pub(crate) use double::ForDouble;
#[cfg(feature = "std")]
pub use lanes::{LANES, Lanes};
#[cfg(feature = "std")]
pub use vector::Vector;

/// A piece of work that is compiled for the instructions of its numbers.
pub trait Inside {
    /// What it gives.
    type Output;
    /// Does it. To be marked `#[inline(always)]`, like all that it calls with such numbers: what is
    /// not inlined calls each instruction as a function.
    fn run(self) -> Self::Output;
}

/// Hands out doubles that multiply and add in one instruction, where the processor has it and the
/// target need not.
pub(crate) fn by_doubles<F: ForDouble>(wanted: F) -> F::Output {
    #[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma")))]
    if has_fma() {
        return wanted.with::<fused::Fused>();
    }
    wanted.plain()
}

/// A loop that is worth it.
pub(crate) trait Vectorised {
    /// Does it, multiplying and adding in one instruction if `FUSED`. To be marked
    /// `#[inline(always)]`: only what is inlined is compiled for the instructions that were found.
    fn run<const FUSED: bool>(self);
}

/// Whether the target multiplies and adds in one instruction. Without the standard library that is
/// not to be had.
pub(crate) const FUSED: bool = cfg!(all(target_feature = "fma", feature = "std"));

/// Runs it with the widest instructions that there are.
#[inline(always)]
pub(crate) fn vectorised(work: impl Vectorised) {
    #[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma")))]
    if has_fma() {
        // SAFETY: the processor has both, as was just found.
        #[allow(unsafe_code, reason = "the module's proof")]
        return unsafe { with_avx2(work) };
    }
    work.run::<FUSED>();
}

/// Whether the processor has AVX2 and FMA, where the target need not.
#[cfg(all(feature = "std", target_arch = "x86_64", any(test, not(target_feature = "fma"))))]
#[inline(always)]
fn has_fma() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma")))]
#[target_feature(enable = "avx2,fma")]
fn with_avx2(work: impl Vectorised) {
    work.run::<true>();
}

/// What asks for vectors.
#[cfg(feature = "std")]
pub(crate) trait ForVector {
    /// What it makes of them.
    type Output;
    /// Makes it. What it computes with them is fast in [`Vector::inside`] only.
    fn with<X: Vector>(self) -> Self::Output;
}

/// Hands out the widest vectors that the processor has.
#[cfg(feature = "std")]
pub(crate) fn widest<F: ForVector>(wanted: F) -> F::Output {
    #[cfg(all(target_arch = "x86_64", not(target_feature = "avx512f")))]
    if std::arch::is_x86_feature_detected!("avx512f") {
        return wanted.with::<found::Avx512>();
    }
    #[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
    if has_fma() {
        return wanted.with::<found::Avx2>();
    }
    wanted.with::<wide::f64x8>()
}
