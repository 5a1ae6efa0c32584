//! Vectors whose length is a constant.

/// A fixed-length vector of scalars; implemented for arrays only.
pub trait Array<S>: Copy + AsRef<[S]> + AsMut<[S]> {
    /// The vector whose `i`-th entry is `entry(i)`.
    fn from_fn(entry: impl FnMut(usize) -> S) -> Self;
    /// As many entries of another type.
    type Of<T: Copy>: Array<T>;
}

impl<S: Copy, const N: usize> Array<S> for [S; N] {
    fn from_fn(entry: impl FnMut(usize) -> S) -> Self {
        core::array::from_fn(entry)
    }
    type Of<T: Copy> = [T; N];
}
