//! Where series and dense outputs lie: on the heap, and without `std` in place.

#[cfg(feature = "std")]
pub(super) use heap::{Store, Terms, terms};
#[cfg(not(feature = "std"))]
pub(super) use place::{Store, Terms, terms};

#[cfg(feature = "std")]
mod heap {
    /// One large value.
    pub(crate) type Store<T> = Box<T>;

    /// The coefficients of a dense output.
    pub(crate) type Terms<T> = Vec<T>;

    /// None yet, with room for some.
    pub(crate) fn terms<T>(room: usize, _: T) -> Terms<T> {
        Vec::with_capacity(room)
    }
}

#[cfg(not(feature = "std"))]
mod place {
    use core::ops::{Deref, DerefMut};

    use crate::series::ORDERS;

    /// One large value.
    #[derive(Debug, Default)]
    pub(crate) struct Store<T>(T);

    impl<T> Deref for Store<T> {
        type Target = T;
        fn deref(&self) -> &T {
            &self.0
        }
    }

    impl<T> DerefMut for Store<T> {
        fn deref_mut(&mut self) -> &mut T {
            &mut self.0
        }
    }

    /// The coefficients of a dense output; those of Taylor's method are the most.
    #[derive(Clone, Debug)]
    pub(crate) struct Terms<T> {
        entries: [T; ORDERS],
        len: usize,
    }

    impl<T> Terms<T> {
        pub(crate) fn clear(&mut self) {
            self.len = 0;
        }

        pub(crate) fn extend(&mut self, terms: impl IntoIterator<Item = T>) {
            for (entry, term) in self.entries[self.len..].iter_mut().zip(terms) {
                *entry = term;
                self.len += 1;
            }
        }
    }

    impl<T> Deref for Terms<T> {
        type Target = [T];
        fn deref(&self) -> &[T] {
            &self.entries[..self.len]
        }
    }

    /// None yet, with room for some.
    pub(crate) fn terms<T: Copy>(_: usize, zero: T) -> Terms<T> {
        Terms { entries: [zero; ORDERS], len: 0 }
    }
}
