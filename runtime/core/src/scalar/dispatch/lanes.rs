//! Eight doubles side by side, of which vectors they are made.

use wide::f64x8;

/// How many lanes there are.
#[doc(hidden)]
pub const LANES: usize = 8;

/// [`LANES`] doubles, or `V` times as many; every operation acts on each by itself, with the bits
/// that it has on an `f64` of a target with the same instructions.
///
/// [`LANES`] are one vector where there is AVX-512, else two or four. Twice as many hide the
/// latency of operations that wait for one another. `X` are the vectors of the target, unless
/// better ones have been found at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Lanes<const V: usize = 1, X = f64x8>(pub(in crate::scalar) [X; V]);
