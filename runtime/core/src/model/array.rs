//! Vectors whose length is a constant.

/// A fixed-length vector of scalars; implemented for arrays only.
pub trait Array<S>: Copy + AsRef<[S]> + AsMut<[S]> {
    /// The vector whose `i`-th entry is `entry(i)`.
    fn from_fn(entry: impl FnMut(usize) -> S) -> Self;
    /// A slice of as many entries.
    fn of_slice(entries: &[S]) -> Option<&Self>;
    /// As many entries of another type.
    type Of<T: Copy>: Array<T>;
}

impl<S: Copy, const N: usize> Array<S> for [S; N] {
    /// A loop: `core::array::from_fn` is some ten functions to compile for each closure.
    #[inline]
    fn from_fn(mut entry: impl FnMut(usize) -> S) -> Self {
        if N == 0 {
            return empty();
        }
        let mut all = [entry(0); N];
        for i in 1..N {
            all[i] = entry(i);
        }
        all
    }
    #[inline(always)]
    fn of_slice(entries: &[S]) -> Option<&Self> {
        entries.try_into().ok()
    }
    type Of<T: Copy> = [T; N];
}

fn empty<S, const N: usize>() -> [S; N] {
    core::array::from_fn(|_| unreachable!("of no entries none is asked for"))
}
