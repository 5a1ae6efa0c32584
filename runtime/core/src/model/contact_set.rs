//! Which contacts are closed.

/// A set of closed contacts, one bit per entry of [`Layout::contacts`](super::Layout::contacts).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ContactSet(pub u64);

impl ContactSet {
    /// No contact closed: free motion.
    pub const EMPTY: Self = Self(0);

    /// Whether contact `i` is closed.
    pub const fn contains(self, i: usize) -> bool {
        self.0 >> i & 1 == 1
    }

    /// The set with contact `i` closed.
    #[must_use]
    pub const fn with(self, i: usize) -> Self {
        Self(self.0 | 1 << i)
    }

    /// The set with contact `i` open.
    #[must_use]
    pub const fn without(self, i: usize) -> Self {
        Self(self.0 & !(1 << i))
    }

    /// The contacts closed in either set.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The contacts closed in both sets.
    #[must_use]
    pub const fn intersection(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The contacts closed in this set and open in the other.
    #[must_use]
    pub const fn difference(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// The closed contacts in ascending order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..64).filter(move |&i| self.contains(i))
    }

    /// How many contacts are closed.
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// Whether no contact is closed.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }
}
