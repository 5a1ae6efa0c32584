//! Where series and dense outputs lie: on the heap, and without `std` in place.
//!
//! On the heap what one phase no longer uses is taken by the next of its kind on the same thread,
//! with what was written in it: to allocate and clear it is a tenth of a short run.

#[cfg(feature = "std")]
pub(super) use heap::{Store, Terms, terms};
#[cfg(not(feature = "std"))]
pub(super) use place::{Store, Terms, terms};

#[cfg(feature = "std")]
mod heap {
    use core::any::Any;
    use core::cell::RefCell;
    use core::ops::{Deref, DerefMut};

    /// How many values a thread keeps for those that come.
    const SPARE: usize = 16;

    std::thread_local! {
        static SPARES: RefCell<Vec<Box<dyn Any>>> = const { RefCell::new(Vec::new()) };
    }

    /// One large value, of which nothing may be read that has not been written.
    pub(crate) struct Store<T: Default + 'static>(Option<Box<T>>);

    impl<T: Default + 'static> Store<T> {
        fn spare() -> Option<Box<T>> {
            SPARES.with_borrow_mut(|spares| {
                let own = spares.iter().rposition(|spare| spare.is::<T>())?;
                spares.swap_remove(own).downcast().ok()
            })
        }
    }

    impl<T: Default + 'static> Default for Store<T> {
        fn default() -> Self {
            Self(Some(Self::spare().unwrap_or_default()))
        }
    }

    impl<T: Default + 'static> Drop for Store<T> {
        fn drop(&mut self) {
            let Some(value) = self.0.take() else { return };
            // A thread that ends has no spares any more.
            let _ = SPARES.try_with(|spares| {
                let mut spares = spares.borrow_mut();
                if spares.len() == SPARE {
                    spares.remove(0);
                }
                spares.push(value);
            });
        }
    }

    impl<T: Default + 'static> Deref for Store<T> {
        type Target = T;
        fn deref(&self) -> &T {
            self.0.as_deref().expect("given back when dropped")
        }
    }

    impl<T: Default + 'static> DerefMut for Store<T> {
        fn deref_mut(&mut self) -> &mut T {
            self.0.as_deref_mut().expect("given back when dropped")
        }
    }

    /// The coefficients of a dense output.
    pub(crate) type Terms<T> = Vec<T>;

    /// None yet, with room for some.
    pub(crate) fn terms<T>(room: usize, _: T) -> Terms<T> {
        Vec::with_capacity(room)
    }

    #[cfg(test)]
    mod tests {
        use super::{SPARE, Store};

        #[derive(Default)]
        struct Large([u8; 3]);

        /// A value of another kind is not taken, nor one that is still in use.
        #[test]
        fn the_next_of_a_kind_takes_what_the_last_gave_back() {
            let first = |store: &Store<Large>| core::ptr::from_ref(&store.0.as_ref().unwrap().0);
            let mut one = Store::<Large>::default();
            one.0.as_mut().unwrap().0[1] = 7;
            let place = first(&one);
            let two = Store::<Large>::default();
            assert_eq!(two.0.as_ref().unwrap().0, [0; 3]);
            drop(one);
            drop(Store::<[u8; 3]>::default());
            let three = Store::<Large>::default();
            assert_eq!((first(&three), three.0.as_ref().unwrap().0), (place, [0, 7, 0]));
            for _ in 0..2 * SPARE {
                drop((Store::<u64>::default(), Store::<i8>::default()));
            }
        }
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
